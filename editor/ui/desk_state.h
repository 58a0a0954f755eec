#pragma once

#include <string>

namespace npsee::editor {

/// What the widgets around the documents remember from frame to frame.
struct DeskUi {
  /// A sheet takes the place of the left panels until it is closed.
  enum class Sheet { none, history, palette, messages, exports } sheet = Sheet::none;
  int shown_step = -1;     ///< of the history; another one is scrolled into view

  struct Palette {
    std::string word;
    int chosen = 0;
    bool fresh = true;     ///< the field has not had the focus yet
    bool follow = false;   ///< the chosen line is to be scrolled into view
  } palette;

  int tour = -1;           ///< hint shown; -1 = none
};

}  // namespace npsee::editor
