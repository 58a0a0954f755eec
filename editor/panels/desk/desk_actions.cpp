#include "editor/panels/actions.h"
#include "editor/panels/desk/sheets.h"
#include "editor/panels/desk/view_tools.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

using Ui = const PanelContext&;
using Sheet = DeskUi::Sheet;

template <Sheet sheet>
void flip(Ui ui) {
  DeskUi& my = ui.state.desk;
  my.sheet = my.sheet == sheet ? Sheet::none : sheet;
  my.palette = {};
  ui.state.show_help = false;
  my.shown_step = -1;
}
template <Sheet sheet>
bool shows(Ui ui) {
  return ui.state.desk.sheet == sheet;
}

template <ExportKind kind>
void exportAs(Ui ui) {
  openExport(ui, kind);
}

template <std::size_t index>
void keep(Ui ui) {
  keepBookmark(ui, index);
}
template <std::size_t index>
void go(Ui ui) {
  goToBookmark(ui, index);
}

void flipRuler(Ui ui) {
  ui.state.desk.view.ruler = !ui.state.desk.view.ruler;
  ui.state.desk.view.points = 0;
}

template <std::size_t wish>
void drawAs(Ui ui) {
  ui.state.desk.view.quality = kQualityWishes[wish];
}
template <std::size_t wish>
bool drawnAs(Ui ui) {
  return ui.state.desk.view.quality == kQualityWishes[wish];
}

/// In thirds of a stop, as cameras do; 0 goes back to the usual one.
template <int thirds>
void expose(Ui ui) {
  double& stops = ui.state.desk.view.exposure_stops;
  stops = thirds == 0 ? 0.0 : std::clamp(std::round(3.0 * stops + thirds) / 3.0, -render::kMostExposure_stops, render::kMostExposure_stops);
}

constexpr auto kExplosion = WorkMode::explosion;

const std::array kDesk{
    Action{"Camera", "From behind", "4", [](Ui ui) { lookAlong(ui, "back"); }, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "From the left", "5", [](Ui ui) { lookAlong(ui, "left"); }, nullptr, nullptr, false, kExplosion},
    Action{"View", "Extent box", "B", [](Ui ui) { ui.state.desk.view.extent = !ui.state.desk.view.extent; }, nullptr, [](Ui ui) { return ui.state.desk.view.extent; }, true, kExplosion},
    Action{"View", "Ground grid", "G", [](Ui ui) { ui.state.desk.view.grid = !ui.state.desk.view.grid; }, nullptr, [](Ui ui) { return ui.state.desk.view.grid; }, false, kExplosion},
    Action{"View", "Ruler", "M", flipRuler, nullptr, [](Ui ui) { return ui.state.desk.view.ruler; }, false, kExplosion},
    Action{"View", "Automatic quality", "", drawAs<0>, nullptr, drawnAs<0>, true},
    Action{"View", "Draft quality", "", drawAs<1>, nullptr, drawnAs<1>},
    Action{"View", "Normal quality", "", drawAs<2>, nullptr, drawnAs<2>},
    Action{"View", "Fine quality when still", "", drawAs<3>, nullptr, drawnAs<3>},
    Action{"Camera", "Expose longer", "E", expose<1>, nullptr, nullptr, true},
    Action{"Camera", "Expose shorter", "shift+E", expose<-1>},
    Action{"Camera", "Usual exposure", "alt+E", expose<0>, [](Ui ui) { return ui.state.desk.view.exposure_stops != 0.0; }},
    Action{"Camera", "Go to bookmark 1", "ctrl+1", go<0>, nullptr, nullptr, true, kExplosion},
    Action{"Camera", "Go to bookmark 2", "ctrl+2", go<1>, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "Go to bookmark 3", "ctrl+3", go<2>, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "Go to bookmark 4", "ctrl+4", go<3>, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "Keep bookmark 1", "ctrl+shift+1", keep<0>, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "Keep bookmark 2", "ctrl+shift+2", keep<1>, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "Keep bookmark 3", "ctrl+shift+3", keep<2>, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "Keep bookmark 4", "ctrl+shift+4", keep<3>, nullptr, nullptr, false, kExplosion},
    Action{"Export", "Export picture", "ctrl+E", exportAs<ExportKind::picture>, nullptr, nullptr, false, kExplosion},
    Action{"Export", "Export sequence", "", exportAs<ExportKind::sequence>, nullptr, nullptr, false, kExplosion},
    Action{"Export", "Export contact sheet", "", exportAs<ExportKind::contact_sheet>, nullptr, nullptr, false, kExplosion},
    Action{"Export", "Export sprite sheet", "", exportAs<ExportKind::sprite_sheet>, nullptr, nullptr, false, kExplosion},
    Action{"Export", "Export video", "", exportAs<ExportKind::video>, nullptr, nullptr, false, kExplosion},
    Action{"Export", "Copy command line", "ctrl+shift+E", copyCommandLine, nullptr, nullptr, true, kExplosion},
    Action{"Edit", "History", "ctrl+H", flip<Sheet::history>, nullptr, shows<Sheet::history>, true},
    Action{"Edit", "Find command or parameter", "ctrl+P", flip<Sheet::palette>, nullptr, shows<Sheet::palette>},
    Action{"Help", "First steps", "", [](Ui ui) { ui.state.desk.tour = 0; }, nullptr, nullptr, false, kExplosion},
    Action{"Help", "Messages", "", flip<Sheet::messages>, nullptr, shows<Sheet::messages>},
};

}  // namespace

std::span<const Action> deskActions() { return kDesk; }

}  // namespace npsee::editor
