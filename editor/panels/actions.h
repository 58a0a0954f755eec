#pragma once

#include "editor/ui/context.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace npsee::editor {

/// A command of the menus. Menus, shortcuts and the cheat sheet are all made from one table.
struct Action {
  std::string_view menu, label;
  std::string_view shortcut;  ///< as parseKeyStroke reads it; empty = none
  void (*run)(const PanelContext&);
  bool (*enabled)(const PanelContext&) = nullptr;  ///< null = always
  bool (*checked)(const PanelContext&) = nullptr;  ///< null = no check mark
  bool rule_before = false;                        ///< a line above it in the menu
  std::optional<WorkMode> only = {};               ///< the mode it belongs to; none = both
  bool here(const PanelContext& ui) const { return !only || *only == ui.session.mode(); }
};
std::span<const Action> actions();
/// The shortcut of one of actions() as people read it; empty if it has none.
const std::string& shortcutText(const Action& action);
/// Actions of the mission mode alone; actions() has them too.
std::span<const Action> missionActions();
/// Actions of what lies around the documents: history, palette, library, export, view; actions() has them too.
std::span<const Action> deskActions();

/// The thesis's keys (appendix B.B) and what they move.
struct CameraKeyInfo {
  std::string_view key, doc;
  int move;  ///< a CameraKey
};
std::span<const CameraKeyInfo> cameraKeys();

}  // namespace npsee::editor
