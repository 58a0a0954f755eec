#include "editor/panels/life_editor.h"
#include "editor/panels/row.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace npsee::editor {
namespace {

Colour unpacked(const float* rgb) {
  // Whole 255ths, so that the file can say #rrggbb.
  const auto byte = [](float v) { return std::round(static_cast<double>(std::clamp(v, 0.0f, 1.0f)) * 255.0) / 255.0; };
  return {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
}

/// A swatch "NAME" that opens a picker beside it. Returns the colour while it changes.
std::optional<Colour> swatch(const PanelContext& ui, const std::string& name, const Colour& colour, const Box& box) {
  ImGui::SetCursorScreenPos({box.at.x, box.at.y + ui.px(3)});
  const float height = box.height - ui.px(6);
  if (ImGui::InvisibleButton(name.c_str(), ImVec2(box.width, height)) || name == "swatch:" + ui.state.life.picker) {
    ImGui::OpenPopup((name + "?").c_str());
    ui.state.life.picker.clear();
  }
  ui.item(name);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, packed(colour), ui.px(4));
  ImGui::GetWindowDrawList()->AddRect(min, max, ImGui::IsItemHovered() ? ui.theme.text : ui.theme.line, ui.px(4));
  if (!ImGui::BeginPopup((name + "?").c_str())) return std::nullopt;
  float rgb[] = {static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b)};
  ImGui::SetNextItemWidth(ui.px(200));
  const bool changed = ImGui::ColorPicker3("##picker", rgb, ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview | ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoLabel);
  ui.item(name + ".picker");
  ImGui::EndPopup();
  return changed ? std::optional(unpacked(rgb)) : std::nullopt;
}

void drawCurve(const PanelContext& ui, const Curve& curve, ImVec2 min, ImVec2 max) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  double top = 1.0;
  for (const CurvePoint& point : curve) top = std::max(top, point.value);
  const auto place = [&](double at, double value) {
    return ImVec2(min.x + static_cast<float>(at) * (max.x - min.x), max.y - 2.0f - static_cast<float>(value / top) * (max.y - min.y - 4.0f));
  };
  list.PathClear();
  list.PathLineTo(place(0.0, curve.front().value));
  for (const CurvePoint& point : curve) list.PathLineTo(place(point.at, point.value));
  list.PathLineTo(place(1.0, curve.back().value));
  list.PathStroke(ui.theme.accent, ImDrawFlags_None, ui.px(1.5f));
  for (const CurvePoint& point : curve) list.AddCircleFilled(place(point.at, point.value), ui.px(2.5f), ui.theme.accent, 10);
}

bool unfolded(const PanelContext& ui, const Row& row) { return ui.state.unfolded.contains(row.name); }

/// One point's line: fraction of life, its value, a button that deletes it.
template <class Point>
void pointRow(const PanelContext& ui, const Row& row, std::vector<Point>& points, std::size_t index, bool& deleted) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ui.px(26), gap = ui.px(6), x = row.control.at.x, width = 0.5f * (row.control.width - gap);
  const std::string name = row.name + '.' + std::to_string(index);
  const Box first{{x, at.y}, width, height}, second{{x + width + gap, at.y}, width, height};
  // A point stays between its neighbours.
  const double low = index > 0 ? points[index - 1].at : 0.0, high = index + 1 < points.size() ? points[index + 1].at : 1.0;
  auto moved = typedNumber(ui, name + ".at", first, Unit::none);
  const bool typed = moved.has_value();
  if (!moved && !typingIn(ui, name + ".at")) moved = numberField(ui, name + ".at", {points[index].at, {0, 1}, {low, high}}, first, "at");
  if (moved) {
    points[index].at = std::clamp(*moved, low, high);
    typed ? commitTyped(ui, row, points) : void(commit(ui, row, points, name + ".at"));
  }
  if constexpr (std::is_same_v<Point, CurvePoint>) {
    auto value = typedNumber(ui, name + ".value", second, Unit::none);
    const bool entered = value.has_value();
    const Range span = row.parameter.slider;
    if (!value && !typingIn(ui, name + ".value")) value = numberField(ui, name + ".value", {points[index].value, span, row.parameter.hard}, second, "x");
    if (value) {
      points[index].value = *value;
      entered ? commitTyped(ui, row, points) : void(commit(ui, row, points, name + ".value"));
    }
  } else if (const auto colour = swatch(ui, "swatch:" + name, points[index].colour, second)) {
    points[index].colour = *colour;
    commit(ui, row, points, name + ".colour");
  }
  ImGui::SetCursorScreenPos({row.control.right() + ui.px(2), at.y + ui.px(4)});
  deleted = iconButton(ui, Icon::cross, "delete:" + name, "Delete this point", false, 18);
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(1, height));
}

