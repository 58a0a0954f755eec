#pragma once

#include <npsee/explosion.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace npsee::render {

/// What the other puffs leave of the light at a puff. Optical depths, 0 = nothing in the way.
struct PuffLight {
  float sunward = 0.0f;  ///< between the sun and the puff's lit side
  float averted = 0.0f;  ///< between the sun and its far side
  float sky = 1.0f;      ///< share of the sky's light that comes through, 0..1
};

/// Optical depth of a puff through its middle, for its opacity a: a (1 + 2 a^2), within 12 % of -ln(1 - a) up to a = 0.9 and finite at 1.
inline double opticalDepthOf(double opacity) { return opacity * (1.0 + 2.0 * opacity * opacity); }

/// Share of light left after an optical depth t in a medium as uneven as smoke: (1 + t/2)^-2.
///
/// The mean of exp(-t X) for X with the Gamma distribution of mean 1 and variance 1/2. It leaves thin smoke as exp(-t) does, and lets
/// more through thick smoke, which has gaps.
inline float leftThrough(float depth) {
  const float q = 1.0f + 0.5f * depth;
  return 1.0f / (q * q);
}

/// Light inside a cloud of puffs: a coarse grid of what absorbs, and through it the way of the sun's and of the sky's light.
///
///   depth(c) = sum over cells from the sun to c of sigma ds
///
/// sigma is the extinction (1/m) that the puffs bring to a cell, ds its length along the light. The sun's depth is summed slice by slice
/// from the side of the sun, each cell from the four above it; the sky is seen in five directions (up with 0.36, four sides with 0.16 each).
/// A puff of radius r and depth t0 through its middle has the extinction of a ball of that depth of which noise leaves four tenths:
/// 0.6 (4 pi / 3) r^3 t0 / (2 r) = 0.8 t0 r^2, spread over the cells it covers.
///
/// Sums are in order, so that equal frames give equal bits. Memory is kept from frame to frame.
class SmokeShade {
 public:
  /// Grid cells at most, but for the border.
  static constexpr double kMostCells = 32768.0;

  /// Fills the grid with the smoke of a frame, and a little soot of fire. `towards_sun` is a unit vector.
  void build(const Frame& frame, std::span<const LayerSpan> layers, const Vec3& towards_sun);

  /// Light at a puff of that radius; everything where the grid is empty.
  PuffLight at(const Vec3& place, double radius_m) const;

  /// Sums the depth towards an eye, for hidden(); nothing is hidden from an eye within the smoke's box.
  void lookFrom(const Vec3& eye);
  /// Whether so much smoke stands between the eye and all of a puff that it would not be seen: a depth of kHidden before its middle and
  /// before four places of its rim.
  bool hidden(const Vec3& place, double radius_m, const Vec3& right, const Vec3& up) const;
  /// Less than 0.1 % of light comes through an even medium of this depth, and 4 % through one as uneven as leftThrough() takes it.
  static constexpr double kHidden = 8.0;

  bool empty() const { return sigma_.empty(); }
  double cell_m() const { return cell_m_; }

 private:
  void fit(const Frame& frame, std::span<const LayerSpan> layers);
  void add(const Vec3& place, double radius_m, double depth);
  void sweepSun(const Vec3& towards_sun);
  void sweepSky();
  void sweepSide(std::size_t axis, bool from_end, float share);
  double sample(const std::vector<float>& cells, const Vec3& place) const;

  std::array<int, 3> count_{};      // cells along x, y, z
  std::array<std::ptrdiff_t, 3> step_{};  // between neighbours
  Vec3 corner_;                     // lowest, world m
  double cell_m_ = 1.0;
  Vec3 sun_, eye_;
  std::vector<float> sigma_, sun_depth_, sky_, eye_depth_;
  std::array<std::vector<float>, 3> weights_;  // of the puff being added
};

}  // namespace npsee::render
