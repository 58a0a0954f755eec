#include "editor/panels/life_editor.h"

#include "editor/document/life_presets.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace npsee::editor {
namespace {

constexpr double kSnap = 0.05;   ///< of life, and of the graph's height
constexpr float kReach = 8.0f;   ///< from a point within which it is taken, unscaled pixels

/// The graph as it stands on the screen.
struct Graph {
  Box box;
  double top = 1.0;  ///< value at its upper edge
  bool flat = false; ///< a gradient: points have no height

  ImVec2 place(double at, double value) const {
    const float y = flat ? box.end().y : box.end().y - static_cast<float>(value / top) * box.height;
    return {box.at.x + static_cast<float>(at) * box.width, y};
  }
  double at(float x) const { return std::clamp(static_cast<double>((x - box.at.x) / box.width), 0.0, 1.0); }
  double value(float y) const { return std::clamp(static_cast<double>((box.end().y - y) / box.height), 0.0, 1.0) * top; }
};

/// The smallest of 1, 2, 4, 5, 10, 20, ... that leaves the curve some room.
double topOf(const Curve& curve) {
  double most = 1.0;
  for (const CurvePoint& point : curve) most = std::max(most, point.value);
  most *= 1.2;
  for (double decade = 1.0;; decade *= 10.0)
    for (const double lead : {1.0, 2.0, 4.0, 5.0})
      if (lead * decade >= most) return lead * decade;
}

double valueOfPoint(const CurvePoint& point) { return point.value; }
double valueOfPoint(const GradientStop&) { return 0.0; }

double snapped(double value, double step, bool snap, double resolution) {
  const double grid = snap ? step : resolution;
  return std::round(value / grid) * grid;
}

/// Rounded so that files stay short: 0.15000000000000002 is 0.15.
double shortened(double value) { return std::round(value * 1e4) / 1e4; }

/// Whether points go to the grid: the switch, turned round while Ctrl is held.
bool snaps(const PanelContext& ui) { return ui.state.life.snap != ImGui::GetIO().KeyCtrl; }

CurvePoint pointAt(const PanelContext& ui, const Graph& graph, const Curve&) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool snap = snaps(ui);
  return {shortened(snapped(graph.at(mouse.x), kSnap, snap, 0.005)), shortened(snapped(graph.value(mouse.y), kSnap * graph.top, snap, 0.005 * graph.top))};
}
GradientStop pointAt(const PanelContext& ui, const Graph& graph, const Gradient& stops) {
  const double at = shortened(snapped(graph.at(ImGui::GetIO().MousePos.x), kSnap, snaps(ui), 0.005));
  Colour colour = stops.empty() ? ui.session.document.layer().colour : colourOf(stops, at);
  for (double* part : {&colour.r, &colour.g, &colour.b}) *part = std::round(*part * 255.0) / 255.0;
  return {at, colour};
}

/// Index of the point under the pointer; -1 if there is none.
template <class Point>
int pointNear(const PanelContext& ui, const Graph& graph, const std::vector<Point>& points) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  float nearest = ui.px(kReach);
  int out = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImVec2 place = graph.place(points[i].at, valueOfPoint(points[i]));
    const float away = graph.flat ? std::abs(place.x - mouse.x) : std::hypot(place.x - mouse.x, place.y - mouse.y);
    if (away > nearest) continue;
    nearest = away;
    out = static_cast<int>(i);
  }
  return out;
}

/// Puts a new point in its place by fraction of life and returns its index.
template <class Point>
int insertPoint(std::vector<Point>& points, const Point& point) {
  const auto at = std::ranges::upper_bound(points, point.at, {}, &Point::at);
  return static_cast<int>(points.insert(at, point) - points.begin());
}

template <class Point>
void removePoint(const PanelContext& ui, const Row& row, std::vector<Point> points, int index) {
  points.erase(points.begin() + index);
  commit(ui, row, points);
  ui.state.life.point = -1;
}

void take(const Graph& graph, const PanelContext& ui, CurvePoint& point) {
  const CurvePoint wanted = pointAt(ui, graph, Curve{});
  point.value = wanted.value;
}
void take(const Graph&, const PanelContext&, GradientStop&) {}

