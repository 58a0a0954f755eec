#include "app/render/smoke_shade.h"

#include "app/render/frame_particles.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

constexpr double kBallShare = 0.8, kSoot = 0.25;
constexpr float kUpShare = 0.36f, kSideShare = 0.16f;
/// Where a puff's lit and far sides are looked at, in radii from its middle.
constexpr double kSide = 0.75;

/// How much a form takes part.
double absorbs(Form form) { return form == Form::smoke ? 1.0 : form == Form::fire ? kSoot : 0.0; }

template <class Take>
void forPuffs(const Frame& frame, std::span<const LayerSpan> layers, const Take& take) {
  for (const LayerSpan& layer : layers) {
    const double share = absorbs(layer.form);
    if (share <= 0.0) continue;
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i)
      if (frame.size[i] > 0.0f && frame.a[i] > 0.004f)
        take(placeOf(frame, i), 0.5 * static_cast<double>(frame.size[i]), share * opticalDepthOf(std::min(static_cast<double>(frame.a[i]), 1.0)));
  }
}

double part(const Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

void SmokeShade::fit(const Frame& frame, std::span<const LayerSpan> layers) {
  bool any = false;
  Vec3 low, high;
  forPuffs(frame, layers, [&](const Vec3& at, double r, double) {
    const Vec3 a{at.x - r, at.y - r, at.z - r}, b{at.x + r, at.y + r, at.z + r};
    low = any ? Vec3{std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)} : a;
    high = any ? Vec3{std::max(high.x, b.x), std::max(high.y, b.y), std::max(high.z, b.z)} : b;
    any = true;
  });
  sigma_.clear();
  const Vec3 size = high - low;
  const bool sane = any && std::isfinite(size.x + size.y + size.z) && size.x + size.y + size.z < 1e7;
  if (!sane) return;
  // Never so thin in one direction that the others get cells without end.
  const double least = std::max({size.x, size.y, size.z}) / 64.0 + 1e-6;
  cell_m_ = std::cbrt(std::max(size.x, least) * std::max(size.y, least) * std::max(size.z, least) / kMostCells);
  // An empty cell around it, so that sums begin at nothing.
  corner_ = {low.x - cell_m_, low.y - cell_m_, low.z - cell_m_};
  for (std::size_t axis = 0; axis < 3; ++axis) count_[axis] = static_cast<int>(part(size, axis) / cell_m_) + 3;
  step_ = {1, static_cast<std::ptrdiff_t>(count_[0]) * count_[2], count_[0]};
  sigma_.assign(static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]), 0.0f);
}

void SmokeShade::add(const Vec3& place, double radius_m, double depth) {
  const double reach = std::max(0.9 * radius_m, cell_m_);
  std::array<int, 3> first{};
  double sum[3] = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = (part(place, axis) - part(corner_, axis)) / cell_m_ - 0.5, cells = reach / cell_m_;
    first[axis] = std::max(static_cast<int>(std::ceil(at - cells)), 0);
    const int last = std::min(static_cast<int>(std::floor(at + cells)), count_[axis] - 1);
    std::vector<float>& weights = weights_[axis];
    weights.clear();
    for (int i = first[axis]; i <= last; ++i) {
      const double d = (i - at) / cells;
      weights.push_back(static_cast<float>(std::max(1.0 - d * d, 0.0)));
      sum[axis] += static_cast<double>(weights.back());
    }
  }
  const double all = sum[0] * sum[1] * sum[2];
  if (!(all > 0.0)) return;
  const auto scale = static_cast<float>(kBallShare * depth * radius_m * radius_m / (all * cell_m_ * cell_m_ * cell_m_));
  for (std::size_t j = 0; j < weights_[1].size(); ++j)
    for (std::size_t k = 0; k < weights_[2].size(); ++k) {
      const float w = scale * weights_[1][j] * weights_[2][k];
      float* row = sigma_.data() + step_[1] * (first[1] + static_cast<int>(j)) + step_[2] * (first[2] + static_cast<int>(k)) + first[0];
      for (std::size_t i = 0; i < weights_[0].size(); ++i) row[i] += w * weights_[0][i];
    }
}

