#include "editor/document/statistics.h"

#include "app/render/frame_particles.h"

#include <npsee/fragments.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace npsee::editor {

namespace {

double squareOf(const Frame& frame, std::size_t i) {
  const double vx = static_cast<double>(frame.vx[i]), vy = static_cast<double>(frame.vy[i]), vz = static_cast<double>(frame.vz[i]);
  return vx * vx + vy * vy + vz * vz;
}

/// Pieces have the mass of their volume.
void addMasses(const Frame& frame, const LayerSpan& layer, FrameFigures& out, double& massless) {
  if (layer.pieces == nullptr || layer.pieces->pieces.empty()) return;
  const auto& pieces = layer.pieces->pieces;
  for (std::size_t i = layer.first; i < render::endOf(layer, frame); ++i) {
    if (frame.alive[i] == 0) continue;
    ++out.massive;
    out.energy_J += 0.5 * pieces[(i - layer.first) % pieces.size()].mass.mass_kg * squareOf(frame, i);
    massless -= squareOf(frame, i);
  }
}

}  // namespace

FrameFigures figuresOf(const Frame& frame, std::span<const LayerSpan> layers) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  FrameFigures out;
  out.extent = {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  double squares = 0.0, fastest = 0.0;
  for (std::size_t i = 0; i < frame.count; ++i) {
    if (frame.alive[i] == 0) continue;
    ++out.alive;
    const double square = squareOf(frame, i);
    squares += square;
    fastest = std::max(fastest, square);
    const Vec3 at = render::placeOf(frame, i);
    Extent& extent = out.extent;
    extent.min = {std::min(extent.min.x, at.x), std::min(extent.min.y, at.y), std::min(extent.min.z, at.z)};
    extent.max = {std::max(extent.max.x, at.x), std::max(extent.max.y, at.y), std::max(extent.max.z, at.z)};
  }
  for (const LayerSpan& layer : layers) addMasses(frame, layer, out, squares);
  if (out.alive == 0) out.extent = {};
  if (out.alive > out.massive) out.energy_Jpkg = 0.5 * std::max(squares, 0.0) / static_cast<double>(out.alive - out.massive);
  out.fastest_mps = std::sqrt(fastest);
  return out;
}

}  // namespace npsee::editor
