#include "app/render/template_drawing.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

constexpr Colour byte(int r, int g, int b) { return {r / 255.0, g / 255.0, b / 255.0}; }
constexpr TemplatePalette kOnDark{byte(0x5f, 0xb3, 0xd9), byte(0xf2, 0xa3, 0x3c), byte(0xd9, 0xdc, 0xe3), byte(0x8b, 0x92, 0xa0), byte(0x16, 0x18, 0x1c), byte(0x5f, 0xb3, 0xd9), byte(0x25, 0x44, 0x56)};
constexpr TemplatePalette kOnLight{byte(0x1f, 0x7a, 0xa6), byte(0xb8, 0x6a, 0x00), byte(0x24, 0x29, 0x33), byte(0x5d, 0x65, 0x73), byte(0xff, 0xff, 0xff), byte(0x6c, 0xbd, 0xe2), byte(0xdc, 0xea, 0xf2)};

const TemplatePalette& paletteOn(const Background& background) {
  const Colour& c = background.colour;
  // Luma as televisions weigh it; contrast only has to fall on the right side.
  return background.kind == Background::Kind::colour && 0.299 * c.r + 0.587 * c.g + 0.114 * c.b > 0.5 ? kOnLight : kOnDark;
}

using Strokes = std::vector<Stroke>;

std::vector<double> steps(const nurbs::KnotVector& knots, int count) {
  std::vector<double> out;
  for (int i = 0; i <= count; ++i) out.push_back(std::lerp(knots.first(), knots.last(), static_cast<double>(i) / count));
  return out;
}