void SmokeShade::sweepSun(const Vec3& sun) {
  sun_ = sun;
  // Slices across the axis that the sun is nearest to; the upstream place of a cell is one slice up and a constant way aside.
  std::size_t m = 1;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{2}})
    if (std::abs(part(sun, axis)) > std::abs(part(sun, m))) m = axis;
  const std::size_t a = m == 0 ? 2 : 0, b = m == 1 ? 2 : 1;
  const double along = part(sun, m), side_a = part(sun, a) / std::abs(along), side_b = part(sun, b) / std::abs(along);
  const int shift_a = static_cast<int>(std::floor(side_a)), shift_b = static_cast<int>(std::floor(side_b));
  const auto fa = static_cast<float>(side_a - shift_a), fb = static_cast<float>(side_b - shift_b);
  const auto half = static_cast<float>(0.5 * cell_m_ / std::abs(along));
  sun_depth_.assign(sigma_.size(), 0.0f);
  const int slices = count_[m], up = along > 0.0 ? 1 : -1;
  for (int s = 1; s < slices; ++s) {
    const int slice = up > 0 ? slices - 1 - s : s;
    for (int j = 0; j < count_[b]; ++j)
      for (int i = 0; i < count_[a]; ++i) {
        const auto above = [&](int ia, int ib) {
          if (ia < 0 || ib < 0 || ia >= count_[a] || ib >= count_[b]) return 0.0f;
          const auto at = static_cast<std::size_t>(step_[m] * (slice + up) + step_[a] * ia + step_[b] * ib);
          return sun_depth_[at] + half * sigma_[at];
        };
        const int ia = i + shift_a, ib = j + shift_b;
        const float low = above(ia, ib) * (1.0f - fa) + above(ia + 1, ib) * fa, high = above(ia, ib + 1) * (1.0f - fa) + above(ia + 1, ib + 1) * fa;
        const auto at = static_cast<std::size_t>(step_[m] * slice + step_[a] * i + step_[b] * j);
        sun_depth_[at] = low * (1.0f - fb) + high * fb + half * sigma_[at];
      }
  }
}

void SmokeShade::sweepSide(std::size_t axis, bool from_end, float share) {
  const std::size_t a = axis == 0 ? 2 : 0, b = axis == 1 ? 2 : 1;
  const auto half = static_cast<float>(0.5 * cell_m_);
  for (int j = 0; j < count_[b]; ++j)
    for (int i = 0; i < count_[a]; ++i) {
      float depth = 0.0f;
      for (int k = 0; k < count_[axis]; ++k) {
        const int cell = from_end ? count_[axis] - 1 - k : k;
        const auto at = static_cast<std::size_t>(step_[axis] * cell + step_[a] * i + step_[b] * j);
        const float own = half * sigma_[at];
        sky_[at] += share * leftThrough(depth + own);
        depth += 2.0f * own;
      }
    }
}

void SmokeShade::sweepSky() {
  sky_.assign(sigma_.size(), 0.0f);
  sweepSide(1, true, kUpShare);
  for (const std::size_t axis : {std::size_t{0}, std::size_t{2}})
    for (const bool from_end : {false, true}) sweepSide(axis, from_end, kSideShare);
}

void SmokeShade::build(const Frame& frame, std::span<const LayerSpan> layers, const Vec3& towards_sun) {
  fit(frame, layers);
  eye_depth_.clear();
  if (sigma_.empty()) return;
  forPuffs(frame, layers, [&](const Vec3& at, double r, double depth) { add(at, r, depth); });
  sweepSun(towards_sun);
  sweepSky();
}

double SmokeShade::sample(const std::vector<float>& cells, const Vec3& place) const {
  double f[3];
  std::array<int, 3> c{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = std::clamp((part(place, axis) - part(corner_, axis)) / cell_m_ - 0.5, 0.0, count_[axis] - 1.001);
    c[axis] = static_cast<int>(at);
    f[axis] = at - c[axis];
  }
  const float* base = cells.data() + step_[0] * c[0] + step_[1] * c[1] + step_[2] * c[2];
  const auto row = [&](std::ptrdiff_t offset) { return static_cast<double>(base[offset]) * (1.0 - f[0]) + static_cast<double>(base[offset + 1]) * f[0]; };
  const double low = row(0) * (1.0 - f[2]) + row(step_[2]) * f[2], high = row(step_[1]) * (1.0 - f[2]) + row(step_[1] + step_[2]) * f[2];
  return low * (1.0 - f[1]) + high * f[1];
}

