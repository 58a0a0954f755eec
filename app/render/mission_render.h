#pragma once

#include "app/render/mission_scene.h"

#include <npsee/error.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace npsee::render {

/// One `--render` of the command line, understood: parts "key=value" separated by commas, in any order. See missionRenderHelp().
struct MissionRender {
  std::string text;                 ///< as typed, for messages
  std::optional<double> time_s;     ///< `t`
  int width = 1280, height = 720;   ///< `size=WxH`
  std::string output;               ///< `out`: where the picture goes; empty = the command's -o
  MissionView view;                 ///< complete but for what has to be looked up in a recording:
  std::string subject;              ///< `camera=KIND:SUBJECT`: id of a gun or observer, number of a shell
  std::string look_at;              ///< `look`: id of a vehicle
  std::vector<std::pair<int, std::string>> presets;  ///< `preset=NAME` (all shells, number 0) or `preset=N:NAME`
  bool target_given = false, distance_given = false, span_given = false, yaw_given = false, pitch_given = false, eye_given = false;
};

/// Error kind usage, naming the part and what it may be.
Expected<MissionRender> parseMissionRender(std::string_view text);

/// The view with its names looked up and, where no place is given, a camera that shows where the mission happens. Error kind usage
/// (no such gun, observer, shell or vehicle; the nearest is named) or input (a preset file that cannot be read).
Expected<MissionView> missionView(const MissionRender& render, const Recording& recording);

/// The keys with their meaning, one per line, for `--help` and the documentation.
std::string_view missionRenderHelp();

}  // namespace npsee::render
