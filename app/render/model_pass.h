#pragma once

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/mission_light.h"
#include "app/render/model.h"
#include "app/render/view.h"

#include <npsee/preset.h>

#include <array>
#include <string_view>
#include <vector>

namespace npsee::render {

/// One thing to draw with a model.
struct ModelInstance {
  std::size_t model = 0;
  Vec3 at_m;                             ///< in the world, on the ground
  Vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};  ///< its axes in the world, unit vectors
  double scale = 1.0;
  double turret_rad = 0.0, tube_rad = 0.0;  ///< clockwise from ahead; upwards
  Colour body{0.36, 0.40, 0.26}, accent{0.5, 0.5, 0.5};
  double burnt = 0.0;                    ///< 1 = blackened
};

/// Axes of a part of an instance in the world, scaled, and where its model's origin comes to lie relative to the instance.
struct PartAxes {
  Vec3 right, up, back;
  Vec3 at;
};
PartAxes axesOf(const ModelInstance& instance, const ModelPart& part);

/// Vehicles, guns, shells and figures: meshes from assets/models, all instances of a part in one call.
class ModelPass {
 public:
  static Expected<ModelPass> create();

  const std::vector<Model>& models() const { return models_; }
  /// Index of a model, or that of `otherwise`, or 0.
  std::size_t find(std::string_view name, std::string_view otherwise) const;

  /// Draws into the bound framebuffer with depth; `view` has its eye at the origin, which stands at `eye` in the world.
  void draw(const std::vector<ModelInstance>& instances, const Vec3& eye, const View& view, const MissionLight& light);

 private:
  /// As the shader reads it: three rows of part to eye-relative world, and what it looks like.
  struct Placed {
    std::array<float, 12> rows;
    std::array<float, 4> body, accent;   ///< accent's fourth: burnt
  };
  static Placed placed(const ModelInstance& instance, const ModelPart& part, const Vec3& eye);

  std::vector<Model> models_;
  std::vector<std::size_t> first_;       ///< first vertex of each model in the buffer
  gl::Program program_;
  gl::VertexArray attributes_;
  gl::Buffer vertices_, instances_;
  std::vector<Placed> scratch_;
};

}  // namespace npsee::render
