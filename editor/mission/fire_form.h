#pragma once

#include <npsee/mission.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace npsee::editor {

/// How a call for fire says where the target is.
enum class Locate { grid, polar, shift };

/// A call for fire as a person fills it in: warning order (the method), location, description.
struct CallForm {
  FireMethod method = FireMethod::adjust_fire;
  Locate locate = Locate::grid;
  Place grid;                       ///< x and z, m
  double azimuth_mil = 0.0;         ///< polar: from the observer, clockwise from north
  double distance_m = 1000.0;
  std::string known;                ///< shift: the known point's name
  double right_m = 0.0, add_m = 0.0;  ///< shift: from it, along the line from the observer to it
  std::string description;
};

/// A correction as a person gives it. What the reticle measures in mils becomes metres by the OT factor.
struct CorrectionForm {
  double right_m = 0.0, add_m = 0.0;
};

/// A point that observer and guns both know: a contact where he believes it to be, or the target of an earlier mission.
struct KnownPoint {
  std::string name;
  Place at;
};
std::vector<KnownPoint> knownPoints(const Recording& recording, int observer, double time_s);

/// A fire mission that is under way.
struct OpenMission {
  int number = 0;
  std::string observer, target, method;
  Place at;                         ///< of the target as called
  double called_s = 0.0;
  int rounds = 0;                   ///< that have burst
  bool effect = false;              ///< fire for effect was asked for
};
/// Missions called and not ended at a moment, of one observer.
std::vector<OpenMission> openMissions(const Recording& recording, const std::string& observer, double time_s);

/// Where the form says the target is. Error kind usage: outside the world, or no such known point.
Expected<Place> placeOfCall(const CallForm& form, const Recording& recording, int observer, double time_s);

/// Azimuth (mil) and level distance (m) from the observer's eye to a place.
std::pair<double, double> polarTo(const Recording& recording, int observer, double time_s, const Place& place);

/// Metres per mil at a distance: the OT factor is the distance in kilometres to whole numbers, to tenths below one kilometre.
double otFactor(double ot_distance_m);
/// The correction (m, right positive) that brings a burst seen `right_mil` right of the target onto the line: mils times the OT
/// factor, to 10 m.
double lateralCorrection(double right_mil, double ot_distance_m);

/// A person's corrections with what the rules would have said.
struct Grade {
  int corrections = 0;              ///< that could be compared
  double mean_m = 0.0;              ///< mean distance between the two
  std::optional<double> last_m;
};
Grade gradeOf(const Recording& recording, const std::string& observer, double time_s);

}  // namespace npsee::editor
