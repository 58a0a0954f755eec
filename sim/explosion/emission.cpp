#include "sim/explosion/emission.h"

#include "sim/core/elementary.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::explosion {
namespace {

Vec3 unit(const Vec3& v) { return (1.0 / length(v)) * v; }

struct Turn {
  double sine = 0.0, cosine = 1.0;
};

Turn turn(double angle_rad) {
  Turn out;
  sineCosine(angle_rad, out.sine, out.cosine);
  return out;
}

/// Share of the half-normal distribution that lies within two deviations: erf(sqrt 2).
constexpr double kWithinTwoDeviations = 0.95449973610364158560;

double cubeRoot(double x) { return x > 0.0 ? exponential(logarithm(x) * (1.0 / 3.0)) : 0.0; }

Vec3 onCircle(double radius, double part) {
  const Turn t = turn(kTwoPi * part);
  return {radius * t.cosine, 0.0, radius * t.sine};
}

/// Uniform direction from two uniform numbers (Archimedes: height is uniform over a sphere).
Vec3 onSphere(double a, double b) {
  const double y = 1.0 - 2.0 * a, around = std::sqrt(std::max(0.0, 1.0 - y * y));
  const Turn t = turn(kTwoPi * b);
  return {around * t.cosine, y, around * t.sine};
}

Vec3 onSquareRim(double side, double part) {
  const double along = 4.0 * part;
  const double place = (along - std::floor(along) - 0.5) * side, edge = 0.5 * side;
  switch (static_cast<int>(along)) {
    case 0: return {place, 0.0, -edge};
    case 1: return {edge, 0.0, place};
    case 2: return {-place, 0.0, edge};
    default: return {-edge, 0.0, -place};
  }
}

Vec3 onBoxSkin(double a, double b, double c, double x, double y, double z) {
  const double xy = x * y, xz = x * z, yz = y * z;
  // Which pair of faces by area, then which of the two by what is left of the same draw.
  double pick = c * (xy + xz + yz);
  const auto side = [](double part) { return part < 0.5 ? -0.5 : 0.5; };
  if (pick < xy) return {(a - 0.5) * x, (b - 0.5) * y, side(pick / xy) * z};
  pick -= xy;
  if (pick < xz) return {(a - 0.5) * x, side(pick / xz) * y, (b - 0.5) * z};
  pick -= xz;
  return {side(yz > 0.0 ? pick / yz : 0.0) * x, (a - 0.5) * y, (b - 0.5) * z};
}

/// Place in the region, uniform by its length, area or volume. `a`, `b`, `c` are uniform in (0, 1).
Vec3 placeIn(const Layer& layer, double a, double b, double c) {
  const bool surface = layer.region_fill == RegionFill::surface;
  const double r = layer.region_radius_m, l = layer.region_length_m, w = layer.region_width_m, h = layer.region_height_m;
  switch (layer.region_shape) {
    case RegionShape::point: return {};
    case RegionShape::disc: return onCircle(surface ? r : r * std::sqrt(a), b);
    case RegionShape::ring: {
      const double inner = std::min(layer.region_inner_radius_m, r);
      if (surface) return onCircle(a * (r + inner) < r ? r : inner, b);
      return onCircle(std::sqrt(inner * inner + a * (r * r - inner * inner)), b);
    }
    case RegionShape::square: return surface ? onSquareRim(l, a) : Vec3{(a - 0.5) * l, 0.0, (b - 0.5) * l};
    case RegionShape::line: return {surface ? (a < 0.5 ? -0.5 : 0.5) * l : (a - 0.5) * l, 0.0, 0.0};
    case RegionShape::sphere:
    case RegionShape::hemisphere: {
      Vec3 out = (surface ? r : r * cubeRoot(c)) * onSphere(a, b);
      if (layer.region_shape == RegionShape::hemisphere) out.y = std::fabs(out.y);
      return out;
    }
    case RegionShape::box: return surface ? onBoxSkin(a, b, c, l, h, w) : Vec3{(a - 0.5) * l, (c - 0.5) * h, (b - 0.5) * w};
    case RegionShape::cylinder: {
      Vec3 out = onCircle(surface ? r : r * std::sqrt(a), b);
      out.y = (c - 0.5) * h;
      return out;
    }
  }
  return {};
}

/// Horizontal size of the region, for leaning by place.
double reach(const Layer& layer) {
  switch (layer.region_shape) {
    case RegionShape::point: return 0.0;
    case RegionShape::square: return 0.5 * layer.region_length_m * std::sqrt(2.0);
    case RegionShape::line: return 0.5 * layer.region_length_m;
    case RegionShape::box: return 0.5 * std::sqrt(layer.region_length_m * layer.region_length_m + layer.region_width_m * layer.region_width_m);
    default: return layer.region_radius_m;
  }
}

/// Angle from the principal direction, as sine and cosine.
Turn lean(const Emission& e, double part, double place_radius) {
  const Layer& layer = e.layer;
  switch (layer.angle_distribution) {
    case AngleDistribution::normal: {
      const double deviations = inverseNormal(0.5 + 0.5 * kWithinTwoDeviations * part);
      return turn(std::min(layer.ejection_angle_rad, 0.5 * layer.ejection_angle_rad * deviations));
    }
    case AngleDistribution::uniform: {
      const double cosine = 1.0 - part * (1.0 - e.cosine_limit);
      return {std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), cosine};
    }
    case AngleDistribution::place: {
      const double whole = reach(layer);
      const double share = whole > 0.0 ? std::min(1.0, place_radius / whole) : part;
      // A cone of a right angle or more has no tangent; there the angle itself grows with the place.
      if (layer.ejection_angle_rad >= 0.5 * kPi - 1e-6) return turn(share * layer.ejection_angle_rad);
      const double tangent = share * e.tangent_limit, cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
      return {tangent * cosine, cosine};
    }
  }
  return {};
}

