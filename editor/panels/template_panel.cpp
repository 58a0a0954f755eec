#include "app/render/template_camera.h"
#include "editor/document/vary.h"
#include "editor/panels/panels.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

using render::TemplateHandle;
using render::TemplateView;

struct ViewName {
  TemplateView view;
  const char* name;
};
// The three entries of the thesis's right mouse menu.
constexpr std::array kViews{ViewName{TemplateView::splines, "Splines"}, ViewName{TemplateView::polygons, "Polygons"}, ViewName{TemplateView::surface, "Surface"}};
constexpr std::array kHandles{std::pair{TemplateHandle::rim, "handle:rim"}, std::pair{TemplateHandle::top, "handle:top"}, std::pair{TemplateHandle::foot, "handle:foot"}};

/// The shape as it stands in the panel.
struct Pose {
  Box box;
  render::TemplateShape shape;
  render::TemplateCamera camera;

  std::pair<double, double> pointer() const {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return {static_cast<double>(mouse.x - box.at.x), static_cast<double>(mouse.y - box.at.y)};
  }
  const Parameter& parameter(TemplateHandle which) const { return *findParameter(Scope::layer, render::parameterOf(which, shape)); }
};

Pose poseOf(const Session& session, const Box& box) {
  const render::TemplateShape shape = render::templateShape(session.design.ease.shown(), 0);
  return {box, shape, render::TemplateCamera(shape, session.template_yaw_rad, session.template_pitch_rad, static_cast<int>(box.width), static_cast<int>(box.height))};
}

void drawViewMenu(const PanelContext& ui) {
  contextMenu(ui, "template views", [&] {
    for (const ViewName& entry : kViews) {
      if (ImGui::MenuItem(entry.name, nullptr, ui.session.template_view == entry.view)) ui.session.template_view = entry.view;
      ui.item("item:" + std::string(entry.name));
    }
    ImGui::Separator();
    if (checkEntry("Particles at t = 0", ui.state.template_particles)) ui.state.template_particles = !ui.state.template_particles;
    ui.item("item:Particles at t = 0");
  });
}

void turn(const PanelContext& ui) {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  Session& session = ui.session;
  session.template_yaw_rad -= 0.01 * static_cast<double>(moved.x / ui.scale);
  session.template_pitch_rad = std::clamp(session.template_pitch_rad + 0.01 * static_cast<double>(moved.y / ui.scale), -0.2, 1.5);
}

/// Drags a handle: its parameter follows the pointer, one drag being one undo step.
void pull(const PanelContext& ui, const Pose& pose) {
  const Parameter& parameter = pose.parameter(ui.state.handle);
  const auto [x, y] = pose.pointer();
  const double value = threeDigits(parameter, pose.camera.dragged(pose.shape, ui.state.handle, x, y));
  if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0f)) return;
  ui.session.took(ui.session.document.assign(parameter, value, "template handle"));
  // A held handle stays under the pointer.
  ui.session.design.ease.update(ui.session.document.snapshot(), ui.session.document.selected(), 0.0, true);
}

/// Where the particles start (t = 0), as dots at the shape's foot: their places in the region, in the proportions in which the foot shows it.
void drawParticles(const PanelContext& ui, const Pose& pose) {
  const LaunchProbe& probe = ui.session.design.probe;
  const double across = std::max(render::extentOfTemplateFoot(pose.shape.foot_x), 1e-6), along = std::max(render::extentOfTemplateFoot(pose.shape.foot_z), 1e-6);
  const double upward = 0.5 * (pose.shape.foot_x / across + pose.shape.foot_z / along);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(pose.box.at, pose.box.end(), true);
  constexpr std::size_t kMostDots = 1200;  // more would be one blot
  const std::size_t count = std::min(probe.x_m.size(), kMostDots);
  const float half = std::max(1.0f, ui.px(count > 400 ? 0.8f : 1.2f));
  const ImU32 colour = faded(ui.theme.text, 0.8f);
  for (std::size_t i = 0; i < count; ++i) {
    const double y = std::clamp(upward * static_cast<double>(probe.y_m[i]), -pose.shape.height, pose.shape.height);
    Vec3 point = pose.shape.frame({pose.shape.foot_x * static_cast<double>(probe.x_m[i]) / across, y, pose.shape.foot_z * static_cast<double>(probe.z_m[i]) / along});
    // The sphere's region is shown on the base plane below it.
    if (pose.shape.ball) point.y = 0.0;
    const auto at = pose.camera.project(point);
    const ImVec2 centre{pose.box.at.x + static_cast<float>(at.x), pose.box.at.y + static_cast<float>(at.y)};
    list.AddRectFilled({centre.x - half, centre.y - half}, {centre.x + half, centre.y + half}, colour);
  }
  list.PopClipRect();
  ui.item("template:particles", pose.box.at, pose.box.end());
}

