#pragma once

#include "app/gl/program.h"
#include "app/render/stroke_pass.h"
#include "app/render/template_drawing.h"

namespace npsee::render {

/// Draws templates: base plane, surface, strokes.
class TemplatePass {
 public:
  /// Error kind graphics with the log of a shader that does not compile.
  static Expected<TemplatePass> create();

  /// Draws into the bound framebuffer, which is cleared, has depth, and takes linear premultiplied light. Sets all the state it
  /// needs and leaves the colour and depth masks on. `scene.preset` must be valid and hold `scene.layer`.
  void draw(const TemplateScene& scene, int width, int height);

  /// Colour behind the template; null for a transparent picture.
  static const Colour* background(const TemplateScene& scene);

 private:
  void drawMesh(const TemplateDrawing& drawing, const TemplateCamera& camera) const;
  void drawGround(const TemplateDrawing& drawing, const TemplateCamera& camera, double scale) const;

  gl::Program mesh_, ground_;
  StrokePass strokes_;
  gl::VertexArray mesh_attributes_, nothing_;
  gl::Buffer mesh_vertices_, mesh_indices_;
};

}  // namespace npsee::render
