#include "editor/panels/time_overlays.h"

#include "app/render/view.h"
#include "editor/document/past.h"
#include "editor/document/statistics.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

namespace npsee::editor {
namespace {

constexpr std::size_t kSkins = 5, kTrailPoints = 20;
constexpr std::size_t kMostTrails = 500, kMostArrows = 700, kMostSkinned = 900;

/// From the world to the viewport's pixels.
class Projection {
 public:
  Projection(const render::Camera& camera, const Box& box) : box_(box), view_(render::makeView(camera, std::max(1, static_cast<int>(box.width)), std::max(1, static_cast<int>(box.height)))) {}

  std::optional<ImVec2> operator()(float x, float y, float z) const {
    const float* m = view_.view_projection;
    const float w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w < 0.05f) return std::nullopt;
    const float cx = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w, cy = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
    return ImVec2(box_.at.x + (0.5f + 0.5f * cx) * box_.width, box_.at.y + (0.5f - 0.5f * cy) * box_.height);
  }
  /// Pixels of a length at a place, as a radius.
  float radius(float size, float x, float y, float z) const {
    const double depth = view_.depthOf(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    return depth > 0.0 ? static_cast<float>(0.5 * static_cast<double>(size) / (depth * view_.metre_per_pixel)) : 0.0f;
  }

 private:
  Box box_;
  render::View view_;
};

/// Every how-manieth particle is shown, so that no more than `most` are.
std::size_t strideFor(std::size_t count, std::size_t most) { return std::max<std::size_t>(1, (count + most - 1) / most); }

/// Calls `draw(index)` for a fair choice of the particles of the layers that are shown.
template <class Draw>
void forSome(const PanelContext& ui, std::size_t most, const Draw& draw) {
  const Explosion& explosion = *ui.session.explosion();
  const std::size_t stride = strideFor(explosion.particleCount(), most);
  for (const LayerSpan& span : explosion.layers()) {
    if (!ui.session.design.shows(span.name)) continue;
    for (std::size_t i = span.first; i < span.first + span.count; i += stride) draw(i);
  }
}

void drawOnionSkin(const PanelContext& ui, const Projection& project) {
  const Playback& playback = ui.session.playback;
  const double step = roundTime(playback.duration_s, 0.02);
  const auto& frames = ui.session.design.skins.at(ui.session.explosionShared(), ui.session.shownTime(), step * static_cast<double>(kSkins), kSkins);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t k = frames.size(); k-- > 0;) {
    const Frame& frame = frames[k];
    const ImU32 colour = faded(ui.theme.geometry, 0.75f - 0.12f * static_cast<float>(k));
    forSome(ui, kMostSkinned, [&](std::size_t i) {
      if (frame.alive[i] == 0) return;
      const auto at = project(frame.x[i], frame.y[i], frame.z[i]);
      if (at) list.AddCircle(*at, std::clamp(project.radius(frame.size[i], frame.x[i], frame.y[i], frame.z[i]), ui.px(1.5f), ui.px(9)), colour, 8, ui.px(1));
    });
  }
}

void drawTrails(const PanelContext& ui, const Projection& project) {
  const Playback& playback = ui.session.playback;
  const auto& frames = ui.session.design.trails.at(ui.session.explosionShared(), ui.session.shownTime(), roundTime(playback.duration_s, 0.12), kTrailPoints);
  const Frame& now = ui.session.frame();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::array<ImU32, kTrailPoints> colours{};
  for (std::size_t k = 0; k < kTrailPoints; ++k) colours[k] = faded(ui.theme.accent, 0.9f * (1.0f - static_cast<float>(k) / static_cast<float>(kTrailPoints)));
  forSome(ui, kMostTrails, [&](std::size_t i) {
    if (now.alive[i] == 0) return;
    auto from = project(now.x[i], now.y[i], now.z[i]);
    for (std::size_t k = 0; k < frames.size() && from && frames[k].alive[i] != 0; ++k) {
      const auto to = project(frames[k].x[i], frames[k].y[i], frames[k].z[i]);
      if (to) list.AddLine(*from, *to, colours[k], ui.px(1.2f));
      from = to;
    }
  });
}

ImU32 between(ImU32 a, ImU32 b, float share) {
  const ImVec4 u = ImGui::ColorConvertU32ToFloat4(a), v = ImGui::ColorConvertU32ToFloat4(b);
  return ImGui::ColorConvertFloat4ToU32({u.x + share * (v.x - u.x), u.y + share * (v.y - u.y), u.z + share * (v.z - u.z), 0.9f});
}

void drawArrows(const PanelContext& ui, const Projection& project, const FrameFigures& figures) {
  const Frame& frame = ui.session.frame();
  const auto step = static_cast<float>(roundTime(ui.session.playback.duration_s, 0.025));
  const float fastest = std::max(static_cast<float>(figures.fastest_mps), 1e-6f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  forSome(ui, kMostArrows, [&](std::size_t i) {
    if (frame.alive[i] == 0) return;
    const float speed = std::hypot(frame.vx[i], frame.vy[i], frame.vz[i]);
    if (speed < 0.01f * fastest) return;
    const auto from = project(frame.x[i], frame.y[i], frame.z[i]);
    const auto to = project(frame.x[i] + step * frame.vx[i], frame.y[i] + step * frame.vy[i], frame.z[i] + step * frame.vz[i]);
    if (!from || !to) return;
    const ImU32 colour = between(ui.theme.geometry, ui.theme.accent, speed / fastest);
    list.AddLine(*from, *to, colour, ui.px(1.3f));
    const float dx = to->x - from->x, dy = to->y - from->y, length = std::hypot(dx, dy);
    if (length < ui.px(6)) return;
    const float ux = dx / length * ui.px(4), uy = dy / length * ui.px(4);
    list.AddTriangleFilled(*to, {to->x - ux - 0.5f * uy, to->y - uy + 0.5f * ux}, {to->x - ux + 0.5f * uy, to->y - uy - 0.5f * ux}, colour);
  });
}

std::string figure(double value) {
  char text[32];
  std::snprintf(text, sizeof text, std::abs(value) < 1000.0 ? "%.3g" : "%.0f", value);
  return text;
}

std::string joules(double energy) {
  return energy >= 1e9 ? figure(1e-9 * energy) + " GJ" : energy >= 1e6 ? figure(1e-6 * energy) + " MJ" : energy >= 1e3 ? figure(1e-3 * energy) + " kJ" : figure(energy) + " J";
}

/// The figures of the moment at the upper right.
void drawFigures(const PanelContext& ui, const Box& box, const FrameFigures& figures) {
  const Explosion& explosion = *ui.session.explosion();
  const Extent& extent = figures.extent;
  std::vector<std::array<std::string, 2>> lines{{"alive", std::to_string(figures.alive) + " of " + std::to_string(explosion.particleCount())},
                                                {"fastest", figure(figures.fastest_mps) + " m/s"},
                                                {"extent", figure(extent.max.x - extent.min.x) + " x " + figure(extent.max.y - extent.min.y) + " x " + figure(extent.max.z - extent.min.z) + " m"},
                                                {"highest", figure(extent.max.y - ui.session.document.preset().ground_height_m) + " m"}};
  if (figures.massive > 0) lines.insert(lines.begin() + 2, {"kinetic energy", joules(figures.energy_J)});
  if (figures.alive > figures.massive) lines.insert(lines.begin() + 2, {"energy per kg", figure(figures.energy_Jpkg) + " J/kg"});
  if (figures.alive == 0) lines.resize(1);
  if (ui.frame_ms) lines.push_back({"frame", figure(static_cast<double>(*ui.frame_ms)) + " ms"});
  const float width = std::min(ui.px(206), box.width - ui.px(28)), row = ui.px(18), height = row * static_cast<float>(lines.size()) + ui.px(10);
  const ImVec2 at{box.right() - width - ui.px(14), box.at.y + ui.px(ui.session.compare.on() ? 84.0f : 46.0f)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, faded(ui.theme.background, 0.82f), ui.px(4));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const float y = at.y + ui.px(5) + row * static_cast<float>(i);
    ImGui::PushFont(ui.fonts.small);
    rowText({at.x + ui.px(10), y}, 0.46f * width, row, ui.theme.dim, lines[i][0]);
    rowTextRight(at.x + width - ui.px(10), y, row, ui.theme.text, lines[i][1]);
    ImGui::PopFont();
  }
  ui.item("figures", at, {at.x + width, at.y + height});
}

void drawSwitches(const PanelContext& ui, const Box& box) {
  Design& design = ui.session.design;
  struct Switch {
    const char *label, *name, *tip;
    bool* on;
  };
  const Switch switches[] = {{"Onion skin", "onion skin", "Rings where the particles were, five steps back (N)", &design.show_onion},
                             {"Trails", "trails", "The way the particles came (T)", &design.show_trails},
                             {"Speed", "speed", "Arrows of velocity; the fastest are the warmest (V)", &design.show_speed},
                             {"Figures", "figures", "Alive, fastest, energy, extent (K)", &design.show_figures}};
  float width = ui.px(8);
  for (const Switch& each : switches) width += chipWidth(ui, each.label);
  if (width > box.width - ui.px(90)) return;  // a narrow viewport has them in the menu
  const ImVec2 at{box.right() - width - ui.px(14), box.end().y - ui.px(42)};  // the view tools stand above
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + ui.px(28)}, faded(ui.theme.background, 0.82f), ui.px(4));
  float x = at.x + ui.px(4);
  for (const Switch& each : switches) {
    ImGui::SetCursorScreenPos({x, at.y + ui.px(3)});
    if (chip(ui, each.label, each.name, *each.on, each.tip)) *each.on = !*each.on;
    x += chipWidth(ui, each.label);
  }
}

void drawMoment(const PanelContext& ui, const Box& box) {
  const Design& design = ui.session.design;
  if (ui.session.explosion() == nullptr || ui.session.explosion()->particleCount() == 0) return;
  // What is drawn belongs to the edited preset: A has none of it.
  const Compare& compare = ui.session.compare;
  if (compare.on() && compare.mode == Compare::Mode::flip && compare.flipped) return;
  const float left = compare.on() && compare.mode == Compare::Mode::split ? box.at.x + static_cast<float>(compare.split) * box.width : box.at.x;
  const Projection project(ui.session.camera, box);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({left, box.at.y}, box.end(), true);
  if (design.show_trails) drawTrails(ui, project);
  if (design.show_onion) drawOnionSkin(ui, project);
  if (design.show_speed || design.show_figures) {
    const FrameFigures figures = figuresOf(ui.session.frame(), ui.session.explosion()->layers());
    if (design.show_speed) drawArrows(ui, project, figures);
    if (design.show_figures) drawFigures(ui, box, figures);
  }
  list.PopClipRect();
}

}  // namespace

void drawTimeOverlays(const PanelContext& ui, const Box& box) {
  drawMoment(ui, box);
  drawSwitches(ui, box);  // over the arrows
}

}  // namespace npsee::editor