template <class Point>
void pointList(const PanelContext& ui, const Row& row, std::vector<Point> points, const Point& fallback) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool deleted = false;
    pointRow(ui, row, points, i, deleted);
    if (!deleted) continue;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
    commit(ui, row, points);
    return;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({row.control.at.x, at.y});
  if (points.size() < kMaxCurvePoints && textButton(ui, "Add point", "add:" + row.name)) {
    Point added = points.empty() ? fallback : points.back();
    added.at = points.empty() ? 0.0 : 1.0;
    if (points.size() >= 2 && points.back().at >= 1.0) {
      // Between the last two, where there is room.
      added.at = 0.5 * (points[points.size() - 2].at + points.back().at);
      points.insert(points.end() - 1, added);
    } else {
      points.push_back(added);
    }
    commit(ui, row, points);
  }
  ImGui::SetCursorScreenPos({at.x, at.y + ui.px(30)});
  ImGui::Dummy(ImVec2(1, 1));
}

}  // namespace

void colourRow(const PanelContext& ui, const Row& row) {
  const Colour colour = std::get<Colour>(row.value);
  const Box box{row.control.at, ui.px(64), row.control.height};
  if (const auto changed = swatch(ui, "colour:" + row.name, colour, box)) commit(ui, row, *changed, row.name);
  const Box text{{box.right() + ui.px(8), row.control.at.y}, row.control.width - box.width - ui.px(8), row.control.height};
  ImGui::SetCursorScreenPos(text.at);
  const bool clicked = ImGui::InvisibleButton(("value:" + row.name).c_str(), ImVec2(text.width, text.height));
  ui.item("value:" + row.name);
  ImGui::PushFont(ui.fonts.numbers);
  rowText(text.at, text.width, text.height, row.changed ? ui.theme.accent : ui.theme.text, valueText(row.parameter, row.value));
  ImGui::PopFont();
  if (clicked) beginTyping(ui, row.name, valueText(row.parameter, row.value));
}

void lifeRow(const PanelContext& ui, const Row& row) {
  ImGui::SetCursorScreenPos({row.control.at.x, row.control.at.y + ui.px(3)});
  const bool clicked = ImGui::InvisibleButton(("life:" + row.name).c_str(), ImVec2(row.control.width, row.control.height - ui.px(6)));
  ui.item("life:" + row.name);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, ImGui::IsItemHovered() ? ui.theme.raised : ui.theme.background, ui.px(4));
  const Gradient* gradient = std::get_if<Gradient>(&row.value);
  const Curve* curve = std::get_if<Curve>(&row.value);
  if (gradient != nullptr && !gradient->empty()) drawGradientBar(ui, *gradient, min, max);
  else if (curve != nullptr && !curve->empty()) drawCurve(ui, *curve, min, max);
  else rowText({row.control.at.x + ui.px(8), row.control.at.y}, row.control.width, row.control.height, ui.theme.dim, gradient != nullptr ? "initial colour throughout" : "constant");
  if (!clicked) return;
  if (!ui.state.unfolded.erase(row.name)) ui.state.unfolded.insert(row.name);
}

void drawLifeList(const PanelContext& ui, const Row& row) {
  if (!unfolded(ui, row)) return;
  drawLifeEditor(ui, row);
  if (const auto* curve = std::get_if<Curve>(&row.value)) pointList(ui, row, *curve, CurvePoint{});
  if (const auto* gradient = std::get_if<Gradient>(&row.value)) pointList(ui, row, *gradient, GradientStop{0.0, ui.session.document.layer().colour});
}

}  // namespace npsee::editor