Vec3 directionFor(const Emission& e, const Vec3& offset, double angle_part, double azimuth_part) {
  if (e.neutral) return onSphere(angle_part, azimuth_part);
  const double across = dot(offset, e.east), along = dot(offset, e.south);
  const double radius = std::sqrt(across * across + along * along);
  const Turn tilt = lean(e, angle_part, radius);
  const Turn side = e.layer.outward && radius > 1e-9 ? Turn{along / radius, across / radius} : turn(kTwoPi * azimuth_part);
  return tilt.cosine * e.axis + tilt.sine * (side.cosine * e.east + side.sine * e.south);
}

double draw(Distribution distribution, double mean, double deviation, double part) {
  const double departure = distribution == Distribution::normal ? inverseNormal(part) : 2.0 * part - 1.0;
  return std::max(0.0, mean + deviation * departure);
}

}  // namespace

Emission::Emission(const Preset& preset, const Layer& the_layer, bool parented) : layer(the_layer), has_parent(parented) {
  neutral = layer.directionality == Directionality::neutral || (layer.directionality == Directionality::burst && preset.burst == BurstKind::air && !has_parent);
  mirror = preset.burst == BurstKind::ground && !has_parent && (layer.collide || layer.follow_ground);
  centred_height = preset.burst == BurstKind::air || has_parent;

  axis = unit(layer.direction);
  // The shortest turn from straight up to the axis carries east and south along (Rodrigues); straight down turns about east.
  if (axis.y > -1.0 + 1e-12) {
    const double f = 1.0 / (1.0 + axis.y);
    east = {1.0 - f * axis.x * axis.x, -axis.x, -f * axis.x * axis.z};
    south = {-f * axis.x * axis.z, -axis.z, 1.0 - f * axis.z * axis.z};
  } else {
    east = {1.0, 0.0, 0.0};
    south = {0.0, 0.0, -1.0};
  }
  const Turn limit = turn(layer.ejection_angle_rad);
  cosine_limit = limit.cosine;
  tangent_limit = limit.cosine > 1e-9 ? limit.sine / limit.cosine : 0.0;
}

Launch launch(const Emission& e, const ParticleIdentity& identity, double place_above) {
  const Layer& layer = e.layer;
  const auto d0 = uniformBlock(identity, 0), d1 = uniformBlock(identity, 1), d2 = uniformBlock(identity, 2);
  Launch out;
  Vec3 offset = placeIn(layer, d0[0], d0[1], d0[2]);
  if (!e.centred_height && (layer.region_shape == RegionShape::box || layer.region_shape == RegionShape::cylinder)) offset.y += 0.5 * layer.region_height_m;
  out.place = offset + layer.region_offset_m;
  // A ball buried in the ground of a ground burst is folded up, which keeps it uniform.
  if (e.mirror && out.place.y + place_above < 0.0) out.place.y = -(out.place.y + place_above) - place_above;

  const double speed = draw(layer.speed_distribution, layer.speed_mean_mps, layer.speed_deviation_mps, d0[3]);
  out.velocity = speed * directionFor(e, offset, d1[0], d1[1]);
  out.size_m = draw(layer.size_distribution, layer.size_mean_m, layer.size_deviation_m, d1[2]);
  out.lifetime_s = draw(Distribution::normal, layer.lifetime_mean_s, layer.lifetime_deviation_s, d1[3]);
  out.axis = onSphere(d2[0], d2[1]);
  out.phase_rad = kTwoPi * d2[2];
  out.rate_radps = layer.spin_mean_radps + layer.spin_deviation_radps * inverseNormal(d2[3]);
  if (layer.duration_s > 0.0) out.birth_part = uniformBlock(identity, 3)[0];
  return out;
}

}  // namespace npsee::explosion
