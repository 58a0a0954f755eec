#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace npsee::world {

/// A landscape that rivers cut: heights on a square grid in units of no meaning (they are scaled afterwards).
struct Landscape {
  int columns = 0, rows = 0;
  double spacing = 1.0;                ///< of the samples, in lengths of the hills
  std::vector<double> height, uplift, hardness;
  std::vector<std::uint8_t> outlet;    ///< where water leaves: sea and parts of the rim; their heights stay

  std::size_t size() const { return height.size(); }
  std::size_t index(int c, int r) const { return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c); }
};

/// Where each sample's water goes.
struct Drainage {
  std::vector<std::uint32_t> order;     ///< every sample after the one it drains to
  std::vector<std::uint32_t> receiver;  ///< itself at an outlet
  std::vector<double> area;             ///< upstream, itself included, in squared lengths of the hills
};

/// Steepest way down; out of a hollow, the lowest way over its rim (priority flood: Barnes, Lehman, Mulla 2014, Computers &
/// Geosciences 62, 117-127). At least one sample must be an outlet.
Drainage drainageOf(const Landscape& land);

/// `steps` steps of time `dt` of uplift against rivers: dh/dt = U - k sqrt(A + a) S / hardness, implicitly from the outlets upstream, which is
/// stable for any step (Braun & Willett 2013, Geomorphology 180-181, 170-179, with n = 1, m = 1/2), then a little creep downhill.
void erode(Landscape& land, int steps, double dt);

/// The same landscape on a grid of `columns` by `rows` over the same area: heights by smooth interpolation. The other fields are left empty.
Landscape resampled(const Landscape& land, int columns, int rows);

}  // namespace npsee::world
