#include "editor/panels/row.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace npsee::editor {
namespace {

std::string threeFigures(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace

void drawHistogram(const PanelContext& ui, const Row& row) {
  const Histogram* found = row.parameter.scope == Scope::layer && row.idle.empty() ? ui.session.design.histogram(row.parameter.key) : nullptr;
  if (found == nullptr) return;
  const Histogram& histogram = *found;
  const float height = ui.px(38), words = ui.px(14);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Box box{{row.control.at.x + ui.px(6), at.y + ui.px(2)}, row.control.width - ui.px(6), height - words - ui.px(4)};
  ImGui::Dummy(ImVec2(ImGui::GetContentRegionAvail().x, height));
  ui.item("histogram:" + row.name, box.at, box.end());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = box.width / static_cast<float>(Histogram::kBins), top = static_cast<float>(histogram.most);
  for (std::size_t i = 0; i < Histogram::kBins; ++i) {
    const float x = box.at.x + static_cast<float>(i) * width, share = static_cast<float>(histogram.bins[i]) / top;
    if (histogram.bins[i] > 0) list.AddRectFilled({x, box.end().y - std::max(1.0f, share * box.height)}, {x + width - 1.0f, box.end().y}, faded(ui.theme.geometry, 0.75f));
  }
  list.AddLine({box.at.x, box.end().y}, box.end(), ui.theme.line);
  const float mean = std::floor(box.at.x + box.width * static_cast<float>((histogram.mean - histogram.low) / (histogram.high - histogram.low))) + 0.5f;
  list.AddLine({mean, box.at.y}, {mean, box.end().y + ui.px(3)}, ui.theme.text, 1.0f);
  ImGui::PushFont(ui.fonts.small);
  const Unit unit = row.parameter.unit;
  rowText({box.at.x, box.end().y}, 0.3f * box.width, words + ui.px(2), ui.theme.dim, threeFigures(toUnit(unit, histogram.low)));
  const std::string middle = "mean " + threeFigures(toUnit(unit, histogram.mean));
  const float half = 0.5f * ImGui::CalcTextSize(middle.c_str()).x;
  rowTextRight(std::clamp(mean + half, box.at.x + 2.0f * half + ui.px(40), box.right() - ui.px(62)), box.end().y, words + ui.px(2), ui.theme.text, middle);
  rowTextRight(box.right(), box.end().y, words + ui.px(2), ui.theme.dim, threeFigures(toUnit(unit, histogram.high)) + ' ' + shortUnit(unit));
  ImGui::PopFont();
}

}  // namespace npsee::editor
