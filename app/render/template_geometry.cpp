#include "app/render/template_geometry.h"

#include <npsee/parameters.h>
#include <npsee/units.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace npsee::render {
namespace {

/// low + span * x / (x + half).
struct Saturating {
  double low, span, half;

  double operator()(double x) const { return low + span * (x > 0.0 ? x / (x + half) : 0.0); }
  double inverse(double y) const {
    const double share = (y - low) / span;
    if (!(share > 0.0)) return 0.0;
    return share < 1.0 ? half * share / (1.0 - share) : std::numeric_limits<double>::infinity();
  }
};

constexpr Saturating kHeight{0.25, 0.95, 25.0};
constexpr Saturating kFoot{0.2, 0.35, 4.0};
constexpr Saturating kScale{0.6, 0.4, 0.5};
constexpr double kFlare = 1.0;          // largest outward distance from foot to rim
constexpr double kCorner = 0.92;       // height of the profile's corner over the shape's, upright
constexpr double kBallPerHeight = 0.8;
constexpr double kAirHeight = 1.05;    // height of an air burst's centre above the base plane
constexpr double kRightAngle = kPi / 2.0;

double limited(std::string_view key, double value) {
  const Parameter& row = *findParameter(Scope::layer, key);
  return std::clamp(value, toSi(row.unit, row.hard.min), toSi(row.unit, row.hard.max));
}

/// Half the region's extent along x and z, m, and the key that sets the first.
struct Footprint {
  double x = 0.0, z = 0.0, inner = 0.0;
  std::string_view key;
};

Footprint footprintOf(const Layer& layer) {
  const double r = layer.region_radius_m, a = 0.5 * layer.region_length_m, w = 0.5 * layer.region_width_m;
  switch (layer.region_shape) {
    case RegionShape::point: return {};
    case RegionShape::ring: return {r, r, std::min(layer.region_inner_radius_m, r), "region.radius"};
    case RegionShape::square: return {a, a, 0.0, "region.length"};
    case RegionShape::line: return {a, 0.0, 0.0, "region.length"};
    case RegionShape::box: return {a, w, 0.0, "region.length"};
    case RegionShape::disc:
    case RegionShape::sphere:
    case RegionShape::hemisphere:
    case RegionShape::cylinder: break;
  }
  return {r, r, 0.0, "region.radius"};
}

bool throwsAllAround(const Preset& preset, const Layer& layer) {
  return layer.directionality == Directionality::neutral || (layer.directionality == Directionality::burst && preset.burst == BurstKind::air);
}

/// Turns +y to the given direction by the shortest way (Rodrigues' formula), then scales and moves.
nurbs::Affine frameOf(const Vec3& direction, double scale, const Vec3& origin) {
  const double size = length(direction);
  const Vec3 d = size > 0.0 ? (1.0 / size) * direction : Vec3{0, 1, 0};
  nurbs::Affine out;
  if (d.y < -1.0 + 1e-12) {
    out = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {}};
  } else {
    const double k = 1.0 / (1.0 + d.y);
    out = {{1.0 - k * d.x * d.x, -d.x, -k * d.x * d.z}, d, {-k * d.x * d.z, -d.z, 1.0 - k * d.z * d.z}, {}};
  }
  return {scale * out.x, scale * out.y, scale * out.z, origin};
}

/// Length of the side from the foot to where it meets the ellipse of the flare's bounds.
double slant(double lean_rad, double height) {
  const double up = std::cos(lean_rad) / (kCorner * height), out = std::sin(lean_rad) / kFlare;
  return 1.0 / std::sqrt(up * up + out * out);
}

nurbs::Surface cupOf(const TemplateShape& shape) {
  const double length = slant(shape.lean_rad, shape.height), flare = length * std::sin(shape.lean_rad), rise = length * std::cos(shape.lean_rad);
  const auto ring = [&](double out, double y) { return nurbs::Ring{shape.foot_x + out, shape.foot_z + out, y, 1.0}; };
  // The first span sees only the first three points, which lie on one line: a straight side up to 0.88 of the way to the corner.
  const nurbs::KnotVector profile{2, {0, 0, 0, 0.6, 1, 1, 1}};
  return nurbs::ringSurface(profile, {ring(0.0, 0.0), ring(0.7 * flare, 0.7 * rise), ring(flare, rise), ring(flare, shape.height)}).mapped(shape.frame);
}

/// Back from template space to shape space; the frame is a turn times a scale.
Vec3 local(const nurbs::Affine& frame, const Vec3& point) {
  const Vec3 p = point - frame.origin;
  const double inverse = 1.0 / dot(frame.y, frame.y);
  return inverse * Vec3{dot(frame.x, p), dot(frame.y, p), dot(frame.z, p)};
}

}  // namespace

