#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace npsee::editor {

/// Named rectangles of what is on the screen, noted as the widgets are drawn. Scripts find their targets here, so that they
/// drive the same widgets as people, with the same events.
class Items {
 public:
  struct Item {
    std::string name;
    ImVec2 min, max;       ///< pixels from the top left, already cut to what is visible
    bool visible = false;  ///< at least half of it is
    ImVec2 centre() const { return {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)}; }
  };

  /// Starts a frame: what was added since becomes what find() sees.
  void beginFrame();
  void add(std::string name, ImVec2 min, ImVec2 max, ImVec2 clip_min, ImVec2 clip_max);
  /// Item of the last whole frame; null if it was not drawn.
  const Item* find(std::string_view name) const;
  const std::vector<Item>& all() const { return shown_; }

  /// Asks for an item to be scrolled into view when it is drawn next; parameter sections open for it.
  void want(std::string name) { wanted_ = std::move(name); }
  const std::string& wanted() const { return wanted_; }

 private:
  std::vector<Item> shown_, drawn_;
  std::string wanted_;
};

}  // namespace npsee::editor
