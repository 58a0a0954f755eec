#include "app/render/strokes.h"

#include <cmath>

namespace npsee::render {
namespace {

/// Room for the soft edge, pixels.
constexpr double kFeather_px = 1.0;
/// Sharper corners than this are cut off, or their tips would reach far out.
constexpr double kMitreLimit = 2.0;

struct Step {
  double x = 0.0, y = 0.0;
  bool none() const { return x == 0.0 && y == 0.0; }
};
Step operator*(double s, const Step& a) { return {s * a.x, s * a.y}; }

/// Unit vector across a line from a to b; zero if they coincide.
Step across(const StrokePoint& a, const StrokePoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, size = std::hypot(dx, dy);
  return size > 1e-9 ? Step{-dy / size, dx / size} : Step{};
}

/// Where the edges of a line's two parts meet, per unit of half width. A part without length has no edge.
Step mitre(const Step& before, const Step& after) {
  if (before.none()) return after;
  if (after.none()) return before;
  const Step sum{before.x + after.x, before.y + after.y};
  const double square = sum.x * sum.x + sum.y * sum.y;
  if (square < 1e-9) return after;
  const Step out = (2.0 / square) * sum;
  const double size = std::hypot(out.x, out.y);
  return size > kMitreLimit ? (kMitreLimit / size) * out : out;
}

}  // namespace

void StrokeBuilder::add(const std::vector<StrokePoint>& points, const StrokeStyle& style, bool closed) {
  if (points.size() == 1) addDot(points[0], style);
  if (points.size() > 1) addLine(points, style, closed);
}

StrokeVertex StrokeBuilder::vertex(const StrokePoint& at, double moved_x, double moved_y, double offset_x, double offset_y, const StrokeStyle& style) const {
  const auto f = [](double v) { return static_cast<float>(v); };
  StrokeVertex out;
  out.clip = {f((2.0 * (at.x + moved_x) / width_ - 1.0) * at.clip_w), f((1.0 - 2.0 * (at.y + moved_y) / height_) * at.clip_w), f(at.clip_z), f(at.clip_w)};
  out.offset = {f(offset_x), f(offset_y)};
  out.half_width = f(0.5 * style.width_px);
  out.dash_px = f(style.dash_px);
  out.colour = {f(style.colour.r), f(style.colour.g), f(style.colour.b), f(style.opacity)};
  out.hidden = f(style.hidden);
  return out;
}

void StrokeBuilder::addQuad(const StrokeVertex& a, const StrokeVertex& b, const StrokeVertex& c, const StrokeVertex& d) {
  for (const StrokeVertex* v : {&a, &b, &c, &a, &c, &d}) out_.push_back(*v);
}

void StrokeBuilder::addDot(const StrokePoint& at, const StrokeStyle& style) {
  const double r = 0.5 * style.width_px + kFeather_px;
  const auto corner = [&](double x, double y) { return vertex(at, x, y, x, y, style); };
  addQuad(corner(-r, -r), corner(r, -r), corner(r, r), corner(-r, r));
}

void StrokeBuilder::addLine(const std::vector<StrokePoint>& points, const StrokeStyle& style, bool closed) {
  const std::size_t count = points.size();
  const double r = 0.5 * style.width_px + kFeather_px;
  double along = 0.0;
  std::array<StrokeVertex, 2> before;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t previous = i > 0 ? i - 1 : closed ? count - 2 : i, next = i + 1 < count ? i + 1 : closed ? 1 : i;
    const Step m = r * mitre(across(points[previous], points[i]), across(points[i], points[next]));
    std::array<StrokeVertex, 2> now{vertex(points[i], m.x, m.y, 0.0, r, style), vertex(points[i], -m.x, -m.y, 0.0, -r, style)};
    if (i > 0) along += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    for (StrokeVertex& side : now) side.along_px = static_cast<float>(along);
    if (i > 0) addQuad(before[0], before[1], now[1], now[0]);
    before = now;
  }
}

}  // namespace npsee::render
