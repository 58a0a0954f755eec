#pragma once

#include "editor/ui/row_frame.h"

#include <npsee/parameters.h>
#include <npsee/units.h>

#include <optional>
#include <string>

namespace npsee::editor {

/// What the pieces of one parameter's row share.
struct Row {
  const Parameter& parameter;
  std::string name;  ///< as scripts call it
  Value value;       ///< SI
  bool changed;      ///< differs from its default
  std::string idle;  ///< why it has no effect now; empty where it has
  Box control;       ///< where the widget goes
};

/// Gives the value to the document, as part of the drag `merge_key`; a refusal is shown.
bool commit(const PanelContext& ui, const Row& row, const Value& value, const std::string& merge_key = {});
/// The same for a value that was typed: the field stays open when it is refused.
void commitTyped(const PanelContext& ui, const Row& row, const Value& value);

/// The row's text field while its whole value is being typed.
void typedRow(const PanelContext& ui, const Row& row);
/// The text field of one number of a row; its value, in SI for `unit`, when it is complete.
std::optional<double> typedNumber(const PanelContext& ui, const std::string& name, const Box& box, Unit unit);
/// Takes a value that a script typed for this row.
void takeScripted(const PanelContext& ui, const Row& row);

void drawRowMenu(const PanelContext& ui, const Row& row);
void colourRow(const PanelContext& ui, const Row& row);
/// A curve or gradient over life: a strip that shows it; a click lists its points below the row.
void lifeRow(const PanelContext& ui, const Row& row);
/// Below a deviation: the values that the particles of the selected layer were really given.
void drawHistogram(const PanelContext& ui, const Row& row);
void drawLifeList(const PanelContext& ui, const Row& row);

/// True for texts of several lines.
bool longText(const Parameter& parameter);
/// False where the default is no sensible thing to go back to (a name).
bool resettable(const Row& row);
/// Unit in at most five signs.
std::string shortUnit(Unit unit);
/// At most 40 signs of a value's text.
std::string clipped(const std::string& text);

}  // namespace npsee::editor
