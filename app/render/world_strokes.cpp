#include "app/render/world_strokes.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

/// Lines outside the picture by more than this are left out, pixels.
constexpr double kAround_px = 4000.0;

/// A place in camera coordinates.
struct Seen {
  double right, up, depth;
};

class Projector {
 public:
  explicit Projector(const MissionEye& eye) : eye_(eye), scale_(0.5 * eye.height / std::tan(0.5 * eye.lens.fov_y_rad)) {}

  Seen seen(const Vec3& world, double nearer) const {
    const Vec3 from = (1.0 - nearer) * (world - eye_.lens.eye);
    return {dot(eye_.lens.right, from), dot(eye_.lens.up, from), -dot(eye_.lens.back, from)};
  }
  double nearest() const { return 1.01 * eye_.lens.near_m; }
  StrokePoint point(const Seen& s) const {
    const double n = eye_.lens.near_m, f = eye_.lens.far_m;
    return {0.5 * eye_.width * (1.0 + eye_.lens.aside_x) + scale_ * s.right / s.depth, 0.5 * eye_.height * (1.0 - eye_.lens.aside_y) - scale_ * s.up / s.depth, ((f + n) * s.depth - 2.0 * f * n) / (f - n), s.depth};
  }

 private:
  const MissionEye& eye_;
  double scale_;
};

bool near(const StrokePoint& p, const MissionEye& eye) { return p.x > -kAround_px && p.y > -kAround_px && p.x < eye.width + kAround_px && p.y < eye.height + kAround_px; }

/// Whether both ends are beyond the same side of the picture.
bool aside(const StrokePoint& a, const StrokePoint& b, const MissionEye& eye) {
  const double m = 40.0;
  return (a.x < -m && b.x < -m) || (a.y < -m && b.y < -m) || (a.x > eye.width + m && b.x > eye.width + m) || (a.y > eye.height + m && b.y > eye.height + m);
}

}  // namespace

void addStrokes(const std::vector<WorldStroke>& strokes, const MissionEye& eye, std::vector<StrokeVertex>& out) {
  const Projector projector(eye);
  StrokeBuilder builder(eye.width, eye.height, out);
  std::vector<StrokePoint> run;
  const auto finish = [&](const StrokeStyle& style) {
    if (run.size() > 1) builder.add(run, style);
    run.clear();
  };
  for (const WorldStroke& stroke : strokes) {
    if (stroke.points.size() == 1) {
      const Seen s = projector.seen(stroke.points[0], stroke.nearer);
      if (s.depth > projector.nearest() && near(projector.point(s), eye)) builder.add({projector.point(s)}, stroke.style);
      continue;
    }
    for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
      Seen a = projector.seen(stroke.points[i], stroke.nearer), b = projector.seen(stroke.points[i + 1], stroke.nearer);
      const double least = projector.nearest();
      if (a.depth < least && b.depth < least) {
        finish(stroke.style);
        continue;
      }
      // Cut at the near plane.
      const auto cut = [&](const Seen& behind, const Seen& front) {
        const double t = (least - behind.depth) / (front.depth - behind.depth);
        return Seen{behind.right + t * (front.right - behind.right), behind.up + t * (front.up - behind.up), least};
      };
      const bool entered = a.depth < least, left = b.depth < least;
      if (entered) a = cut(a, b);
      if (left) b = cut(b, a);
      const StrokePoint from = projector.point(a), to = projector.point(b);
      if (aside(from, to, eye) || !near(from, eye) || !near(to, eye)) {
        finish(stroke.style);
        continue;
      }
      if (entered) finish(stroke.style);
      if (run.empty()) run.push_back(from);
      run.push_back(to);
      if (left) finish(stroke.style);
    }
    finish(stroke.style);
  }
}

void addStrokes(const std::vector<ScreenStroke>& strokes, int width, int height, std::vector<StrokeVertex>& out) {
  StrokeBuilder builder(width, height, out);
  std::vector<StrokePoint> points;
  for (const ScreenStroke& stroke : strokes) {
    points.clear();
    for (const auto& [x, y] : stroke.points) points.push_back({x, y, -1.0, 1.0});
    builder.add(points, stroke.style);
  }
}

namespace {

/// Letters of our own as strokes on a grid 4 wide and 6 high, y up.
struct Letter {
  char name;
  const char* strokes;  ///< points "xy", strokes separated by a space
};
constexpr Letter kLetters[] = {
    {'0', "103041453616050110"}, {'1', "152620 1030"},           {'2', "051636454403020040"},  {'3', "0516364544334241301001 1333"},
    {'4', "3036020242"},         {'5', "460603334241301001"},     {'6', "4536160501103041423303"}, {'7', "06464410"},
    {'8', "13040516364544331302011030414233"}, {'9', "0110304145361605041343"}, {'-', "1333"},   {'+', "1333 2224"},
    {'.', "2021"},               {'/', "0046"},                   {':', "2122 2425"},         {',', "2110"}};

}  // namespace

void addText(std::string_view text, double x, double y, double height_px, bool centred, const StrokeStyle& style, std::vector<ScreenStroke>& out) {
  const double unit = height_px / 6.0, advance = 5.6 * unit;
  double left = centred ? x - 0.5 * (advance * static_cast<double>(text.size()) - 1.6 * unit) : x;
  for (const char c : text) {
    const auto* letter = std::ranges::find(kLetters, c, &Letter::name);
    if (letter != std::end(kLetters)) {
      ScreenStroke stroke{{}, style};
      for (const char* p = letter->strokes; *p != '\0';) {
        if (*p == ' ' || p[1] == '\0' || p[1] == ' ') {
          if (stroke.points.size() > 1) out.push_back(stroke);
          stroke.points.clear();
          ++p;
          continue;
        }
        stroke.points.emplace_back(left + (p[0] - '0') * unit, y - (p[1] - '0') * unit);
        p += 2;
      }
      if (stroke.points.size() > 1) out.push_back(stroke);
    }
    left += advance;
  }
}

}  // namespace npsee::render
