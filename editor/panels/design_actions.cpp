#include "editor/panels/design_actions.h"

#include "editor/document/clipboard.h"
#include "editor/panels/vary_strip.h"

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

template <bool Design::*member>
void toggle(Ui ui) {
  ui.session.design.*member = !(ui.session.design.*member);
}
template <bool Design::*member>
bool isOn(Ui ui) {
  return ui.session.design.*member;
}

/// Compares so, or no longer. Where there is nothing to compare with yet, the state before the last edit is taken.
void compareAs(Ui ui, Compare::Mode mode) {
  Compare& compare = ui.session.compare;
  if (compare.mode == mode) {
    compare.mode = Compare::Mode::off;
    return;
  }
  if (compare.preset == nullptr && ui.session.document.history().canUndo()) ui.session.compareWithUndo(1);
  if (compare.preset == nullptr) ui.session.keepForComparing();
  compare.mode = mode;
}

void flip(Ui ui) {
  Compare& compare = ui.session.compare;
  if (compare.mode != Compare::Mode::flip) {
    compareAs(ui, Compare::Mode::flip);
    compare.flipped = true;
  } else {
    compare.flipped = !compare.flipped;
  }
}

/// To the next mark of the time line, or the one before.
void goToMark(Ui ui, int by) {
  Playback& playback = ui.session.playback;
  const auto marks = marksOf(ui.session.design.moments);
  constexpr double kHere_s = 1e-9;
  playback.playing = false;
  if (by > 0) {
    for (const Mark& mark : marks)
      if (mark.time_s > playback.time_s + kHere_s) return playback.seek(mark.time_s);
  } else {
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark)
      if (mark->time_s < playback.time_s - kHere_s) return playback.seek(mark->time_s);
  }
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
    Action{"Design", "Randomise layer", "D", [](Ui ui) { varyLayers(ui, ui.session.document.selected()); }, hasLayer, nullptr, false, kExplosion},
    Action{"Design", "Randomise all layers", "alt+D", [](Ui ui) { varyLayers(ui, -1); }, hasLayer, nullptr, false, kExplosion},
    Action{"Design", "Vary seed", "shift+D", varySeed, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Previous mark", "shift+Comma", [](Ui ui) { goToMark(ui, -1); }, nullptr, nullptr, true, kExplosion},
    Action{"Time", "Next mark", "shift+Period", [](Ui ui) { goToMark(ui, 1); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Loop from here", "I", [](Ui ui) { ui.session.playback.beginRange(ui.session.playback.time_s); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Loop to here", "O", [](Ui ui) { ui.session.playback.endRange(ui.session.playback.time_s); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Loop everything", "shift+L", [](Ui ui) { ui.session.playback.clearRange(); }, [](Ui ui) { return ui.session.playback.hasRange(); }, nullptr, false, kExplosion},
    Action{"Time", "Onion skin", "N", toggle<&Design::show_onion>, nullptr, isOn<&Design::show_onion>, true, kExplosion},
    Action{"Time", "Trails", "T", toggle<&Design::show_trails>, nullptr, isOn<&Design::show_trails>, false, kExplosion},
    Action{"Time", "Speed arrows", "V", toggle<&Design::show_speed>, nullptr, isOn<&Design::show_speed>, false, kExplosion},
    Action{"Time", "Figures", "K", toggle<&Design::show_figures>, nullptr, isOn<&Design::show_figures>, false, kExplosion},
    Action{"Design", "Variations", "shift+V", [](Ui ui) {
             if (ui.session.variations.open) ui.session.variations.open = false;
             else ui.session.showVariations();
           }, hasLayer, [](Ui ui) { return ui.session.variations.open; }, false, kExplosion},
    Action{"Design", "Keep state as A", "shift+C", [](Ui ui) { ui.session.keepForComparing(); }, nullptr, nullptr, true, kExplosion},
    Action{"Design", "Compare A and B", "C", [](Ui ui) { compareAs(ui, Compare::Mode::split); }, nullptr, [](Ui ui) { return ui.session.compare.mode == Compare::Mode::split; }, false, kExplosion},
    Action{"Design", "Flip A and B", "X", flip, nullptr, [](Ui ui) { return ui.session.compare.mode == Compare::Mode::flip && ui.session.compare.flipped; }, false, kExplosion},
    Action{"Design", "Swap A and B", "shift+X", [](Ui ui) { ui.session.swapCompared(); }, [](Ui ui) { return ui.session.compare.preset != nullptr; }, nullptr, false, kExplosion},
    Action{"Design", "Unlock all parameters", "", [](Ui ui) { ui.session.design.locked.clear(); }, [](Ui ui) { return !ui.session.design.locked.empty(); }, nullptr, false, kExplosion},
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
