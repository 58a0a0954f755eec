#pragma once

#include "app/render/view.h"

#include <npsee/recording.h>

#include <optional>

namespace npsee::render {

/// How a mission is looked at. Plain data; what it means at a moment follows from the recording (`missionEye`).
struct MissionCamera {
  enum class Kind {
    free,      ///< from `eye` towards `target`
    orbit,     ///< around `target` at `distance_m`, `yaw_rad`, `pitch_rad`
    follow,    ///< behind and beside a shell, which stays in the middle; before it is fired its gun, afterwards its burst
    gun,       ///< around a gun
    observer,  ///< the observer's eye: binoculars with a mil reticle, turned towards his target
    plan,      ///< a map from straight above, north up, practically parallel
  };
  Kind kind = Kind::orbit;
  /// Index of the shell (follow), gun or observer; -1: the shell fired last, the first gun, the first observer.
  int subject = -1;
  Vec3 eye, target;                ///< target is the middle of a plan too
  double distance_m = 1500.0;      ///< orbit, follow and gun
  double yaw_rad = 0.6;            ///< azimuth of the eye's side: 0 = from the south, clockwise; follow: from behind
  double pitch_rad = 0.35;         ///< of the eye over the subject
  double fov_y_rad = 0.6981317007977318;
  int look_at = -1;                ///< observer: vehicle looked at; -1: his target, else the nearest contact, else straight ahead
  double turn_rad = 0.0, raise_rad = 0.0;  ///< observer: on top of that, to the right and up
  double field_mil = 130.0;        ///< observer: diameter of the binoculars' circle
  bool binoculars = true;          ///< false: the naked eye, `fov_y_rad`
  double span_m = 5000.0;          ///< plan: from the lower to the upper edge
  friend bool operator==(const MissionCamera&, const MissionCamera&) = default;
};

/// Share of the picture's height that the binoculars' circle takes.
inline constexpr double kCircleShare = 0.94;

/// A mission camera at a moment: the eye in the world and the lens as it stands there.
struct MissionEye {
  MissionCamera::Kind kind = MissionCamera::Kind::free;
  Lens lens;                       ///< in the world
  int width = 0, height = 0;
  int observer = -1;               ///< whose eye it is
  bool reticle = false;

  /// The view with its eye at the origin: everything drawn is placed relative to the eye in double precision first.
  View view() const;
  /// The view for things placed relative to `origin` instead.
  View viewFrom(const Vec3& origin) const;
  /// Pixels from the upper left, and the depth along the line of sight, m; nothing if it is not in front.
  struct Pixel {
    double x = 0.0, y = 0.0, depth_m = 0.0;
  };
  std::optional<Pixel> project(const Vec3& world) const;
  /// Direction into the world through a pixel (from the upper left); not a unit vector.
  Vec3 rayThrough(double x, double y) const;
  /// Where a pixel meets ground or sea.
  std::optional<Vec3> groundAt(const Terrain& terrain, double x, double y) const;
};

MissionEye missionEye(const Recording& recording, double time_s, const MissionCamera& camera, int width, int height);

/// A camera that shows where the mission happens: vehicles, guns, observers and bursts. `kind` orbit or plan.
MissionCamera overviewCamera(const Recording& recording, MissionCamera::Kind kind, double aspect);

/// The shell that a following camera without a subject shows: the one fired last before the time, else the first; -1 if there is none.
int shellToFollow(const Recording& recording, double time_s);
/// The vehicle that an observer looks at; -1 = none.
int targetOf(const Recording& recording, int observer, double time_s);

}  // namespace npsee::render
