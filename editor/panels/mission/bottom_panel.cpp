#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"

namespace npsee::editor {

void drawBottomPanel(const PanelContext& ui) {
  MissionUi& my = ui.state.mission;
  my.bottom = static_cast<MissionUi::Bottom>(tabStrip(ui, "bottom", {"Events", "Shots", "Ruler"}, static_cast<int>(my.bottom)));
  ImGui::Dummy(ImVec2(1, ui.px(1)));
  switch (my.bottom) {
    case MissionUi::Bottom::log: return drawEventLog(ui);
    case MissionUi::Bottom::shots: return drawShotTable(ui);
    case MissionUi::Bottom::ruler: return drawRulerPanel(ui);
  }
}

}  // namespace npsee::editor
