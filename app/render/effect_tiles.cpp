#include "app/render/effect_tiles.h"

#include "app/render/frame_particles.h"
#include "app/render/heat.h"
#include "app/render/meshes.h"
#include "app/render/shock_pass.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace npsee::render {
namespace {

/// Pixels added around: least sizes, edges, rounding.
constexpr double kMargin_px = 2.5;
/// The blob of shaders/shadow.vert: its radius per size and per metre of height, before both are stretched along the light.
constexpr double kBlobSize = 0.5045, kBlobGrowth = 0.0101;

/// What a ball of radius r around a point may cover, or a disc of that radius on the ground; nothing if it may surround the eye, where
/// anything is possible.
std::optional<PixelBox> boxOf(const TileMask& mask, const View& view, const Vec3& at, double r, bool flat) {
  const Vec3 from = at - view.eye;
  const double depth = -dot(view.back, from);
  // Beside the pyramid that is seen, where it is thinner than the ball.
  const auto beside = [&](double across, double pixels) {
    const double slope = 0.5 * pixels * view.metre_per_pixel;
    return std::abs(across) - slope * depth > (r + kMargin_px * view.metre_per_pixel * length(from)) * std::sqrt(1.0 + slope * slope);
  };
  if (depth < -r || beside(dot(view.right, from), mask.width()) || beside(dot(view.up, from), mask.height())) return PixelBox{};
  if (depth < 2.0 * r + 1e-3) return std::nullopt;
  // Half width along an axis of the camera.
  const auto half = [&](const Vec3& axis) { return flat ? r * std::sqrt(std::max(1.0 - axis.y * axis.y, 0.0)) : r; };
  const double x = dot(view.right, from) / depth, y = dot(view.up, from) / depth, along = half(view.back);
  // Off the axis nearer parts lie farther out.
  const double scale = 1.0 / (view.metre_per_pixel * (depth - along));
  const double half_x = scale * (half(view.right) + along * std::abs(x)) + kMargin_px, half_y = scale * (half(view.up) + along * std::abs(y)) + kMargin_px;
  const double centre_x = x / view.metre_per_pixel + 0.5 * mask.width(), centre_y = y / view.metre_per_pixel + 0.5 * mask.height();
  return PixelBox{centre_x - half_x, centre_y - half_y, centre_x + half_x, centre_y + half_y};
}

/// Marks it; false if it may surround the eye.
bool markRound(TileMask& mask, const View& view, const Vec3& at, double r, bool flat) {
  const auto box = boxOf(mask, view, at, r, flat);
  if (box) mask.mark(*box);
  return box.has_value();
}

/// Marks a blob of half width r on the ground that is stretched along the light, as a chain of discs: a circle around all of a long one would
/// hold far more than it.
bool markShadow(TileMask& mask, const View& view, const Vec3& at, double r, const Vec3& sun) {
  const double flat = std::sqrt(sun.x * sun.x + sun.z * sun.z), stretch = 1.0 / sun.y;
  const int discs = flat > 0.0 ? static_cast<int>(std::ceil(stretch / 1.5)) : 1;
  if (discs <= 1) return markRound(mask, view, at, r * stretch, true);
  const double step = 2.0 * stretch / discs;
  for (int i = 0; i < discs; ++i) {
    const double along = r * (-stretch + (i + 0.5) * step) / flat;
    if (!markRound(mask, view, {at.x + along * sun.x, at.y, at.z + along * sun.z}, r * std::sqrt(1.0 + 0.25 * step * step), true)) return false;
  }
  return true;
}

/// Largest distance from a particle's place to anything drawn of it. Pieces near the ground are lifted onto it.
double reachOf(const Frame& frame, std::size_t i, Form form, double above_ground_m) {
  const double size = static_cast<double>(frame.size[i]);
  if (isSoft(form) && form != Form::streak) return 0.71 * size;
  if (form != Form::streak) return above_ground_m > 0.5 * size ? 0.5 * size : size;
  if (frame.vx.size() <= i) return size;
  return size + 0.01 * length({static_cast<double>(frame.vx[i]), static_cast<double>(frame.vy[i]), static_cast<double>(frame.vz[i])});
}

/// Marks a blast front or a burnt patch; the ground's share of them only where the ground is drawn on.
bool markOnGround(TileMask& mask, const Frame& frame, std::size_t i, Form form, const View& view, double ground_m, bool on_ground) {
  const Vec3 at = placeOf(frame, i);
  const double radius = 0.5 * static_cast<double>(frame.size[i]);
  // A square's corners lie farther out than its sides.
  if (form == Form::scorch) return !on_ground || markRound(mask, view, {at.x, ground_m, at.z}, 1.4143 * radius, true);
  if (!markRound(mask, view, at, 1.02 * radius, false)) return false;
  const double least = 1.5 * view.metre_per_pixel * length(Vec3{at.x, ground_m, at.z} - view.eye);
  return !on_ground || std::abs(at.y - ground_m) >= radius || markRound(mask, view, {at.x, ground_m, at.z}, radius + std::max(kRingWidth * radius, least), true);
}

/// Whether a particle may be brighter than the roll-off's threshold: streaks are up to 3.2 times their colour, fire and flash more; pieces only if they are hot.
bool mayDazzle(const Frame& frame, std::size_t i, const LayerSpan& layer) {
  if (frame.size[i] <= 0.0f || frame.a[i] < 0.05f) return false;
  const double temperature = temperatureAt(layer, frame, i);
  if (!isSoft(layer.form)) {
    const Vec3 light = emittedLight(temperature);
    return std::max({light.x, light.y, light.z}) > 0.3;
  }
  const Colour colour = hotColour({static_cast<double>(frame.r[i]), static_cast<double>(frame.g[i]), static_cast<double>(frame.b[i])}, temperature);
  const double most = std::max({colour.r, colour.g, colour.b});
  return layer.form == Form::flash || layer.form == Form::fire ? most > 0.3 : frame.a[i] > 0.25f && most > 0.55;
}

}  // namespace