std::array<float, 3> floats(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

TemplateMesh::Vertex vertex(const Vec3& position, const Vec3& normal) { return {floats(position), floats(normal)}; }

void addRing(Strokes& out, const nurbs::Surface& surface, double v, const StrokeStyle& style, int count = 96) {
  Stroke stroke{{}, style};
  for (const nurbs::SurfaceSample& sample : surface.grid(steps(surface.u(), count), {v})) stroke.points.push_back(sample.point);
  stroke.points.back() = stroke.points.front();
  out.push_back(std::move(stroke));
}

void addProfile(Strokes& out, const nurbs::Surface& surface, double u, const StrokeStyle& style, int count = 32) {
  Stroke stroke{{}, style};
  for (const nurbs::SurfaceSample& sample : surface.grid({u}, steps(surface.v(), count))) stroke.points.push_back(sample.point);
  out.push_back(std::move(stroke));
}

/// Circle or ellipse about a point, in a plane parallel to the base plane.
void addEllipse(Strokes& out, const Vec3& centre, double x, double z, const StrokeStyle& style) {
  Stroke stroke{{}, style};
  const nurbs::Curve circle = nurbs::unitCircle();
  for (const double u : steps(circle.knots(), 96)) {
    const Vec3 p = circle.at(u).point;
    stroke.points.push_back(centre + Vec3{x * p.x, 0.0, z * p.z});
  }
  stroke.points.back() = stroke.points.front();
  out.push_back(std::move(stroke));
}

void addControlNet(Strokes& out, const nurbs::Surface& surface, const TemplatePalette& palette) {
  const StrokeStyle line{palette.dim, 1.2, 0.75, 0.4, 4.0};
  const int around = surface.u().points(), along = surface.v().points();
  for (int j = 0; j < along; ++j) {
    Stroke stroke{{}, line};
    for (int i = 0; i < around; ++i) stroke.points.push_back(surface.control(i, j).position);
    out.push_back(std::move(stroke));
  }
  // The last column is the first again.
  for (int i = 0; i + 1 < around; ++i) {
    Stroke stroke{{}, line};
    for (int j = 0; j < along; ++j) stroke.points.push_back(surface.control(i, j).position);
    out.push_back(std::move(stroke));
  }
  for (int j = 0; j < along; ++j)
    for (int i = 0; i + 1 < around; ++i) out.push_back({{surface.control(i, j).position}, {palette.text, 5.5, 1.0, 0.45}});
}

void addSplines(Strokes& out, const TemplateShape& shape, const TemplatePalette& palette) {
  const nurbs::Surface& surface = shape.surface;
  const StrokeStyle curve{palette.geometry, 1.8, 1.0, 0.35};
  if (shape.ball)
    for (const double v : {0.25, 0.5, 0.75}) addRing(out, surface, v, curve);
  else
    for (const double v : {0.0, 0.3, 0.6, 0.8, 1.0}) addRing(out, surface, v, curve);
  for (int i = 0; i < 16; ++i) addProfile(out, surface, i / 16.0, curve);
  addControlNet(out, surface, palette);
}

void addFacetEdges(Strokes& out, const nurbs::Surface& surface, const TemplatePalette& palette) {
  const StrokeStyle edge{palette.geometry, 1.3, 1.0, 0.22};
  for (const double v : steps(surface.v(), kFacetsAlong)) addRing(out, surface, v, edge, kFacetsAround);
  for (int i = 0; i < kFacetsAround; ++i) addProfile(out, surface, static_cast<double>(i) / kFacetsAround, edge, kFacetsAlong);
}

/// Thin lines that help the eye read the shaded surface, and its rim.
void addSurfaceLines(Strokes& out, const TemplateShape& shape, const TemplatePalette& palette) {
  for (int i = 0; i < 24; ++i) addProfile(out, shape.surface, i / 24.0, {palette.text, 1.0, 0.10, 0.0});
  if (shape.ball) {
    for (const double v : {0.25, 0.5, 0.75}) addRing(out, shape.surface, v, {palette.text, 1.0, 0.10, 0.0});
    return;
  }
  addRing(out, shape.surface, 0.6, {palette.text, 1.0, 0.10, 0.0});
  addRing(out, shape.surface, 1.0, {palette.geometry, 2.0, 1.0, 0.35});
}

/// The axis with its tip, the foot, and what stands on the base plane.
void addScaffold(Strokes& out, const TemplateShape& shape, const TemplatePalette& palette) {
  const StrokeStyle line{palette.dim, 1.3, 0.8, 0.35};
  const Vec3 top = shape.handle(TemplateHandle::top);
  if (!shape.ball) {
    out.push_back({{shape.origin, top}, line});
    out.push_back({{top}, {palette.dim, 5.0, 0.9, 0.35}});
  }
  const StrokeStyle foot{palette.geometry, 1.6, 0.8, 0.35};
  if (shape.origin.y > 0.0) {
    const Vec3 below{shape.origin.x, 0.0, shape.origin.z};
    const Vec3 from = shape.ball ? shape.origin - Vec3{0.0, shape.ballRadius(), 0.0} : shape.origin;
    out.push_back({{from, below}, {palette.dim, 1.2, 0.7, 0.35, 4.0}});
    if (shape.ball) addEllipse(out, below, shape.scale * shape.foot_x, shape.scale * shape.foot_z, foot);
  }
  if (!shape.ball) addRing(out, shape.surface, 0.0, foot);
  if (shape.ball || shape.inner_foot <= 0.0) return;
  Stroke inner{{}, {palette.geometry, 1.2, 0.6, 0.3}};
  const nurbs::Curve circle = nurbs::unitCircle();
  for (const double u : steps(circle.knots(), 96)) inner.points.push_back(shape.frame(shape.inner_foot * circle.at(u).point));
  inner.points.back() = inner.points.front();
  out.push_back(std::move(inner));
}

/// The ejection angle as a surveyor draws it: the principal direction and the side at the foot, and the arc between them.
void addAngleMark(Strokes& out, const TemplateShape& shape, double azimuth, const TemplatePalette& palette) {
  const double c = std::cos(azimuth), s = -std::sin(azimuth);
  const double reach = 0.62 * shape.height, radius = 0.42 * shape.height;
  const Vec3 foot{shape.foot_x * c, 0.0, shape.foot_z * s};
  const StrokeStyle style{palette.text, 1.2, 0.75, 0.5};
  StrokeStyle dashed = style;
  dashed.dash_px = 4.0;
  out.push_back({{shape.frame(foot), shape.frame(foot + Vec3{0.0, reach, 0.0})}, dashed});
  Stroke arc{{}, style};
  for (int i = 0; i <= 24; ++i) {
    const double angle = shape.lean_rad * i / 24.0;
    arc.points.push_back(shape.frame(foot + radius * Vec3{std::sin(angle) * c, std::cos(angle), std::sin(angle) * s}));
  }
  if (shape.lean_rad > 0.0) out.push_back(std::move(arc));
}

void addHandles(Strokes& out, const TemplateShape& shape, TemplateHandle active, double azimuth, const TemplatePalette& palette) {
  for (const TemplateHandle which : {TemplateHandle::foot, TemplateHandle::top, TemplateHandle::rim}) {
    if (!shape.hasHandle(which)) continue;
    const bool chosen = which == active;
    const Vec3 at = shape.handle(which, azimuth);
    out.push_back({{at}, {palette.shade, chosen ? 15.0 : 12.0, 1.0, 1.0}});
    out.push_back({{at}, {chosen ? palette.active : palette.text, chosen ? 11.0 : 8.0, 1.0, 1.0}});
  }
}

}  // namespace

