#include "app/render/template_camera.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace npsee::render {
namespace {

// A narrow view keeps sides that lean alike looking alike.
constexpr double kFieldOfView = 0.42;
// Room for lines and handles at the rim; round a ball also for what stands on the base plane below it.
constexpr double kMargin = 1.06, kBallMargin = 1.22;

/// Azimuth whose direction from the axis lies furthest from the line of sight, on the right.
double sideAzimuth(const nurbs::Affine& frame, const Vec3& forward, const Vec3& right) {
  Vec3 side = cross(forward, frame.y);
  // Seen along the axis every side is as good.
  if (length(side) < 1e-6 * length(frame.y)) side = right;
  if (dot(side, right) < 0.0) side = -1.0 * side;
  return std::atan2(-dot(frame.z, side), dot(frame.x, side));
}

/// Distance at which the largest ball touches the edges of a view with this tangent of half its angle.
double ballDistance(double half) { return kBallMargin * kLargestBall / std::sin(std::atan(half)); }

/// The handle as it would be for a parameter at a fraction 0..1 of its path.
Vec3 handleAt(TemplateShape& shape, TemplateHandle which, double share, double azimuth) {
  constexpr double kTopSpeed = 2500.0, kTopExtent = 400.0;  // almost the whole of the paths
  if (which == TemplateHandle::rim) shape.lean_rad = share * kPi / 2.0;
  if (which == TemplateHandle::top) shape.height = std::lerp(templateHeight(0.0), templateHeight(kTopSpeed), share);
  if (which == TemplateHandle::foot) {
    const bool round = shape.foot_x == shape.foot_z;
    shape.foot_x = std::lerp(templateFoot(0.0), templateFoot(kTopExtent), share);
    if (round) shape.foot_z = shape.foot_x;
  }
  return shape.handle(which, azimuth);
}

}  // namespace

TemplateCamera::TemplateCamera(const TemplateShape& shape, double yaw_rad, double pitch_rad, int width, int height) : width_(width), height_(height) {
  const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad), cy = std::cos(yaw_rad), sy = std::sin(yaw_rad);
  forward_ = {-sy * cp, -sp, -cy * cp};
  right_ = {cy, 0.0, -sy};
  up_ = cross(right_, forward_);
  azimuth_ = sideAzimuth(shape.frame, forward_, right_);
  const double half = std::tan(0.5 * kFieldOfView), half_x = half * width_ / height_;
  const double distance = shape.ball ? ballDistance(std::min(half, half_x)) : cupDistance(shape, half_x, half);
  eye_ = templateCentre(shape) - distance * forward_;
  focal_ = 1.0 / half;
  near_ = std::max(0.02 * distance, distance - 4.0);
  far_ = distance + 6.0;
}

double TemplateCamera::cupDistance(const TemplateShape& shape, double half_x, double half_y) const {
  constexpr int kAround = 48;
  const Vec3 centre = templateCentre(shape);
  double distance = 0.0;
  for (int i = 0; i < kAround; ++i) {
    // Places count from the side of the view, so that the distance stays the same when it turns.
    const double angle = azimuth_ + kTwoPi * i / kAround;
    for (const double y : {0.0, kLargestCupHeight}) {
      const Vec3 turned = shape.frame({kLargestCupRadius * std::cos(angle), y, -kLargestCupRadius * std::sin(angle)}) - shape.origin;
      const Vec3 p = (kMargin / shape.scale) * turned + shape.origin - centre;
      distance = std::max({distance, std::fabs(dot(p, right_)) / half_x - dot(p, forward_), std::fabs(dot(p, up_)) / half_y - dot(p, forward_)});
    }
  }
  return distance;
}

TemplateCamera::Pixel TemplateCamera::project(const Vec3& point) const {
  const Vec3 p = point - eye_;
  const double distance = dot(p, forward_), scale = 0.5 * height_ * focal_ / std::max(distance, near_);
  return {0.5 * width_ + scale * dot(p, right_), 0.5 * height_ - scale * dot(p, up_), distance};
}

TemplateHandle TemplateCamera::handleNear(const TemplateShape& shape, double x, double y, double reach) const {
  TemplateHandle best = TemplateHandle::none;
  double least = reach;
  for (const TemplateHandle which : {TemplateHandle::rim, TemplateHandle::top, TemplateHandle::foot}) {
    if (!shape.hasHandle(which)) continue;
    const Pixel at = project(shape.handle(which, azimuth_));
    const double away = std::hypot(at.x - x, at.y - y);
    if (away <= least) {
      least = away;
      best = which;
    }
  }
  return best;
}

double TemplateCamera::dragged(const TemplateShape& shape, TemplateHandle which, double x, double y) const {
  TemplateShape trial = shape;
  const auto away = [&](double share) {
    const Pixel at = project(handleAt(trial, which, share, azimuth_));
    return std::hypot(at.x - x, at.y - y);
  };
  // The path may bend in the picture, so the best of a coarse search is refined between its neighbours.
  constexpr int kSteps = 64;
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i)
    if (const double d = away(static_cast<double>(i) / kSteps); d < least) {
      least = d;
      best = i;
    }
  double low = std::max(0, best - 1) / static_cast<double>(kSteps), high = std::min(kSteps, best + 1) / static_cast<double>(kSteps);
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    (away(a) <= away(b) ? high : low) = away(a) <= away(b) ? b : a;
  }
  const Vec3 point = handleAt(trial, which, 0.5 * (low + high), azimuth_);
  return shape.valueAt(which, point, azimuth_);
}

Vec3 TemplateCamera::lamp() const {
  const Vec3 towards = 0.75 * up_ - 0.55 * right_ - 0.75 * forward_;
  return (1.0 / length(towards)) * towards;
}

std::array<float, 16> TemplateCamera::viewProjection() const {
  const double fx = focal_ * height_ / width_, fy = focal_;
  const double a = (far_ + near_) / (far_ - near_), b = -2.0 * far_ * near_ / (far_ - near_);
  const Vec3 rows[3] = {fx * right_, fy * up_, a * forward_};
  const double offsets[3] = {-dot(rows[0], eye_), -dot(rows[1], eye_), b - dot(rows[2], eye_)};
  std::array<float, 16> out{};
  for (int r = 0; r < 3; ++r) {
    out[r] = static_cast<float>(rows[r].x);
    out[4 + r] = static_cast<float>(rows[r].y);
    out[8 + r] = static_cast<float>(rows[r].z);
    out[12 + r] = static_cast<float>(offsets[r]);
  }
  out[3] = static_cast<float>(forward_.x);
  out[7] = static_cast<float>(forward_.y);
  out[11] = static_cast<float>(forward_.z);
  out[15] = static_cast<float>(-dot(forward_, eye_));
  return out;
}

}  // namespace npsee::render
