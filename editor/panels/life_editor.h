#pragma once

#include "editor/panels/row.h"

namespace npsee::editor {

/// The graph of a curve, "graph:NAME", or the bar of a gradient, with its points "point:NAME.INDEX": a press adds a point, or takes the one under
/// the pointer, and drags it; the right button or Delete takes it away. Below it the courses to begin from. One drag is one undo step.
void drawLifeEditor(const PanelContext& ui, const Row& row);

/// The colours of a gradient from left to right.
void drawGradientBar(const PanelContext& ui, const Gradient& gradient, ImVec2 min, ImVec2 max);
ImU32 packed(const Colour& colour);

}  // namespace npsee::editor
