#include "editor/panels/mission/panels.h"
#include "editor/panels/mission/plan_view.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace npsee::editor {
namespace {

constexpr float kCell_px = 5.0f;  ///< of the relief, unscaled

ImU32 mixed(ImU32 a, ImU32 b, float share) {
  const ImVec4 p = ImGui::ColorConvertU32ToFloat4(a), q = ImGui::ColorConvertU32ToFloat4(b);
  return ImGui::ColorConvertFloat4ToU32({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y), p.z + share * (q.z - p.z), 1.0f});
}

ImU32 groundColour(const PanelContext& ui, const GroundMap& map, std::size_t at) {
  const bool dark = ui.theme.dark;
  if (map.sea[at] != 0) return dark ? IM_COL32(34, 52, 66, 255) : IM_COL32(183, 205, 219, 255);
  // Low ground is green, high ground brown; the light of the north-west on top.
  const ImU32 low = dark ? IM_COL32(50, 58, 46, 255) : IM_COL32(205, 214, 190, 255), high = dark ? IM_COL32(84, 74, 60, 255) : IM_COL32(226, 214, 192, 255);
  const ImU32 base = mixed(low, high, map.height[at]);
  const float light = map.shade[at];
  return light < 0.5f ? mixed(base, dark ? IM_COL32(12, 13, 15, 255) : IM_COL32(120, 116, 108, 255), (0.5f - light) * 1.5f) : mixed(base, dark ? IM_COL32(176, 168, 150, 255) : IM_COL32(255, 255, 250, 255), (light - 0.5f) * 1.1f);
}

void dashed(ImDrawList& list, const ImVec2& a, const ImVec2& b, ImU32 colour, float width, float dash) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  const int count = std::min(static_cast<int>(length / dash), 400);
  for (int i = 0; i < count; i += 2) {
    const float s = static_cast<float>(i) / static_cast<float>(count), e = std::min(1.0f, static_cast<float>(i + 1) / static_cast<float>(count));
    list.AddLine({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}, {a.x + e * (b.x - a.x), a.y + e * (b.y - a.y)}, colour, width);
  }
}

void circle(ImDrawList& list, const PlanView& view, const Place& centre, double radius_m, ImU32 colour, float width) {
  const float radius = static_cast<float>(radius_m / view.metre_per_px);
  // Circles far beyond the picture would need endless segments.
  if (radius > 2.0f && radius < 40000.0f) list.AddCircle(view.pixel(centre), radius, colour, std::clamp(static_cast<int>(radius), 24, 256), width);
}

/// Reach of the selected gun or battery, as their weapon gives it; of all of them with the range rings on.
void drawReach(const PanelContext& ui, const PlanView& view) {
  const MissionSession& mission = ui.session.mission();
  const Recording& recording = *mission.recording();
  const ObjectRef& selected = mission.document.selected();
  const std::vector<double>& reach = mission.reach();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const GunRecord& gun : recording.guns) {
    const auto battery = static_cast<std::size_t>(gun.battery);
    const bool chosen = selected == ObjectRef{ObjectRef::Kind::gun, gun.id} || (battery < reach.size() && selected == ObjectRef{ObjectRef::Kind::battery, recording.scenario.batteries[battery].id});
    if (!chosen && !mission.view.overlays.range_rings) continue;
    if (battery < reach.size() && reach[battery] > 0.0) circle(list, view, {gun.muzzle_m.x, gun.muzzle_m.z}, reach[battery], faded(ui.theme.geometry, 0.5f), 1.0f);
    // Where the tube points.
    const double azimuth = gun.lineAt(mission.clock.time_s).first, length = 26.0 * view.metre_per_px * static_cast<double>(ui.scale);
    const ImVec2 from = view.pixel({gun.muzzle_m.x, gun.muzzle_m.z});
    list.AddLine(from, view.pixel({gun.muzzle_m.x + length * std::sin(azimuth), gun.muzzle_m.z - length * std::cos(azimuth)}), ui.theme.geometry, ui.px(1.5f));
  }
  if (const int observer = mission.selectedObserver(); observer >= 0) {
    const Vec3 eye = recording.observerEye(static_cast<std::size_t>(observer), mission.clock.time_s);
    for (const ObserverSetup& setup : recording.scenario.observers)
      if (setup.id == selected.id) circle(list, view, {eye.x, eye.z}, setup.max_range_m, faded(ui.theme.geometry, 0.45f), 1.0f);
  }
}

