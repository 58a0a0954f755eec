#include "editor/document/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace npsee::editor {

FrameFigures figuresOf(const Frame& frame) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  FrameFigures out;
  out.extent = {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  double squares = 0.0, fastest = 0.0;
  for (std::size_t i = 0; i < frame.count; ++i) {
    if (frame.alive[i] == 0) continue;
    ++out.alive;
    const double vx = static_cast<double>(frame.vx[i]), vy = static_cast<double>(frame.vy[i]), vz = static_cast<double>(frame.vz[i]);
    const double square = vx * vx + vy * vy + vz * vz;
    squares += square;
    fastest = std::max(fastest, square);
    const Vec3 at{static_cast<double>(frame.x[i]), static_cast<double>(frame.y[i]), static_cast<double>(frame.z[i])};
    Extent& extent = out.extent;
    extent.min = {std::min(extent.min.x, at.x), std::min(extent.min.y, at.y), std::min(extent.min.z, at.z)};
    extent.max = {std::max(extent.max.x, at.x), std::max(extent.max.y, at.y), std::max(extent.max.z, at.z)};
  }
  if (out.alive == 0) out.extent = {};
  else out.energy_Jpkg = 0.5 * squares / static_cast<double>(out.alive);
  out.fastest_mps = std::sqrt(fastest);
  return out;
}

}  // namespace npsee::editor
