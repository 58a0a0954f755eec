#include "app/render/view.h"
#include "editor/document/camera_moves.h"
#include "editor/panels/desk/view_tools.h"
#include "editor/panels/panels.h"
#include "editor/panels/time_overlays.h"
#include "editor/panels/compare_view.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <cmath>

namespace npsee::editor {
namespace {

constexpr double kTurn_radpp = 0.006;  ///< orbit, rad per unscaled pixel

void steer(const PanelContext& ui, const Box& box) {
  const ImGuiIO& io = ImGui::GetIO();
  render::Camera& camera = ui.session.camera;
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left))
    camera = orbited(camera, -kTurn_radpp * static_cast<double>(io.MouseDelta.x / ui.scale), kTurn_radpp * static_cast<double>(io.MouseDelta.y / ui.scale));
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Middle))
    camera = panned(camera, static_cast<double>(io.MouseDelta.x / box.height), static_cast<double>(io.MouseDelta.y / box.height));
  if (!ImGui::IsItemHovered() || io.MouseWheel == 0.0f) return;
  const double half = 0.5 * static_cast<double>(box.height);
  const double x = (static_cast<double>(io.MousePos.x - box.at.x) - 0.5 * static_cast<double>(box.width)) / half;
  const double y = 1.0 - static_cast<double>(io.MousePos.y - box.at.y) / half;
  camera = dollied(camera, std::pow(0.88, static_cast<double>(io.MouseWheel)), x, y);
}

/// The world's axes as seen from here, in the lower left corner; above the view tools where a narrow viewport has no room beside them.
void drawCompass(const PanelContext& ui, const Box& box) {
  // The picture's own axes, which have a way of looking straight down too.
  const render::View view = render::makeView(ui.session.camera, std::max(1, static_cast<int>(box.width)), std::max(1, static_cast<int>(box.height)));
  const Box tools = viewToolsBox(ui, box);
  const float below = tools.at.x < box.at.x + ui.px(80) ? tools.at.y : box.end().y;
  const ImVec2 centre{box.at.x + ui.px(40), below - ui.px(40)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const struct { Vec3 axis; const char* name; ImU32 colour; } axes[] = {{{1, 0, 0}, "x", ui.theme.error}, {{0, 1, 0}, "y", ui.theme.good}, {{0, 0, 1}, "z", ui.theme.geometry}};
  list.AddCircleFilled(centre, ui.px(36), faded(ui.theme.background, 0.62f), 32);  // what lies behind has any colour
  ImGui::PushFont(ui.fonts.small);
  for (const auto& [axis, name, colour] : axes) {
    const ImVec2 to{centre.x + ui.px(20) * static_cast<float>(dot(axis, view.right)), centre.y - ui.px(20) * static_cast<float>(dot(axis, view.up))};
    list.AddLine(centre, to, colour, ui.px(1.5f));
    const ImVec2 label{centre.x + ui.px(29) * static_cast<float>(dot(axis, view.right)), centre.y - ui.px(29) * static_cast<float>(dot(axis, view.up))};
    const ImVec2 size = ImGui::CalcTextSize(name);
    list.AddText({std::floor(label.x - 0.5f * size.x), std::floor(label.y - 0.5f * size.y)}, colour, name);
    ui.item(std::string("axis:") + name, {std::min(centre.x, to.x), std::min(centre.y, to.y)}, {std::max(centre.x, to.x) + 1.0f, std::max(centre.y, to.y) + 1.0f});
  }
  ImGui::PopFont();
}

/// Words on the picture, over a shade that keeps them readable.
void drawPlate(const PanelContext& ui, const ImVec2& at, const std::string& text) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - ui.px(8), at.y - ui.px(4)}, {at.x + size.x + ui.px(8), at.y + size.y + ui.px(4)}, faded(ui.theme.background, 0.82f), ui.px(4));
  list.AddText(at, ui.theme.text, text.c_str());
  ImGui::PopFont();
}

void drawOverlays(const PanelContext& ui, const Box& box) {
  drawCompass(ui, box);
  if (const Explosion* explosion = ui.session.explosion(); explosion != nullptr && explosion->particleCount() > 0) {
    const Extent& extent = explosion->extent();
    const auto metres = [](double m) { return shortNumber(std::round(m * 10.0) / 10.0); };
    const double across = std::max(extent.max.x - extent.min.x, extent.max.z - extent.min.z);
    drawPlate(ui, {box.at.x + ui.px(20), box.at.y + ui.px(14)}, metres(across) + " m across, " + metres(extent.max.y - extent.min.y) + " m high; seen from " + metres(length(ui.session.camera.eye - ui.session.camera.target)) + " m");
  }
  // A thin bar tells that a larger effect is being computed; the last good picture stays.
  if (ui.session.compiling()) ImGui::GetWindowDrawList()->AddRectFilled(box.at, {box.right(), box.at.y + ui.px(2)}, ui.theme.accent);
}

}  // namespace

void drawViewport(const PanelContext& ui) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Box box{ImGui::GetCursorScreenPos(), std::max(std::floor(room.x), 1.0f), std::max(std::floor(room.y), 1.0f)};
  ui.session.setAspect(static_cast<double>(box.width / box.height));
  ImGui::InvisibleButton("viewport", ImVec2(box.width, box.height), ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  ui.item("viewport");
  ImGui::SetItemAllowOverlap();  // switches lie on it
  steer(ui, box);
  handleRuler(ui, box);
  ui.resting("viewport", "Left drag turns, middle drag shifts, the wheel moves nearer; F shows everything, F1 lists all keys.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (const ImTextureID texture = ui.pictures.explosion(ui.session, drawnPixels(ui, box.width), drawnPixels(ui, box.height)))
    list.AddImage(texture, box.at, box.end(), {0, 1}, {1, 0});
  else list.AddRectFilled(box.at, box.end(), ui.theme.background);
  drawCompare(ui, box);
  drawOverlays(ui, box);
  drawTimeOverlays(ui, box);
  drawViewTools(ui, box);
}

}  // namespace npsee::editor