void drawShells(const PanelContext& ui, const PlanView& view) {
  const MissionSession& mission = ui.session.mission();
  const Recording& recording = *mission.recording();
  const double t = mission.clock.time_s;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<int> shells;
  recording.burstsSince(t, 1e9, shells);
  for (const int i : shells) {
    const ShellRecord& shell = recording.shells[static_cast<std::size_t>(i)];
    const ImVec2 at = view.pixel({shell.burst_m.x, shell.burst_m.z});
    if (!view.inside(at, ui.px(6))) continue;
    const bool fresh = t - shell.burst_s < 4.0;
    const float r = ui.px(fresh ? 4.5f : 2.5f);
    const ImU32 colour = fresh ? ui.theme.accent : faded(ui.theme.accent, 0.55f);
    list.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, colour, ui.px(1.3f));
    list.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, colour, ui.px(1.3f));
  }
  recording.shellsInAir(t, shells);
  for (const int i : shells) {
    const ShellRecord& shell = recording.shells[static_cast<std::size_t>(i)];
    const ImVec2 from = view.pixel({shell.muzzle_m.x, shell.muzzle_m.z}), to = view.pixel({shell.burst_m.x, shell.burst_m.z});
    const Vec3 now = shell.at(t);
    const ImVec2 at = view.pixel({now.x, now.z});
    dashed(list, at, to, faded(ui.theme.accent, 0.7f), ui.px(1), ui.px(4));
    list.AddLine(from, at, faded(ui.theme.accent, 0.8f), ui.px(1.3f));
    list.AddCircleFilled(at, ui.px(3), ui.theme.accent, 12);
  }
}

/// Where an observer believes his contacts to be, joined with where they are.
void drawBeliefs(const PanelContext& ui, const PlanView& view) {
  const MissionSession& mission = ui.session.mission();
  const Recording& recording = *mission.recording();
  const double t = mission.clock.time_s;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int only = mission.selectedObserver();
  for (std::size_t o = 0; o < recording.observers.size(); ++o) {
    if (only >= 0 && static_cast<int>(o) != only) continue;
    std::set<int> told;
    const auto& beliefs = recording.observers[o].beliefs;
    for (auto belief = beliefs.rbegin(); belief != beliefs.rend(); ++belief) {
      if (belief->t_s > t || belief->target < 0 || !told.insert(belief->target).second) continue;
      const Vec3 real = recording.vehiclePlace(static_cast<std::size_t>(belief->target), t);
      const ImVec2 a = view.pixel({belief->believed_m.x, belief->believed_m.z}), b = view.pixel({real.x, real.z});
      if (!belief->seen || std::hypot(a.x - b.x, a.y - b.y) < ui.px(3) || !view.inside(a, 200.0f)) continue;
      const ImU32 colour = faded(ui.theme.text, 0.75f);
      dashed(list, a, b, colour, ui.px(1), ui.px(3));
      list.AddCircle(a, ui.px(4), colour, 16, ui.px(1.2f));
    }
  }
}

