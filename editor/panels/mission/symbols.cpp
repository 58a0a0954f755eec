#include "editor/panels/mission/panels.h"

namespace npsee::editor {

ImU32 sideColour(const PanelContext& ui, Side side) {
  return side == Side::hostile ? ui.theme.error : side == Side::neutral ? ui.theme.good : ui.theme.geometry;
}

Symbol symbolOf(Side side) { return side == Side::hostile ? Symbol::hostile : side == Side::neutral ? Symbol::neutral : Symbol::friendly; }

void drawSymbol(const PanelContext& ui, Symbol symbol, ImVec2 centre, float size, ImU32 colour, bool destroyed) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float h = 0.5f * size, line = ui.px(1.4f);
  const ImVec2 c{std::floor(centre.x) + 0.5f, std::floor(centre.y) + 0.5f};
  const ImU32 fill = faded(colour, 0.28f);
  switch (symbol) {
    case Symbol::friendly:
      list.AddRectFilled({c.x - h, c.y - 0.7f * h}, {c.x + h, c.y + 0.7f * h}, fill);
      list.AddRect({c.x - h, c.y - 0.7f * h}, {c.x + h, c.y + 0.7f * h}, colour, 0.0f, 0, line);
      break;
    case Symbol::hostile:
      list.AddQuadFilled({c.x, c.y - h}, {c.x + h, c.y}, {c.x, c.y + h}, {c.x - h, c.y}, fill);
      list.AddQuad({c.x, c.y - h}, {c.x + h, c.y}, {c.x, c.y + h}, {c.x - h, c.y}, colour, line);
      break;
    case Symbol::neutral:
      list.AddRectFilled({c.x - 0.8f * h, c.y - 0.8f * h}, {c.x + 0.8f * h, c.y + 0.8f * h}, fill);
      list.AddRect({c.x - 0.8f * h, c.y - 0.8f * h}, {c.x + 0.8f * h, c.y + 0.8f * h}, colour, 0.0f, 0, line);
      break;
    case Symbol::gun:
      list.AddCircleFilled({c.x, c.y}, 0.36f * h, colour, 12);
      list.AddRect({c.x - h, c.y - 0.7f * h}, {c.x + h, c.y + 0.7f * h}, colour, 0.0f, 0, line);
      break;
    case Symbol::observer:
      list.AddTriangleFilled({c.x, c.y - h}, {c.x + h, c.y + 0.8f * h}, {c.x - h, c.y + 0.8f * h}, fill);
      list.AddTriangle({c.x, c.y - h}, {c.x + h, c.y + 0.8f * h}, {c.x - h, c.y + 0.8f * h}, colour, line);
      list.AddCircleFilled({c.x, c.y + 0.25f * h}, 0.2f * h, colour, 8);
      break;
  }
  if (!destroyed) return;
  list.AddLine({c.x - h, c.y - h}, {c.x + h, c.y + h}, ui.theme.error, line);
  list.AddLine({c.x - h, c.y + h}, {c.x + h, c.y - h}, ui.theme.error, line);
}

}  // namespace npsee::editor
