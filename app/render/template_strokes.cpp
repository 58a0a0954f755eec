#include "app/render/template_drawing.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

/// Lines on the surface are drawn this much nearer to the eye (template units), or its facets would cut them.
constexpr double kLift = 0.012;
/// Room for the soft edge, pixels.
constexpr double kFeather = 1.0;
/// Sharper corners than this are cut off, or their tips would reach far out.
constexpr double kMitreLimit = 2.0;

struct Pixel2 {
  double x = 0.0, y = 0.0;
};
Pixel2 operator-(const Pixel2& a, const Pixel2& b) { return {a.x - b.x, a.y - b.y}; }
Pixel2 operator+(const Pixel2& a, const Pixel2& b) { return {a.x + b.x, a.y + b.y}; }
Pixel2 operator*(double s, const Pixel2& a) { return {s * a.x, s * a.y}; }

/// Unit vector across a line from a to b; zero if they coincide.
Pixel2 across(const Pixel2& a, const Pixel2& b) {
  const Pixel2 d = b - a;
  const double size = std::hypot(d.x, d.y);
  return size > 1e-9 ? Pixel2{-d.y / size, d.x / size} : Pixel2{};
}

/// Where both neighbouring edges of a line meet, per unit of half width.
Pixel2 mitre(const Pixel2& before, const Pixel2& after) {
  const Pixel2 sum = before + after;
  const double square = sum.x * sum.x + sum.y * sum.y;
  if (square < 1e-9) return after;
  const Pixel2 out = (2.0 / square) * sum;
  const double size = std::hypot(out.x, out.y);
  return size > kMitreLimit ? (kMitreLimit / size) * out : out;
}

class Builder {
 public:
  Builder(const TemplateCamera& camera, int width, int height) : camera_(camera), matrix_(camera.viewProjection()), width_(width), height_(height) {}

  void add(const Stroke& stroke) {
    if (stroke.points.size() == 1) addDot(stroke);
    if (stroke.points.size() > 1) addLine(stroke);
  }
  std::vector<StrokeVertex> take() { return std::move(out_); }

 private:
  struct Corner {
    Pixel2 at;
    std::array<float, 4> clip;  ///< only z and w are used; x and y follow from the pixel
  };

  Corner corner(const Vec3& point) const {
    const TemplateCamera::Pixel pixel = camera_.project(point);
    const Vec3 p = point - kLift * camera_.forward();
    const auto row = [&](int r) { return static_cast<double>(matrix_[r]) * p.x + matrix_[4 + r] * p.y + matrix_[8 + r] * p.z + matrix_[12 + r]; };
    return {{pixel.x, pixel.y}, {0.0f, 0.0f, static_cast<float>(row(2)), static_cast<float>(row(3))}};
  }

  StrokeVertex vertexAt(const StrokeStyle& style, const Corner& corner, const Pixel2& moved, double offset_x, double offset_y) const {
    StrokeVertex out;
    const Pixel2 at = corner.at + moved;
    const double w = corner.clip[3];
    out.clip = {static_cast<float>((2.0 * at.x / width_ - 1.0) * w), static_cast<float>((1.0 - 2.0 * at.y / height_) * w), corner.clip[2], corner.clip[3]};
    out.offset = {static_cast<float>(offset_x), static_cast<float>(offset_y)};
    out.half_width = static_cast<float>(0.5 * style.width_px);
    out.dash_px = static_cast<float>(style.dash_px);
    out.colour = {static_cast<float>(style.colour.r), static_cast<float>(style.colour.g), static_cast<float>(style.colour.b), static_cast<float>(style.opacity)};
    out.hidden = static_cast<float>(style.hidden);
    return out;
  }

  void addQuad(const std::array<StrokeVertex, 4>& corners) {
    for (const int k : {0, 1, 2, 0, 2, 3}) out_.push_back(corners[static_cast<std::size_t>(k)]);
  }

  void addDot(const Stroke& stroke) {
    const Corner middle = corner(stroke.points[0]);
    const double r = 0.5 * stroke.style.width_px + kFeather;
    std::array<StrokeVertex, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = k == 0 || k == 3 ? -r : r, y = k < 2 ? -r : r;
      corners[k] = vertexAt(stroke.style, middle, {x, y}, x, y);
    }
    addQuad(corners);
  }

  void addLine(const Stroke& stroke) {
    std::vector<Corner> corners;
    for (const Vec3& point : stroke.points) corners.push_back(corner(point));
    const std::size_t count = corners.size();
    const bool closed = stroke.points.front() == stroke.points.back();
    const double r = 0.5 * stroke.style.width_px + kFeather;
    double along = 0.0;
    std::array<StrokeVertex, 2> before;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t previous = i > 0 ? i - 1 : closed ? count - 2 : 0, next = i + 1 < count ? i + 1 : closed ? 1 : i;
      const Pixel2 in = across(corners[previous].at, corners[i].at), out = across(corners[i].at, corners[next].at);
      const Pixel2 m = r * mitre(in.x == 0.0 && in.y == 0.0 ? out : in, out.x == 0.0 && out.y == 0.0 ? in : out);
      std::array<StrokeVertex, 2> now{vertexAt(stroke.style, corners[i], m, 0.0, r), vertexAt(stroke.style, corners[i], -1.0 * m, 0.0, -r)};
      if (i > 0) along += std::hypot(corners[i].at.x - corners[i - 1].at.x, corners[i].at.y - corners[i - 1].at.y);
      for (StrokeVertex& side : now) side.along_px = static_cast<float>(along);
      if (i > 0) addQuad({before[0], before[1], now[1], now[0]});
      before = now;
    }
  }

  const TemplateCamera& camera_;
  std::array<float, 16> matrix_;
  double width_, height_;
  std::vector<StrokeVertex> out_;
};

}  // namespace

std::vector<StrokeVertex> strokeTriangles(const std::vector<Stroke>& strokes, const TemplateCamera& camera, int width, int height) {
  Builder builder(camera, width, height);
  for (const Stroke& stroke : strokes) builder.add(stroke);
  return builder.take();
}

}  // namespace npsee::render