/// What the pointer does with the points. The merge key makes adding and dragging one step.
template <class Point>
void interact(const PanelContext& ui, const Row& row, const Graph& graph, std::vector<Point> points) {
  UiState::Life& life = ui.state.life;
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const int near = pointNear(ui, graph, points);
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    life = {row.name, near, graph.top, life.snap, false, {}};
    if (near < 0 && points.size() < kMaxCurvePoints) {
      life.point = insertPoint(points, pointAt(ui, graph, points));
      life.moving = true;
      commit(ui, row, points, "life:" + row.name);
      return;
    }
  }
  if (life.name != row.name) return;
  if (life.point >= static_cast<int>(points.size())) life.point = -1;
  if (held && life.point >= 0 && (life.moving || ImGui::IsMouseDragging(ImGuiMouseButton_Left, ui.px(3)))) {
    life.moving = true;
    const auto index = static_cast<std::size_t>(life.point);
    const double low = index > 0 ? points[index - 1].at : 0.0, high = index + 1 < points.size() ? points[index + 1].at : 1.0;
    points[index].at = std::clamp(shortened(snapped(graph.at(ImGui::GetIO().MousePos.x), kSnap, snaps(ui), 0.005)), low, high);
    take(graph, ui, points[index]);
    commit(ui, row, points, "life:" + row.name);
    return;
  }
  if (hovered && near >= 0 && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) return removePoint(ui, row, std::move(points), near);
  if (hovered && !held && life.point >= 0 && !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[ImGuiKey_Delete], false)) removePoint(ui, row, std::move(points), life.point);
}

void nameAndDrawPoints(const PanelContext& ui, const Row& row, const Graph& graph, const auto& points) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int near = ImGui::IsItemHovered() || ImGui::IsItemActive() ? pointNear(ui, graph, points) : -1;
  const int chosen = ui.state.life.name == row.name ? ui.state.life.point : -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImVec2 place = graph.place(points[i].at, valueOfPoint(points[i]));
    const bool lit = static_cast<int>(i) == near || static_cast<int>(i) == chosen;
    const float radius = ui.px(lit ? 5.5f : 4.5f);
    if (graph.flat) {
      const float y = graph.box.end().y;
      list.AddTriangleFilled({place.x, y + ui.px(1)}, {place.x - ui.px(6), y + ui.px(11)}, {place.x + ui.px(6), y + ui.px(11)}, lit ? ui.theme.accent : ui.theme.text);
      ui.item("point:" + row.name + '.' + std::to_string(i), {place.x - ui.px(5), y + ui.px(1)}, {place.x + ui.px(5), y + ui.px(11)});
      continue;
    }
    list.AddCircleFilled(place, radius, lit ? ui.theme.text : ui.theme.accent, 16);
    list.AddCircle(place, radius, ui.theme.background, 16);
    ui.item("point:" + row.name + '.' + std::to_string(i), {place.x - radius, place.y - radius}, {place.x + radius, place.y + radius});
  }
}

std::string percent(double share) { return shortNumber(std::round(share * 1000.0) / 10.0) + " %"; }

/// Grid with figures: fractions of life below, values at the left.
void drawGrid(const PanelContext& ui, const Graph& graph) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(graph.box.at, graph.box.end(), ui.theme.background, ui.px(4));
  for (int i = 0; i <= 4; ++i) {
    const double share = 0.25 * i;
    const ImVec2 below = graph.place(share, 0.0), left = graph.place(0.0, share * graph.top);
    list.AddLine({std::floor(below.x) + 0.5f, graph.box.at.y}, {std::floor(below.x) + 0.5f, graph.box.end().y}, faded(ui.theme.line, 0.6f));
    list.AddLine({graph.box.at.x, std::floor(left.y) + 0.5f}, {graph.box.right(), std::floor(left.y) + 0.5f}, faded(ui.theme.line, 0.6f));
  }
  ImGui::PushFont(ui.fonts.small);
  const float height = ImGui::GetFontSize();
  list.AddText({graph.box.at.x + ui.px(4), graph.box.at.y + ui.px(1)}, ui.theme.dim, shortNumber(graph.top).c_str());
  list.AddText({graph.box.at.x + ui.px(4), graph.box.end().y - height - ui.px(1)}, ui.theme.dim, "birth");
  rowTextRight(graph.box.right() - ui.px(4), graph.box.end().y - height - ui.px(1), height, ui.theme.dim, "death");
  ImGui::PopFont();
}

void drawLine(const PanelContext& ui, const Graph& graph, const Curve& curve) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(graph.box.at, graph.box.end(), true);
  list.PathClear();
  list.PathLineTo(graph.place(0.0, curve.empty() ? 1.0 : curve.front().value));
  for (const CurvePoint& point : curve) list.PathLineTo(graph.place(point.at, point.value));
  list.PathLineTo(graph.place(1.0, curve.empty() ? 1.0 : curve.back().value));
  list.PathStroke(curve.empty() ? ui.theme.dim : ui.theme.accent, ImDrawFlags_None, ui.px(1.8f));
  list.PopClipRect();
}

