#pragma once

#include "app/gl/objects.h"
#include "app/render/smoke_shade.h"

#include <npsee/explosion.h>

#include <cstddef>
#include <span>
#include <vector>

namespace npsee::render {

/// Attribute locations shared by the particle shaders; those of a particle are one float each, but for the velocity.
enum Attribute : unsigned { kX, kY, kZ, kSize, kR, kG, kB, kA, kQx, kQy, kQz, kQw, kMeshPosition, kMeshNormal, kKind, kVelocityVector, kTemperature = kKind };

/// A frame's arrays in one GL buffer, section after section, as they come from the simulator. The buffer is orphaned for
/// every frame, so that the driver need not wait for the last one.
class FrameUpload {
 public:
  void upload(const Frame& frame, std::span<const LayerSpan> layers);

  /// Points the bound vertex array's instance attributes at the particles from `first` on. Position, size, colour and
  /// opacity always; temperature and the orientation if `with_orientation`. Only every `every`-th particle is bound.
  void bind(std::size_t first, bool with_orientation, std::size_t every = 1) const;

  /// Hands over the velocities of the frame uploaded, and points the bound vertex array at them.
  void uploadVelocities(const Frame& frame);
  void bindVelocities(std::size_t first) const;

 private:
  gl::Buffer buffer_, velocities_, heat_;
  std::vector<float> temperatures_;  // K; empty where nothing is hot
  std::size_t count_ = 0;
};

/// One particle of those that are blended, which come in sorted order and so are copied out of the arrays.
struct BlendedInstance {
  float x, y, z, size;
  float r, g, b, a;
  float p[4];  ///< solid forms: quaternion; soft forms: velocity and the particle's own number 0..1
  float kind;  ///< soft forms: 0 streak, 1 smoke, 2 fire, 3 flash; solid ones: temperature, K
  PuffLight light;  ///< of smoke; pieces of a model have their temperature, K, as its first
};

/// Kind of a puff of smoke.
inline constexpr float kSmokeKind = 1.0f;

class BlendedUpload {
 public:
  void upload(std::span<const BlendedInstance> instances);
  /// As FrameUpload::bind, with the kind. Soft forms get their light where pieces have their mesh.
  void bind(std::size_t first, bool with_light = false) const;

 private:
  gl::Buffer buffer_;
};

}  // namespace npsee::render
