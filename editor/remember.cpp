#include "editor/remember.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

struct Length {
  double Settings::* saved;
  float& (*shown)(UiState&);
};
constexpr Length kLengths[] = {
    {&Settings::left_width, [](UiState& s) -> float& { return s.left_width; }},
    {&Settings::right_width, [](UiState& s) -> float& { return s.right_width; }},
    {&Settings::template_height, [](UiState& s) -> float& { return s.template_height; }},
    {&Settings::mission_left_width, [](UiState& s) -> float& { return s.mission.left_width; }},
    {&Settings::mission_right_width, [](UiState& s) -> float& { return s.mission.right_width; }},
    {&Settings::plan_height, [](UiState& s) -> float& { return s.mission.plan_height; }},
    {&Settings::log_height, [](UiState& s) -> float& { return s.mission.bottom_height; }},
};

struct Flag {
  bool Settings::* saved;
  bool UiState::* shown;
};
constexpr Flag kFlags[] = {{&Settings::light, &UiState::light}, {&Settings::show_left, &UiState::show_left}, {&Settings::show_right, &UiState::show_right}};

}  // namespace

void bringIn(const Settings& settings, UiState& state) {
  for (const Length& length : kLengths) length.shown(state) = static_cast<float>(settings.*length.saved);
  for (const Flag& flag : kFlags) state.*flag.shown = settings.*flag.saved;
  DeskUi::View& view = state.desk.view;
  view.grid = settings.show_grid;
  view.extent = settings.show_extent;
  view.background = settings.background;
  // A word that another version knew is none of ours.
  view.quality = std::ranges::find(kQualityWishes, settings.quality) != kQualityWishes.end() ? settings.quality : std::string(kQualityWishes.front());
  view.exposure_stops = settings.exposure_stops;
  view.bookmarks = settings.bookmarks;
}

void noteDown(const UiState& state, Settings& settings) {
  // Accessors give a reference to write to; nothing is written here.
  UiState& readable = const_cast<UiState&>(state);
  for (const Length& length : kLengths) settings.*length.saved = std::round(static_cast<double>(length.shown(readable)));
  for (const Flag& flag : kFlags) settings.*flag.saved = state.*flag.shown;
  const DeskUi::View& view = state.desk.view;
  settings.show_grid = view.grid;
  settings.show_extent = view.extent;
  settings.background = view.background;
  settings.quality = view.quality;
  settings.exposure_stops = view.exposure_stops;
  settings.bookmarks = view.bookmarks;
}

}  // namespace npsee::editor
