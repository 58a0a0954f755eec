// Strips about unsaved work that was found and files that another program changed.

#include "editor/panels/desk/sheets.h"
#include "editor/panels/strip.h"
#include "editor/ui/controls.h"

namespace npsee::editor {
namespace {

void drawFound(const PanelContext& ui) {
  Recovery& recovery = ui.desk.recovery();
  const UnsavedWork& work = recovery.found().front();
  const std::size_t more = recovery.found().size() - 1;
  std::string text = "Unsaved work on \"" + work.name() + "\" is there from an editor that ended without being asked.";
  if (more > 0) text += " After it " + std::to_string(more) + " more.";
  strip(ui, "strip:unsaved", ui.theme.geometry, text, ui.px(252), [&] {
    const bool bring = textButton(ui, "Bring back", "bring back", true);
    if (ui.resting("button:bring back", work.file.empty() ? "It was never saved to a file." : work.file.string())) {}
    ImGui::SameLine();
    const bool away = textButton(ui, "Throw away", "throw away");
    ImGui::SameLine();
    const bool later = textButton(ui, "Later", "later");
    if (bring) recovery.bringBack(ui.session);
    else if (away) recovery.throwAway();
    else if (later) recovery.later();
  });
}

void drawOutside(const PanelContext& ui) {
  const std::string text = ui.session.file().path().filename().string() + " was changed by another program, and here is unsaved work. Read the file again (undo brings your work back), or keep yours and save over it?";
  strip(ui, "strip:outside", ui.theme.accent, text, ui.px(196), [&] {
    if (textButton(ui, "Read again", "read again", true)) ui.session.reloadFile();
    ImGui::SameLine();
    if (textButton(ui, "Keep mine", "keep mine")) ui.session.keepOwn();
  });
}

}  // namespace

void drawDeskNotices(const PanelContext& ui) {
  if (!ui.desk.recovery().found().empty() && !ui.desk.recovery().bringingBack()) drawFound(ui);
  if (ui.session.outside()) drawOutside(ui);
}

}  // namespace npsee::editor
