#include "app/render/template_drawing.h"

namespace npsee::render {
namespace {

/// Lines on the surface are drawn this much nearer to the eye (template units), or its facets would cut them.
constexpr double kLift = 0.012;

}  // namespace

std::vector<StrokeVertex> strokeTriangles(const std::vector<Stroke>& strokes, const TemplateCamera& camera, int width, int height) {
  std::vector<StrokeVertex> out;
  StrokeBuilder builder(width, height, out);
  const std::array<float, 16> matrix = camera.viewProjection();
  const auto seen = [&](const Vec3& point) -> StrokePoint {
    const TemplateCamera::Pixel pixel = camera.project(point);
    const Vec3 p = point - kLift * camera.forward();
    // The precision of the surface's own vertices, or the two would flicker through each other.
    const auto row = [&](std::size_t r) { return static_cast<float>(static_cast<double>(matrix[r]) * p.x + matrix[4 + r] * p.y + matrix[8 + r] * p.z + matrix[12 + r]); };
    return {pixel.x, pixel.y, row(2), row(3)};
  };
  std::vector<StrokePoint> points;
  for (const Stroke& stroke : strokes) {
    points.clear();
    for (const Vec3& point : stroke.points) points.push_back(seen(point));
    builder.add(points, stroke.style, stroke.points.size() > 1 && stroke.points.front() == stroke.points.back());
  }
  return out;
}

}  // namespace npsee::render
