#include "editor/panels/design_actions.h"

#include "editor/document/clipboard.h"

#include <array>

namespace npsee::editor {
namespace {

using Ui = const PanelContext&;
constexpr auto kExplosion = WorkMode::explosion;

bool hasLayer(Ui ui) { return ui.session.document.hasLayer(); }

void copyLayer(Ui ui) {
  const Document& document = ui.session.document;
  ImGui::SetClipboardText(layerText(document.preset(), document.selected()).c_str());
  ui.session.notices.note = "Copied " + document.layer().name + " to the clipboard, as text.";
}

const std::array kActions{
    Action{"Edit", "Copy layer", "ctrl+C", copyLayer, hasLayer, nullptr, true, kExplosion},
    Action{"Edit", "Cut layer", "ctrl+X", [](Ui ui) { copyLayer(ui); ui.session.took(ui.session.document.deleteLayer()); }, hasLayer, nullptr, false, kExplosion},
    Action{"Edit", "Paste", "ctrl+V", pasteClipboard, nullptr, nullptr, false, kExplosion},
    Action{"Layer", "Show alone", "S", [](Ui ui) {
             const std::string& name = ui.session.document.layer().name;
             if (!ui.session.design.solo.erase(name)) ui.session.design.solo.insert(name);
           }, hasLayer, [](Ui ui) { return hasLayer(ui) && ui.session.design.solo.contains(ui.session.document.layer().name); }, true, kExplosion},
    Action{"Layer", "Show all layers", "shift+S", [](Ui ui) { ui.session.design.solo.clear(); }, [](Ui ui) { return !ui.session.design.solo.empty(); }, nullptr, false, kExplosion},
};

}  // namespace

std::span<const Action> designActions() { return kActions; }

void pasteClipboard(const PanelContext& ui) {
  const char* const text = ImGui::GetClipboardText();
  auto done = paste(ui.session.document, text != nullptr ? text : "");
  if (done) ui.session.notices = {{}, std::move(*done)};
  else ui.session.notices.error = done.error().text();
}

}  // namespace npsee::editor
