#pragma once

#include "app/render/renderer.h"
#include "app/render/strokes.h"
#include "app/render/template_camera.h"
#include "app/render/template_geometry.h"

#include <array>
#include <cstdint>
#include <vector>

namespace npsee::render {

/// Triangles with unit normals that point out of the shape.
struct TemplateMesh {
  struct Vertex {
    std::array<float, 3> position, normal;
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> triangles;
};

/// Polyline in template space; the last point is the first again where it is closed. One point alone is a dot.
struct Stroke {
  std::vector<Vec3> points;
  StrokeStyle style;
};

/// Colours of a template, sRGB-coded.
struct TemplatePalette {
  Colour geometry, active, text, dim, shade;
  Colour surface, facet;  ///< fills of the shaded surface and of the polygon view
};

/// Drawn where the scene asks for no background of its own.
inline constexpr Colour kTemplateBackground{0x1e / 255.0, 0x21 / 255.0, 0x27 / 255.0};

/// Everything that one view of a template shows, in the order of drawing.
struct TemplateDrawing {
  TemplatePalette palette;
  double region_x = 0.0, region_z = 0.0;  ///< half-axes of the region on the base plane; 0 = not there
  TemplateMesh mesh;
  bool mesh_visible = true;  ///< otherwise it only hides what lies behind it
  bool flat = false;         ///< facets filled quietly, as a ground for their edges
  std::vector<Stroke> strokes;
};

/// The surface with exact normals at its vertices: `around` by `along` patches of two triangles each.
TemplateMesh smoothMesh(const nurbs::Surface& surface, int around, int along);
/// The same facets, each with its own vertices and the facet's normal.
TemplateMesh flatMesh(const nurbs::Surface& surface, int around, int along);

/// Facets of the polygon view.
inline constexpr int kFacetsAround = 24, kFacetsAlong = 10;

TemplateDrawing drawingOf(const TemplateShape& shape, const TemplateScene& scene, const TemplateCamera& camera);

/// Triangles (three vertices each) of all strokes in a picture of the given size.
std::vector<StrokeVertex> strokeTriangles(const std::vector<Stroke>& strokes, const TemplateCamera& camera, int width, int height);

}  // namespace npsee::render