TemplateMesh smoothMesh(const nurbs::Surface& surface, int around, int along) {
  TemplateMesh out;
  for (const nurbs::SurfaceSample& sample : surface.grid(steps(surface.u(), around), steps(surface.v(), along))) out.vertices.push_back(vertex(sample.point, sample.normal));
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(j * (around + 1) + i); };
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i)
      for (const std::uint32_t corner : {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j), index(i + 1, j + 1), index(i, j + 1)}) out.triangles.push_back(corner);
  return out;
}

TemplateMesh flatMesh(const nurbs::Surface& surface, int around, int along) {
  TemplateMesh out;
  const auto samples = surface.grid(steps(surface.u(), around), steps(surface.v(), along));
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const auto at = [&](int di, int dj) { return samples[static_cast<std::size_t>(j + dj) * (around + 1) + i + di].point; };
      const Vec3 corners[4] = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
      // The diagonals of a patch give its normal also where two corners meet in a pole.
      const Vec3 across = cross(corners[2] - corners[0], corners[3] - corners[1]);
      const double size = length(across);
      const Vec3 normal = size > 0.0 ? (1.0 / size) * across : Vec3{0, 1, 0};
      const auto first = static_cast<std::uint32_t>(out.vertices.size());
      for (const Vec3& corner : corners) out.vertices.push_back(vertex(corner, normal));
      for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) out.triangles.push_back(first + k);
    }
  return out;
}

TemplateDrawing drawingOf(const TemplateShape& shape, const TemplateScene& scene, const TemplateCamera& camera) {
  TemplateDrawing out;
  out.palette = paletteOn(scene.background);
  // The region lies on the base plane under an upright cup or, projected, under a sphere.
  if (shape.ball || (shape.origin.y == 0.0 && shape.frame.y.x == 0.0 && shape.frame.y.z == 0.0)) {
    out.region_x = shape.scale * shape.foot_x;
    out.region_z = shape.scale * shape.foot_z;
  }
  out.flat = scene.view == TemplateView::polygons;
  out.mesh_visible = scene.view != TemplateView::splines;
  out.mesh = out.flat ? flatMesh(shape.surface, kFacetsAround, kFacetsAlong) : smoothMesh(shape.surface, 96, 30);
  addScaffold(out.strokes, shape, out.palette);
  switch (scene.view) {
    case TemplateView::splines: addSplines(out.strokes, shape, out.palette); break;
    case TemplateView::polygons: addFacetEdges(out.strokes, shape.surface, out.palette); break;
    case TemplateView::surface: addSurfaceLines(out.strokes, shape, out.palette); break;
  }
  if (!shape.ball) addAngleMark(out.strokes, shape, camera.azimuth(), out.palette);
  if (scene.handles) addHandles(out.strokes, shape, scene.active, camera.azimuth(), out.palette);
  for (Stroke& stroke : out.strokes) {
    stroke.style.width_px *= scene.scale;
    stroke.style.dash_px *= scene.scale;
  }
  return out;
}

}  // namespace npsee::render
