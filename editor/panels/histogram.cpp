#include "editor/panels/row.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace npsee::editor {
namespace {

constexpr std::size_t kBins = 36;

/// What was drawn for a "..._deviation" row, in SI; null where the frames do not tell.
const std::vector<float>* drawnFor(const PanelContext& ui, const Parameter& parameter) {
  const LaunchSample& sample = ui.session.launchSample();
  if (parameter.key == "speed_deviation") return &sample.speed_mps;
  return parameter.key == "size_deviation" ? &sample.size_m : nullptr;
}

std::array<int, kBins> countIn(const std::vector<float>& values, double low, double high) {
  std::array<int, kBins> bins{};
  for (const float value : values) {
    const double share = (static_cast<double>(value) - low) / (high - low);
    ++bins[static_cast<std::size_t>(std::clamp(share * static_cast<double>(kBins), 0.0, static_cast<double>(kBins) - 1.0))];
  }
  return bins;
}

std::string threeDigits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace

void drawHistogram(const PanelContext& ui, const Row& row) {
  const std::vector<float>* values = drawnFor(ui, row.parameter);
  if (values == nullptr || values->size() < 2) return;
  const auto [least, most] = std::ranges::minmax(*values);
  const double low = static_cast<double>(least), high = static_cast<double>(most);
  if (!(high > low)) return;
  const auto bins = countIn(*values, low, high);
  const float height = ui.px(38), words = ui.px(14);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Box box{{row.control.at.x + ui.px(6), at.y + ui.px(2)}, row.control.width - ui.px(6), height - words - ui.px(4)};
  ImGui::Dummy(ImVec2(ImGui::GetContentRegionAvail().x, height));
  ui.item("histogram:" + row.name, box.at, box.end());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = box.width / static_cast<float>(kBins), top = static_cast<float>(*std::ranges::max_element(bins));
  for (std::size_t i = 0; i < kBins; ++i) {
    const float x = box.at.x + static_cast<float>(i) * width, share = static_cast<float>(bins[i]) / top;
    if (bins[i] > 0) list.AddRectFilled({x, box.end().y - std::max(1.0f, share * box.height)}, {x + width - 1.0f, box.end().y}, faded(ui.theme.geometry, 0.75f));
  }
  list.AddLine({box.at.x, box.end().y}, box.end(), ui.theme.line);
  ImGui::PushFont(ui.fonts.small);
  rowText({box.at.x, box.end().y}, 0.5f * box.width, words + ui.px(2), ui.theme.dim, threeDigits(toUnit(row.parameter.unit, low)));
  rowTextRight(box.right(), box.end().y, words + ui.px(2), ui.theme.dim, threeDigits(toUnit(row.parameter.unit, high)) + ' ' + shortUnit(row.parameter.unit));
  ImGui::PopFont();
}

}  // namespace npsee::editor
