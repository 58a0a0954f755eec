#include "editor/panels/panels.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

using render::TemplateView;

struct ViewName {
  TemplateView view;
  const char* name;
};
// The three entries of the thesis's right mouse menu.
constexpr std::array kViews{ViewName{TemplateView::splines, "Splines"}, ViewName{TemplateView::polygons, "Polygons"}, ViewName{TemplateView::surface, "Surface"}};

void drawViewMenu(const PanelContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  if (ImGui::BeginPopupContextItem("template views")) {
    for (const ViewName& entry : kViews) {
      if (ImGui::MenuItem(entry.name, nullptr, ui.session.template_view == entry.view)) ui.session.template_view = entry.view;
      ui.item("item:" + std::string(entry.name));
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void turn(const PanelContext& ui) {
  if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  Session& session = ui.session;
  session.template_yaw_rad -= 0.01 * static_cast<double>(moved.x / ui.scale);
  session.template_pitch_rad = std::clamp(session.template_pitch_rad + 0.01 * static_cast<double>(moved.y / ui.scale), -0.2, 1.5);
}

const char* nameOf(TemplateView view) { return kViews[static_cast<std::size_t>(view)].name; }

}  // namespace

void drawTemplatePanel(const PanelContext& ui) {
  heading(ui, "Template");
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Box box{ImGui::GetCursorScreenPos(), std::max(std::floor(room.x), 1.0f), std::max(std::floor(room.y), 1.0f)};
  ImGui::InvisibleButton("template", ImVec2(box.width, box.height));
  ui.item("template");
  turn(ui);
  if (ui.resting("template", "The shape of the selected layer's launch. Drag turns it, the right button chooses splines, polygons or surface.")) {}
  drawViewMenu(ui);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(box.at, box.end(), ui.theme.background, ui.px(4));
  if (!ui.session.document.hasLayer()) {
    rowText({box.at.x + ui.px(12), box.at.y}, box.width - ui.px(24), box.height, ui.theme.dim, "A layer gives it a shape.");
    return;
  }
  if (const ImTextureID texture = ui.pictures.shape(ui.session, static_cast<int>(box.width), static_cast<int>(box.height)))
    list.AddImageRounded(texture, box.at, box.end(), {0, 1}, {1, 0}, IM_COL32_WHITE, ui.px(4));
  ImGui::PushFont(ui.fonts.small);
  rowText({box.at.x + ui.px(10), box.at.y + ui.px(2)}, box.width - ui.px(20), ui.px(22), ui.theme.dim, ui.session.document.layer().name + ", " + std::string(nameOf(ui.session.template_view)));
  ImGui::PopFont();
}

}  // namespace npsee::editor
