#pragma once

#include "editor/ui/context.h"
#include "editor/ui/slider.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace npsee::editor {

/// A parameter's row: label, widget, mark to go back to the default; the same for presets and missions.
struct RowFrame {
  std::string name;      ///< as scripts call it; the label is "row:NAME"
  ImVec2 at;
  float width = 0.0f, height = 0.0f;
  Box control;           ///< where the widget goes
};
/// Draws the label and says where the widget goes. `height` is unscaled. The label is the last item when it returns.
RowFrame beginRow(const PanelContext& ui, const std::string& name, const std::string& label, float height = 26.0f);
/// Draws the mark "button:reset:NAME" if the value can go back to `initial` (empty: it cannot), dims a row that has no effect, which stays
/// usable, and moves on to the next row. True if the mark was clicked.
bool endRow(const PanelContext& ui, const RowFrame& row, const std::string& initial, bool idle);

/// Help about a row. Stands left of the panel, so that it hides neither the row nor its neighbours.
struct RowHelp {
  std::string title, doc;
  std::vector<std::string> lines;  ///< dimmed: limits, values
  std::string idle;                ///< why the row has no effect; empty where it has
};
void drawRowHelp(const PanelContext& ui, const RowFrame& row, const RowHelp& help);

// Widgets of a row. They return what the person chose and change nothing themselves.

/// A switch, "toggle:NAME". True if it was clicked.
bool switchWidget(const PanelContext& ui, const std::string& name, bool on, bool changed, const Box& box);
/// A list of keys with what is shown for them, "choice:NAME" and "choice:NAME=KEY". The key that was chosen.
using Choices = std::vector<std::pair<std::string, std::string>>;
std::optional<std::string> choiceWidget(const PanelContext& ui, const std::string& name, const std::string& now, const Choices& choices, bool changed, const Box& box);
/// A text that is typed anew after a click, "text:NAME"; wrapped where the box is high. `empty` is shown, dimmed, instead of no text.
/// True if it was clicked.
bool textWidget(const PanelContext& ui, const std::string& name, const std::string& text, const std::string& empty, ImU32 colour, const Box& box);

}  // namespace npsee::editor
