#pragma once

#include <npsee/recording.h>

#include <optional>
#include <string>
#include <vector>

namespace npsee::editor {

/// One line of the shot table.
struct Shot {
  int shell = 0;          ///< index in the recording
  double fired_s = 0.0, burst_s = 0.0;
  std::string gun;        ///< or vehicle
  std::string target;
  std::string trajectory; ///< low, high, direct
  int mission = 0;        ///< 0 = direct fire
  double elevation_mil = 0.0, azimuth_mil = 0.0;
  double apex_m = 0.0;    ///< over the muzzle
  std::optional<double> miss_m;  ///< to where the target was; none if it had no target
  double tof_s() const { return burst_s - fired_s; }
};

/// Columns by which the table can be sorted.
enum class ShotColumn { number, fired, gun, mission, target, elevation, azimuth, tof, apex, miss };

/// Every shot fired until now, in the order of firing.
std::vector<Shot> shotsOf(const Recording& recording);
void sortShots(std::vector<Shot>& shots, ShotColumn column, bool descending);
/// The table as text with tabs, for the clipboard.
std::string shotsText(const std::vector<Shot>& shots);

}  // namespace npsee::editor
