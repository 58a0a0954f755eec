#pragma once

#include <npsee/vec3.h>

namespace npsee {

/// The highest and lowest ground that particles may fall on, m from height 0: what is drawn of them is in single precision.
inline constexpr double kMaxGround_m = 1e7;

/// The surface particles fall on: a height over the x-z plane. Implementations must be pure and thread-safe.
class Ground {
 public:
  virtual ~Ground() = default;

  /// Height of the surface, m, finite and within kMaxGround_m of 0 for every finite x, z (m). Beyond it particles may get places that are not finite.
  virtual double height(double x_m, double z_m) const = 0;

  /// Unit normal; the default takes central differences over a twentieth of `detail()`.
  virtual Vec3 normal(double x_m, double z_m) const;

  /// Shortest horizontal extent of a feature, m: an arc is searched for contacts in steps that move at most half of it.
  virtual double detail() const { return 1.0; }

  /// True when height is the same everywhere: contacts are then solved in closed form, many at a time.
  virtual bool flat() const { return false; }
};

class FlatGround final : public Ground {
 public:
  explicit FlatGround(double height_m = 0.0) : height_m_(height_m) {}
  double height(double, double) const override { return height_m_; }
  Vec3 normal(double, double) const override { return {0.0, 1.0, 0.0}; }
  bool flat() const override { return true; }

 private:
  double height_m_;
};

}  // namespace npsee
