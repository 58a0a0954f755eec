#pragma once

#include "app/render/camera.h"

namespace npsee::editor {

/// What a key of the thesis's appendix B.B moves. x is east, y up, z south.
enum class CameraKey {
  viewpoint_x_plus, viewpoint_x_minus, viewpoint_y_plus, viewpoint_y_minus, viewpoint_z_plus, viewpoint_z_minus,
  reference_x_plus, reference_x_minus, reference_y_plus, reference_y_minus,
};

/// Step of a camera key for an effect of that radius: about a twentieth, rounded to 1, 2 or 5 times a power of ten, m.
double keyStep_m(double radius_m);

/// Moves viewpoint or reference point by `step_m` along the key's axis. A step that would put the two together is not taken.
render::Camera moved(const render::Camera& camera, CameraKey key, double step_m);

/// Turns the viewpoint around the reference point; pitch is kept off the poles. Angles in rad.
render::Camera orbited(const render::Camera& camera, double yaw_rad, double pitch_rad);

/// Shifts both points in the picture plane so that the reference point's surroundings follow the pointer:
/// `dx`, `dy` are shares of the picture's height, y downward.
render::Camera panned(const render::Camera& camera, double dx, double dy);

/// Multiplies the distance to the reference point by `factor`, while the ray through (x, y) - in shares of the picture's half
/// height from its centre, y upward - keeps pointing at the same place at the reference point's depth.
render::Camera dollied(const render::Camera& camera, double factor, double x, double y);

}  // namespace npsee::editor