void drawGoals(const PanelContext& ui, const PlanView& view) {
  const MissionSession& mission = ui.session.mission();
  const ObjectRef& selected = mission.document.selected();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const VehicleSetup& vehicle : mission.document.scenario().vehicles) {
    if (selected != ObjectRef{ObjectRef::Kind::vehicle, vehicle.id} || vehicle.goals.empty()) continue;
    ImVec2 from = view.pixel(vehicle.at);
    for (const Place& goal : vehicle.goals) {
      const ImVec2 to = view.pixel(goal);
      dashed(list, from, to, ui.theme.good, ui.px(1), ui.px(4));
      list.AddCircle(to, ui.px(4), ui.theme.good, 16, ui.px(1.3f));
      from = to;
    }
  }
  for (const VehicleGroup& group : mission.document.scenario().groups)
    if (selected == ObjectRef{ObjectRef::Kind::group, group.id}) list.AddRect(view.pixel(group.from), view.pixel(group.to), ui.theme.accent, 0.0f, 0, ui.px(1));
}

}  // namespace

void drawGround(const PanelContext& ui, const PlanView& view) {
  const Terrain& terrain = ui.session.mission().recording()->terrain;
  MissionUi::Plan& plan = ui.state.mission.plan;
  const Place from = view.place(view.box.at), to = view.place(view.box.end());
  // Recordings of one mission share their ground.
  if (!plan.map_of || plan.map_of->heights().data() != terrain.heights().data() || plan.map_from != from || plan.map_to != to) {
    plan.map_of = terrain;
    plan.map_from = from;
    plan.map_to = to;
    const float cell = ui.px(kCell_px);
    plan.map = groundMap(terrain, from, to, std::clamp(static_cast<int>(view.box.width / cell), 2, 200), std::clamp(static_cast<int>(view.box.height / cell), 2, 200));
  }
  const GroundMap& map = plan.map;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImU32> colours(map.shade.size());
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = groundColour(ui, map, i);
  const auto row = static_cast<std::size_t>(map.columns);
  const float step_x = view.box.width / static_cast<float>(map.columns - 1), step_y = view.box.height / static_cast<float>(map.rows - 1);
  // Only the world is ground; beyond it the plan is empty.
  list.PushClipRect(view.pixel({0.0, 0.0}), view.pixel({terrain.sizeX(), terrain.sizeZ()}), true);
  for (int r = 0; r + 1 < map.rows; ++r)
    for (int c = 0; c + 1 < map.columns; ++c) {
      const auto at = static_cast<std::size_t>(r * map.columns + c);
      const ImVec2 p{view.box.at.x + static_cast<float>(c) * step_x, view.box.at.y + static_cast<float>(r) * step_y};
      list.AddRectFilledMultiColor(p, {p.x + step_x, p.y + step_y}, colours[at], colours[at + 1], colours[at + 1 + row], colours[at + row]);
    }
  const ImU32 line = ui.theme.dark ? IM_COL32(214, 190, 150, 62) : IM_COL32(120, 84, 40, 90), strong = ui.theme.dark ? IM_COL32(226, 204, 166, 120) : IM_COL32(110, 74, 30, 160);
  for (const GroundMap::Segment& segment : map.contours) list.AddLine(view.pixel(segment.a), view.pixel(segment.b), segment.coast ? ui.theme.geometry : segment.index ? strong : line, segment.index || segment.coast ? ui.px(1.2f) : 1.0f);
  list.PopClipRect();
}

void drawPlanLines(const PanelContext& ui, const PlanView& view) {
  const MissionSession& mission = ui.session.mission();
  drawReach(ui, view);
  drawGoals(ui, view);
  if (mission.view.overlays.beliefs) drawBeliefs(ui, view);
  drawShells(ui, view);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Ruler& ruler = mission.ruler;
  const ImVec2 a = view.pixel({ruler.from.x, ruler.from.z}), b = view.pixel({ruler.to.x, ruler.to.z});
  if (ruler.complete()) list.AddLine(a, b, ui.theme.accent, ui.px(1.5f));
  if (ruler.points > 0) list.AddCircleFilled(a, ui.px(3), ui.theme.accent, 12);
  if (ruler.points > 1) list.AddCircleFilled(b, ui.px(3), ui.theme.accent, 12);
}

}  // namespace npsee::editor
