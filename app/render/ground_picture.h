#pragma once

#include "app/gl/objects.h"
#include "app/render/mission_light.h"
#include "app/render/terrain_pass.h"
#include "app/render/view.h"

namespace npsee::render {

/// Everything that ground and sky of a picture depend on.
struct GroundKey {
  Lens lens;
  int width = 0, height = 0, samples = 0;
  MissionLight light;
  TerrainLines lines;
  const float* terrain = nullptr;  ///< its samples
  friend bool operator==(const GroundKey&, const GroundKey&) = default;
};

/// Ground and sky as drawn, with their depth, kept while the camera stands still: they take most of a picture's time.
class GroundPicture {
 public:
  /// Copies the kept picture into the bound framebuffer; false if it is another one or none is kept.
  bool restore(const GroundKey& key) const;
  /// Called when ground and sky have just been drawn into the bound framebuffer. They are kept from the second picture with the
  /// same key on: a camera that moves pays nothing.
  void drawn(const GroundKey& key);
  void forget() { kept_ = false; }

 private:
  GroundKey key_;
  bool kept_ = false;
  gl::Renderbuffer colour_, depth_;
  gl::Framebuffer frame_;
  int width_ = 0, height_ = 0, samples_ = -1;
};

/// Samples per pixel of the bound framebuffer, 0 for one.
int boundSamples();

}  // namespace npsee::render