double templateHeight(double speed_mps) { return kHeight(speed_mps); }
double templateFoot(double extent_m) { return kFoot(extent_m); }
double templateScale(double size_m) { return kScale(size_m); }
double speedOfTemplateHeight(double height) { return limited("speed_mean", kHeight.inverse(height)); }
double extentOfTemplateFoot(double foot) { return limited("region.radius", kFoot.inverse(foot)); }

double templateFlare(double lean_rad, double height) {
  const double lean = std::clamp(lean_rad, 0.0, kRightAngle);
  return slant(lean, height) * std::sin(lean);
}

double leanOfTemplateFlare(double flare, double height) {
  if (!(flare > 0.0)) return 0.0;
  if (flare >= kFlare) return kRightAngle;
  const double share = flare / kFlare;
  return std::atan2(flare, kCorner * height * std::sqrt(1.0 - share * share));
}

double TemplateShape::ballRadius() const { return kBallPerHeight * height * scale; }

bool TemplateShape::hasHandle(TemplateHandle which) const {
  switch (which) {
    case TemplateHandle::none: return false;
    case TemplateHandle::rim: return !ball;
    case TemplateHandle::top: return true;
    case TemplateHandle::foot: return !foot_key.empty();
  }
  return false;
}

Vec3 TemplateShape::handle(TemplateHandle which, double azimuth_rad) const {
  const double c = std::cos(azimuth_rad), s = -std::sin(azimuth_rad);
  switch (which) {
    case TemplateHandle::none: break;
    case TemplateHandle::rim: {
      const double flare = templateFlare(lean_rad, height);
      return frame({(foot_x + flare) * c, height, (foot_z + flare) * s});
    }
    case TemplateHandle::top: return frame({0.0, ball ? kBallPerHeight * height : height, 0.0});
    case TemplateHandle::foot: {
      const Vec3 at = frame({-foot_x * c, 0.0, -foot_z * s});
      // The sphere hides its region, which is therefore shown on the base plane below.
      return ball ? Vec3{at.x, 0.0, at.z} : at;
    }
  }
  return origin;
}

double TemplateShape::valueAt(TemplateHandle which, const Vec3& point, double azimuth_rad) const {
  const Vec3 p = local(frame, point);
  const double c = std::cos(azimuth_rad), s = -std::sin(azimuth_rad);
  switch (which) {
    case TemplateHandle::none: break;
    case TemplateHandle::rim: {
      const Vec3 foot{foot_x * c, 0.0, foot_z * s};
      return limited("ejection_angle", leanOfTemplateFlare((p.x - foot.x) * c + (p.z - foot.z) * s, height));
    }
    case TemplateHandle::top: return speedOfTemplateHeight(p.y / (ball ? kBallPerHeight : 1.0));
    case TemplateHandle::foot: {
      if (foot_key.empty()) break;
      // Only the first extent follows, so an ellipse is read along x, where its handle is.
      const double extent = kFoot.inverse(foot_x == foot_z ? -(p.x * c + p.z * s) : std::fabs(p.x));
      return limited(foot_key, foot_key == "region.length" ? 2.0 * extent : extent);
    }
  }
  return 0.0;
}

std::string_view parameterOf(TemplateHandle which, const TemplateShape& shape) {
  switch (which) {
    case TemplateHandle::none: return {};
    case TemplateHandle::rim: return "ejection_angle";
    case TemplateHandle::top: return "speed_mean";
    case TemplateHandle::foot: return shape.foot_key;
  }
  return {};
}

TemplateShape templateShape(const Preset& preset, int index) {
  const Layer& layer = preset.layers.at(static_cast<std::size_t>(index));
  const Footprint footprint = footprintOf(layer);
  const bool ball = throwsAllAround(preset, layer);
  const Vec3 origin{0.0, preset.burst == BurstKind::air || ball ? kAirHeight : 0.0, 0.0};
  const double scale = kScale(layer.size_mean_m);
  TemplateShape out{.ball = ball,
                    .scale = scale,
                    .height = kHeight(layer.speed_mean_mps),
                    .foot_x = kFoot(footprint.x),
                    .foot_z = kFoot(footprint.z),
                    .inner_foot = footprint.inner > 0.0 ? kFoot(footprint.inner) : 0.0,
                    .lean_rad = std::clamp(layer.ejection_angle_rad, 0.0, kRightAngle),
                    .origin = origin,
                    .frame = frameOf(ball ? Vec3{0, 1, 0} : layer.direction, scale, origin),
                    .surface = nurbs::sphere(origin, kBallPerHeight * kHeight(layer.speed_mean_mps) * scale),
                    .foot_key = footprint.key};
  if (!ball) out.surface = cupOf(out);
  return out;
}

Vec3 templateCentre(const TemplateShape& shape) {
  if (shape.ball) return shape.origin;
  const Vec3& up = shape.frame.y;
  return shape.origin + (0.5 * kLargestCupHeight / length(up)) * up;
}

}  // namespace npsee::render
