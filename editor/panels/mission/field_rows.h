#pragma once

#include "editor/panels/mission/panels.h"

#include "sim/world/scenario_table.h"

#include <string>
#include <vector>

namespace npsee::editor {

/// Way from a selected object to the structure that a field belongs to: keys of its parts, and of a list the element.
struct FieldPath {
  ObjectRef ref;
  std::vector<std::pair<std::string_view, int>> steps;  ///< key, and index in a list or -1
};

/// One field of a mission file as a row: what it is of, and what it holds now.
struct FieldRow {
  const world::Struct& table;
  const world::Field& field;
  FieldPath path;
  std::string name;           ///< as scripts call it: "fo1.sensing.location_cep", "duration"
  std::string label;
  world::FieldValue value, initial;
  Box control;                ///< where the widget goes
  std::string idle;           ///< why it has no effect now; empty where it has
  bool changed() const { return value != initial; }
};

/// The structure at the end of a path; empty if it is gone.
TablePart resolve(Scenario& scenario, const FieldPath& path);

/// Draws the row: label, widget, mark when it differs from the default.
void drawFieldRow(const PanelContext& ui, FieldRow row);

/// "max_range" as people read it: "Max range".
std::string fieldLabel(std::string_view key);

/// True if a script wants to type in that row or to use its widgets.
bool askedFor(const PanelContext& ui, const std::string& name);

}  // namespace npsee::editor
