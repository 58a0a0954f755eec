#pragma once

#include <npsee/error.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// What a weapon is typically most effective against; the numbers are those of weapons.dat.
enum class TargetType { any = 0, heavy_armor, light_armor, wheeled_vehicle, personnel, aircraft, watercraft };
/// The weapon's usual trajectory; the numbers are those of weapons.dat.
enum class PathType { low_angle = 0, high_angle, linear, gravity_bomb };

/// One weapon of weapons.dat (thesis, appendix B.A): an I record and its D record.
struct Weapon {
  std::string name;  ///< at most 20 characters, no spaces
  int id = 0;        ///< unique; USSR weapons from 2, US weapons from 100
  int range_m = 0;   ///< absolute maximum range as the file states it; not always one the muzzle velocity can reach
  double muzzle_velocity_mps = 0.0;
  int kill_radius_m = 0;       ///< killsize: lethal within
  int damage_radius_m = 0;     ///< damagesize: noticeable within
  int knowledge_radius_m = 0;  ///< knowledgesize: noticed within (a char in the thesis, which 200 does not fit)
  TargetType target = TargetType::any;
  PathType path = PathType::low_angle;

  /// Comments as written, for writing the file back: before the I record, after it, after the D record.
  std::string comment_before, comment_identity, comment_data;

  bool american() const { return id >= 100; }  ///< Ids from 100 are US weapons (thesis, appendix B.A).
  friend bool operator==(const Weapon&, const Weapon&) = default;
};

struct Weapons {
  std::vector<Weapon> list;
  std::string comment_end;      ///< after the last record
  std::vector<Fault> warnings;  ///< what is allowed but doubtful, e.g. a range that no shell of that speed reaches

  /// By name or by number; null if there is none.
  const Weapon* find(std::string_view name_or_id) const;
  friend bool operator==(const Weapons& a, const Weapons& b) { return a.list == b.list && a.comment_end == b.comment_end; }
};

/// Reads weapons.dat. The error (kind input) lists every fault with file and line; a faulty record is skipped to the next one.
Expected<Weapons> parseWeapons(std::string_view text, std::string_view file);
Expected<Weapons> loadWeapons(const std::filesystem::path& path);

/// The file's text, comments kept; `parseWeapons(weaponsText(w), "") == w`.
std::string weaponsText(const Weapons& weapons);
/// Writes atomically. Error kind input (the value could not be read back) or output.
Expected<void> saveWeapons(const Weapons& weapons, const std::filesystem::path& path);

}  // namespace npsee
