#include "editor/mission/fire_form.h"

#include "editor/mission/words.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace npsee::editor {
namespace {

/// Level unit vector from one place to another; north if they are the same.
Place direction(const Vec3& from, const Place& to) {
  const double dx = to.x_m - from.x, dz = to.z_m - from.z, length = std::hypot(dx, dz);
  return length > 0.0 ? Place{dx / length, dz / length} : Place{0.0, -1.0};
}

std::string metresOf(const Place& place) { return placeText(place.x_m, place.z_m); }

}  // namespace

std::vector<KnownPoint> knownPoints(const Recording& recording, int observer, double time_s) {
  std::vector<KnownPoint> out;
  if (observer < 0 || observer >= static_cast<int>(recording.observers.size())) return out;
  const ObserverRecord& record = recording.observers[static_cast<std::size_t>(observer)];
  std::set<int> seen;
  for (auto belief = record.beliefs.rbegin(); belief != record.beliefs.rend(); ++belief)
    if (belief->t_s <= time_s && belief->target >= 0 && seen.insert(belief->target).second)
      out.push_back({recording.vehicles[static_cast<std::size_t>(belief->target)].id, {belief->believed_m.x, belief->believed_m.z}});
  std::ranges::reverse(out);
  for (const MissionEvent& event : recording.events) {
    if (event.t_s > time_s) break;
    if (event.kind == EventKind::call && event.place() != nullptr && event.text("observer") == record.id)
      out.push_back({"mission " + std::to_string(static_cast<int>(event.number("mission"))), {event.place()->x, event.place()->z}});
  }
  return out;
}

std::vector<OpenMission> openMissions(const Recording& recording, const std::string& observer, double time_s) {
  std::vector<OpenMission> out;
  for (const MissionEvent& event : recording.events) {
    if (event.t_s > time_s) break;
    const int number = static_cast<int>(event.number("mission"));
    const auto known = std::ranges::find(out, number, &OpenMission::number);
    if (event.kind == EventKind::call && event.text("observer") == observer) {
      const Vec3 place = event.place() != nullptr ? *event.place() : Vec3{};
      const std::string method = event.text("method");
      out.push_back({number, observer, event.text("target"), method, {place.x, place.z}, event.t_s, 0, method != "adjust_fire"});
    } else if (known != out.end()) {
      if (event.kind == EventKind::end_of_mission) out.erase(known);
      else if (event.kind == EventKind::detonation) ++known->rounds;
      else if (event.kind == EventKind::correction && event.text("method") == "fire_for_effect") known->effect = true;
    }
  }
  return out;
}

std::pair<double, double> polarTo(const Recording& recording, int observer, double time_s, const Place& place) {
  const Vec3 eye = recording.observerEye(static_cast<std::size_t>(observer), time_s);
  const double dx = place.x_m - eye.x, dz = place.z_m - eye.z;
  const double azimuth = std::atan2(dx, -dz) * kMilPerRad;
  return {azimuth < 0.0 ? azimuth + 6400.0 : azimuth, std::hypot(dx, dz)};
}

Expected<Place> placeOfCall(const CallForm& form, const Recording& recording, int observer, double time_s) {
  if (observer < 0 || observer >= static_cast<int>(recording.observers.size())) return fail(ErrorKind::usage, "There is no observer to call fire.", "Select one.");
  const Vec3 eye = recording.observerEye(static_cast<std::size_t>(observer), time_s);
  Place out = form.grid;
  if (form.locate == Locate::polar) {
    const double azimuth = form.azimuth_mil / kMilPerRad;
    out = {eye.x + form.distance_m * std::sin(azimuth), eye.z - form.distance_m * std::cos(azimuth)};
  }
  if (form.locate == Locate::shift) {
    const auto points = knownPoints(recording, observer, time_s);
    const auto known = std::ranges::find(points, form.known, &KnownPoint::name);
    if (known == points.end()) return fail(ErrorKind::usage, form.known.empty() ? "The shift names no known point." : "There is no known point \"" + printable(form.known) + "\".", "Choose a contact or an earlier mission, or give a grid.");
    const Place along = direction(eye, known->at);
    // Right of a line that runs towards (x, z) is (-z, x): x east, z south.
    out = {known->at.x_m + form.add_m * along.x_m - form.right_m * along.z_m, known->at.z_m + form.add_m * along.z_m + form.right_m * along.x_m};
  }
  const WorldSetup& world = recording.scenario.world;
  if (!(out.x_m >= 0.0 && out.x_m <= world.size_x_m && out.z_m >= 0.0 && out.z_m <= world.size_z_m))
    return fail(ErrorKind::usage, "The target at " + metresOf(out) + " lies outside the world.", "The world reaches to " + placeText(world.size_x_m, world.size_z_m) + ".");
  return out;
}

double otFactor(double ot_distance_m) {
  const double kilometres = ot_distance_m / 1000.0;
  return kilometres < 1.0 ? std::round(kilometres * 10.0) / 10.0 : std::round(kilometres);
}

double lateralCorrection(double right_mil, double ot_distance_m) {
  const double metres = -std::round(right_mil * otFactor(ot_distance_m) / 10.0) * 10.0;
  return metres == 0.0 ? 0.0 : metres;
}

Grade gradeOf(const Recording& recording, const std::string& observer, double time_s) {
  Grade out;
  double sum = 0.0;
  for (const MissionEvent& event : recording.events) {
    if (event.t_s > time_s) break;
    if (event.kind != EventKind::correction || event.text("observer") != observer || event.find("grade_m") == nullptr) continue;
    out.last_m = event.number("grade_m");
    sum += *out.last_m;
    ++out.corrections;
  }
  if (out.corrections > 0) out.mean_m = sum / out.corrections;
  return out;
}

}  // namespace npsee::editor
