#pragma once

#include "editor/mission/contours.h"
#include "editor/mission/objects.h"

#include <npsee/terrain.h>
#include <npsee/vec3.h>

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace npsee::editor {

/// What the next click on the ground is for, in the viewport and in the plan alike.
enum class GroundClick { select, vehicle, group, gun, observer, goal, call_for_fire, shoot };

/// What the widgets of the mission mode remember from frame to frame.
struct MissionUi {
  float left_width = 286, right_width = 344, plan_height = 330, bottom_height = 196;  ///< unscaled pixels

  enum class Left { objects, library } left = Left::objects;
  enum class Bottom { log, shots, ruler } bottom = Bottom::log;
  enum class Right { parameters, mind, command } right = Right::parameters;
  bool labels = true;
  std::string search;                       ///< in the list of objects
  std::set<std::string> folded_lists;
  std::set<std::string> folded_sections{"Terrain"};
  std::string parameter_search;

  ImVec2 pressed_at;                        ///< where the button went down in the picture
  bool turning = false;                     ///< the picture is being turned or shifted

  GroundClick click = GroundClick::select;
  int click_type = 0;                       ///< of a vehicle to be placed

  /// The plan: which part of the world it shows.
  struct Plan {
    bool placed = false;
    std::uint64_t mission = 0;              ///< that it was placed for
    double centre_x = 0.0, centre_z = 0.0, metre_per_px = 1.0;
    GroundMap map;                          ///< of the part shown, kept while that stays
    Place map_from, map_to;
    std::optional<Terrain> map_of;          ///< held, so that no other ground can come to lie where it lay
  } plan;

  /// A thing being dragged over the ground.
  struct Drag {
    ObjectRef ref;
    Place grabbed;                          ///< the ground under the pointer when it was last moved
    bool pressed = false, moving = false;
    ImVec2 at;
  } drag;

  struct EventList {
    std::uint64_t recording = 0;
    std::vector<bool> kinds;
    std::string word;
    std::vector<int> shown;                 ///< indexes of the listed events
    int selected = -1;                      ///< event whose reason is shown
    std::size_t followed = static_cast<std::size_t>(-1);  ///< newest event that was scrolled to
  } events;

  struct ShotList {
    int column = 0;
    bool descending = false;
    int selected = -1;
  } shots;

  struct Driving {
    double speed_mps = 0.0, turn_radps = 0.0;
    std::string vehicle;
    bool keys = false;                      ///< a driving key is held
  } driving;

  ObjectRef seen;                           ///< the selected object; another one is scrolled into view
};

}  // namespace npsee::editor