template <class Course>
void drawPresets(const PanelContext& ui, const Row& row, const std::vector<LifePreset<Course>>& presets, const Course& now) {
  const std::string id = "course:" + row.name;
  ImGui::SetNextItemWidth(ui.px(112));
  if (beginChoice(ui, id, "Begin from")) {
    for (const auto& preset : presets) {
      if (ImGui::Selectable(std::string(preset.name).c_str(), preset.course == now, 0, ImVec2(0, ui.px(22)))) commit(ui, row, preset.course);
      ui.item("choice:" + id + '=' + std::string(preset.name));
    }
    ImGui::EndCombo();
  } else {
    ui.item("choice:" + id);
  }
  ImGui::SameLine(0.0f, ui.px(6));
  if (chip(ui, "Snap", "snap:" + row.name, ui.state.life.snap, "Points go to every twentieth; Ctrl turns it round while it is held.")) ui.state.life.snap = !ui.state.life.snap;
  ImGui::SameLine(0.0f, ui.px(2));
  if (chip(ui, "Reverse", "reverse:" + row.name, false, "The same course backwards") && !now.empty()) commit(ui, row, reversed(now));
}

std::string hintFor(const Graph& graph, const Curve& curve) {
  const double at = graph.at(ImGui::GetIO().MousePos.x);
  return "At " + percent(at) + " of life: " + shortNumber(curve.empty() ? 1.0 : std::round(1000.0 * valueOf(curve, at)) / 1000.0) + ". Press to add or drag a point, right button or Delete takes it away, Ctrl snaps.";
}
std::string hintFor(const Graph& graph, const Gradient&) { return "At " + percent(graph.at(ImGui::GetIO().MousePos.x)) + " of life. Press to add or drag a stop, double click changes its colour, right button or Delete takes it away."; }

template <class Point>
void editCourse(const PanelContext& ui, const Row& row, const std::vector<Point>& points, Graph graph, const std::vector<LifePreset<std::vector<Point>>>& presets, const auto& draw) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float below = graph.flat ? ui.px(13) : 0.0f;
  ImGui::SetCursorScreenPos({graph.box.at.x - ui.px(5), graph.box.at.y - ui.px(3)});
  ImGui::InvisibleButton(("graph:" + row.name).c_str(), ImVec2(graph.box.width + ui.px(10), graph.box.height + below + ui.px(6)), ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui.item("graph:" + row.name, graph.box.at, {graph.box.right(), graph.box.end().y + below});
  ui.resting("graph:" + row.name, hintFor(graph, points));
  interact(ui, row, graph, points);
  if constexpr (std::is_same_v<Point, GradientStop>) {
    const int near = pointNear(ui, graph, points);
    if (near >= 0 && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) ui.state.life.picker = row.name + '.' + std::to_string(near);
  }
  draw(graph);
  nameAndDrawPoints(ui, row, graph, points);
  ImGui::SetCursorScreenPos({at.x, graph.box.end().y + below + ui.px(6)});
  drawPresets(ui, row, presets, points);
  ImGui::SetCursorScreenPos({at.x, graph.box.end().y + below + ui.px(36)});
}

}  // namespace

ImU32 packed(const Colour& c) { return ImGui::ColorConvertFloat4ToU32(ImVec4(static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), 1.0f)); }

void drawGradientBar(const PanelContext& ui, const Gradient& gradient, ImVec2 min, ImVec2 max) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  double from = 0.0;
  const auto piece = [&](double to) {
    const ImU32 left = packed(colourOf(gradient, from)), right = packed(colourOf(gradient, to));
    const float x0 = min.x + static_cast<float>(from) * (max.x - min.x), x1 = min.x + static_cast<float>(to) * (max.x - min.x);
    list.AddRectFilledMultiColor({x0, min.y}, {x1, max.y}, left, right, right, left);
    from = to;
  };
  for (const GradientStop& stop : gradient)
    if (stop.at > from) piece(stop.at);
  if (from < 1.0) piece(1.0);
  list.AddRect(min, max, ui.theme.line);
}

void drawLifeEditor(const PanelContext& ui, const Row& row) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float inset = ui.px(8), width = row.control.right() - at.x - 2.0f * inset;
  if (const auto* curve = std::get_if<Curve>(&row.value)) {
    Graph graph{{{at.x + inset, at.y + ui.px(6)}, width, ui.px(118)}, topOf(*curve), false};
    // Under a dragged point the scale stays as it was.
    if (ui.state.life.name == row.name && ui.state.life.moving && ImGui::IsMouseDown(ImGuiMouseButton_Left)) graph.top = ui.state.life.top;
    graph.top = std::min(graph.top, row.parameter.hard.max);
    editCourse(ui, row, *curve, graph, curvePresets(row.parameter), [&](const Graph& g) {
      drawGrid(ui, g);
      drawLine(ui, g, *curve);
    });
  } else if (const auto* gradient = std::get_if<Gradient>(&row.value)) {
    const Graph graph{{{at.x + inset, at.y + ui.px(6)}, width, ui.px(26)}, 1.0, true};
    editCourse(ui, row, *gradient, graph, gradientPresets(row.parameter), [&](const Graph& g) {
      const Gradient shown = gradient->empty() ? Gradient{{0.0, ui.session.document.layer().colour}} : *gradient;
      drawGradientBar(ui, shown, g.box.at, g.box.end());
    });
  }
}

}  // namespace npsee::editor
