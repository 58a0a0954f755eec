#pragma once

#include <npsee/explosion.h>
#include <npsee/vec3.h>

#include <string>
#include <string_view>

namespace npsee::render {

/// Perspective camera: eye looks at a reference point; y is up. The thesis moves both by keyboard.
struct Camera {
  Vec3 eye{0.0, 10.0, 40.0};   ///< viewpoint, m
  Vec3 target{0.0, 5.0, 0.0};  ///< reference point, m
  double fov_y_rad = 0.6981317007977318;  ///< vertical field of view (40 deg)

  friend bool operator==(const Camera&, const Camera&) = default;
};

/// A camera from the south-south-east, a little above, that has the whole effect in view at `aspect` (width / height).
Camera framing(const Extent& extent, double aspect);

/// Parses "--camera": "auto" is handled by the caller; "eye=X,Y,Z target=X,Y,Z fov=40deg" in any order, separated by spaces
/// or semicolons; or a named view "front", "side", "top". Error kind usage.
Expected<Camera> parseCamera(std::string_view text, const Extent& extent, double aspect);

/// Text that parseCamera reads back to the same camera.
std::string cameraText(const Camera& camera);

}  // namespace npsee::render
