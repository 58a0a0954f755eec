#include "editor/panels/actions.h"

#include <array>

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

const std::array kDesk{
    Action{"Edit", "History", "ctrl+H", flip<Sheet::history>, nullptr, shows<Sheet::history>, true},
    Action{"Edit", "Find command or parameter", "ctrl+P", flip<Sheet::palette>, nullptr, shows<Sheet::palette>},
    Action{"Help", "Messages", "", flip<Sheet::messages>, nullptr, shows<Sheet::messages>},
};

}  // namespace

std::span<const Action> deskActions() { return kDesk; }

}  // namespace npsee::editor