void markBright(TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view) {
  for (const LayerSpan& layer : layers) {
    const bool hot_pieces = (isSolid(layer.form) || layer.form == Form::pieces) && layer.temperature_k > 0.0;
    if (!hot_pieces && (!isSoft(layer.form) || layer.form == Form::smoke)) continue;
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i) {
      if (!mayDazzle(frame, i, layer)) continue;
      if (!markRound(mask, view, placeOf(frame, i), reachOf(frame, i, layer.form, 0.0), false)) return mask.markAll();
    }
  }
}

void findPieces(PieceSpread& out, const TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  out.pieces.clear();
  for (const LayerSpan& layer : layers) {
    if (!isSolid(layer.form) && !layer.pieces) continue;
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i) {
      if (frame.size[i] <= 0.0f || frame.a[i] <= 0.0f) continue;
      const Vec3 at = placeOf(frame, i);
      const double reach = reachOf(frame, i, layer.form, at.y - ground.height_m), depth = view.depthOf(at.x, at.y, at.z);
      const PixelBox whole{0.0, 0.0, static_cast<double>(mask.width()), static_cast<double>(mask.height())};
      out.pieces.push_back({boxOf(mask, view, at, reach, false).value_or(whole), depth - reach, depth + reach});
    }
  }
}

bool PieceSpread::reaches(double nearest_m, double farthest_m) const {
  return std::ranges::any_of(pieces, [&](const Extent& piece) { return piece.farthest_m >= nearest_m && piece.nearest_m <= farthest_m; });
}

void PieceSpread::mark(TileMask& mask, double nearest_m, double farthest_m) const {
  for (const Extent& piece : pieces)
    if (piece.farthest_m >= nearest_m && piece.nearest_m <= farthest_m) mask.mark(piece.box);
}

void markEffect(TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, bool shadows) {
  const double ground_m = ground.height_m;
  if (shadows && ground.glow.shines()) {
    // The patch is a square: its corners lie farther out than its sides.
    const bool bounded = markRound(mask, view, {ground.glow.place.x, ground_m, ground.glow.place.z}, 1.4143 * ground.glow.reach(), true);
    if (!bounded) return mask.markAll();
  }
  for (const LayerSpan& layer : layers) {
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i) {
      if (frame.size[i] <= 0.0f) continue;
      if (layer.form == Form::shock || layer.form == Form::scorch) {
        if (!markOnGround(mask, frame, i, layer.form, view, ground_m, shadows)) return mask.markAll();
        continue;
      }
      const Vec3 at = placeOf(frame, i);
      const double size = static_cast<double>(frame.size[i]);
      bool bounded = markRound(mask, view, at, reachOf(frame, i, layer.form, at.y - ground_m), false);
      if (bounded && shadows) {
        const Vec3& sun = ground.hour.towards_key;
        const double height_m = std::max(at.y - ground_m, 0.25 * size), far_m = height_m / sun.y;
        bounded = markShadow(mask, view, {at.x - sun.x * far_m, ground_m, at.z - sun.z * far_m}, kBlobSize * size + kBlobGrowth * height_m, sun);
      }
      if (!bounded) return mask.markAll();
    }
  }
}

}  // namespace npsee::render