void SmokeShade::lookFrom(const Vec3& eye) {
  eye_depth_.clear();
  if (sigma_.empty()) return;
  eye_ = eye;
  const Vec3 size{cell_m_ * count_[0], cell_m_ * count_[1], cell_m_ * count_[2]}, from = eye - (corner_ + 0.5 * size);
  std::size_t m = 0;
  for (const std::size_t axis : {std::size_t{1}, std::size_t{2}})
    if (std::abs(part(from, axis)) > std::abs(part(from, m))) m = axis;
  if (std::abs(part(from, m)) < 0.5 * part(size, m) + cell_m_) return;
  const std::size_t a = m == 0 ? 2 : 0, b = m == 1 ? 2 : 1;
  const int slices = count_[m], up = part(from, m) > 0.0 ? 1 : -1;
  eye_depth_.assign(sigma_.size(), 0.0f);
  // As the sun's, but rays come together at the eye: the way aside differs from cell to cell.
  for (int s = 1; s < slices; ++s) {
    const int slice = up > 0 ? slices - 1 - s : s;
    const double ahead = std::abs(part(eye, m) - (part(corner_, m) + (slice + 0.5) * cell_m_));
    for (int j = 0; j < count_[b]; ++j) {
      const double side_b = (part(eye, b) - (part(corner_, b) + (j + 0.5) * cell_m_)) / ahead, to_b = std::clamp(j + side_b, 0.0, count_[b] - 1.001);
      const int ib = static_cast<int>(to_b);
      const auto fb = static_cast<float>(to_b - ib);
      for (int i = 0; i < count_[a]; ++i) {
        const double side_a = (part(eye, a) - (part(corner_, a) + (i + 0.5) * cell_m_)) / ahead, to_a = std::clamp(i + side_a, 0.0, count_[a] - 1.001);
        const int ia = static_cast<int>(to_a);
        const auto fa = static_cast<float>(to_a - ia), half = static_cast<float>(0.5 * cell_m_ * std::sqrt(1.0 + side_a * side_a + side_b * side_b));
        const auto above = [&](int x, int y) {
          const auto at = static_cast<std::size_t>(step_[m] * (slice + up) + step_[a] * x + step_[b] * y);
          return eye_depth_[at] + half * sigma_[at];
        };
        const float low = above(ia, ib) * (1.0f - fa) + above(ia + 1, ib) * fa, high = above(ia, ib + 1) * (1.0f - fa) + above(ia + 1, ib + 1) * fa;
        const auto at = static_cast<std::size_t>(step_[m] * slice + step_[a] * i + step_[b] * j);
        eye_depth_[at] = low * (1.0f - fb) + high * fb + half * sigma_[at];
      }
    }
  }
}

bool SmokeShade::hidden(const Vec3& place, double radius_m, const Vec3& right, const Vec3& up) const {
  if (eye_depth_.empty()) return false;
  const double away = length(eye_ - place);
  const Vec3 near = place + (0.5 * radius_m / std::max(away, radius_m)) * (eye_ - place);
  if (sample(eye_depth_, near) < kHidden) return false;
  for (const Vec3& aside : {right, -1.0 * right, up, -1.0 * up})
    if (sample(eye_depth_, near + (0.8 * radius_m) * aside) < kHidden) return false;
  return true;
}

PuffLight SmokeShade::at(const Vec3& place, double radius_m) const {
  if (sigma_.empty()) return {};
  const Vec3 way = (kSide * radius_m) * sun_;
  return {static_cast<float>(sample(sun_depth_, place + way)), static_cast<float>(sample(sun_depth_, place - way)), static_cast<float>(sample(sky_, place))};
}

}  // namespace npsee::render