/// The value beside the pointer while a handle is held or pointed at.
void drawValue(const PanelContext& ui, const Pose& pose, TemplateHandle which) {
  const Parameter& parameter = pose.parameter(which);
  const std::string text = std::string(parameter.label) + "  " + shortNumber(toUnit(parameter.unit, std::get<double>(ui.session.document.value(parameter)))) + ' ' + std::string(symbol(parameter.unit));
  const float inset = ui.px(10), height = ui.px(24);
  ImGui::GetWindowDrawList()->AddRectFilled({pose.box.at.x + ui.px(4), pose.box.end().y - height - ui.px(4)}, {pose.box.right() - ui.px(4), pose.box.end().y - ui.px(4)}, ui.theme.raised, ui.px(4));
  rowText({pose.box.at.x + inset, pose.box.end().y - height - ui.px(4)}, pose.box.width - 2.0f * inset, height, ui.theme.accent, text);
}

void interact(const PanelContext& ui, const Pose& pose) {
  const bool held = ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left), hovered = ImGui::IsItemHovered();
  for (const auto& [which, name] : kHandles) {
    if (!pose.shape.hasHandle(which)) continue;
    const auto at = pose.camera.project(pose.shape.handle(which, pose.camera.azimuth()));
    const ImVec2 centre{pose.box.at.x + static_cast<float>(at.x), pose.box.at.y + static_cast<float>(at.y)};
    ui.item(name, {centre.x - ui.px(5), centre.y - ui.px(5)}, {centre.x + ui.px(5), centre.y + ui.px(5)});
  }
  const auto [x, y] = pose.pointer();
  if (ImGui::IsItemActivated() || (!held && hovered)) ui.state.handle = pose.camera.handleNear(pose.shape, x, y, static_cast<double>(ui.px(10)));
  else if (!held) ui.state.handle = TemplateHandle::none;
  if (ui.state.handle != TemplateHandle::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (held && ui.state.handle == TemplateHandle::none) turn(ui);
  if (held && ui.state.handle != TemplateHandle::none && pose.shape.hasHandle(ui.state.handle)) pull(ui, pose);
}

}  // namespace

void drawTemplatePanel(const PanelContext& ui) {
  heading(ui, "Template");
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Box box{ImGui::GetCursorScreenPos(), std::max(std::floor(room.x), 1.0f), std::max(std::floor(room.y), 1.0f)};
  ImGui::InvisibleButton("template", ImVec2(box.width, box.height));
  ui.item("template");
  ui.resting("template", "The shape of the selected layer's launch. Drag its dots to change it, drag beside them to turn it; the right button chooses the view.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(box.at, box.end(), ui.theme.background, ui.px(4));
  if (!ui.session.document.hasLayer()) {
    rowText({box.at.x + ui.px(12), box.at.y}, box.width - ui.px(24), box.height, ui.theme.dim, "A layer gives it a shape.");
    return;
  }
  if (ui.session.design.ease.shown().layers.empty()) return;  // a layer that this frame added is shown by the next
  interact(ui, poseOf(ui.session, box));
  drawViewMenu(ui);
  if (const ImTextureID texture = ui.pictures.shape(ui.session, ui.state.handle, static_cast<int>(box.width), static_cast<int>(box.height)))
    list.AddImageRounded(texture, box.at, box.end(), {0, 1}, {1, 0}, IM_COL32_WHITE, ui.px(4));
  ImGui::PushFont(ui.fonts.small);
  rowText({box.at.x + ui.px(10), box.at.y + ui.px(2)}, box.width - ui.px(20), ui.px(22), ui.theme.dim, ui.session.document.layer().name + ", " + kViews[static_cast<std::size_t>(ui.session.template_view)].name);
  const Pose now = poseOf(ui.session, box);
  if (ui.state.template_particles) drawParticles(ui, now);
  if (ui.state.handle != TemplateHandle::none && now.shape.hasHandle(ui.state.handle)) drawValue(ui, now, ui.state.handle);
  ImGui::PopFont();
}

}  // namespace npsee::editor
