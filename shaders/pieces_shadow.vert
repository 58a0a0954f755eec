#version 330 core
#include "common.glsl"
#include "turn.glsl"
#include "clip.glsl"
#include "pieces.glsl"
// The pieces' corners where the key light throws them on the ground.
uniform mat4 u_view_projection;  // world to clip
uniform float u_strength;        // darkness, 0..1

flat out vec4 v_flat;
out vec4 v_smooth;

void main() {
  Placed corner = placedCorner();
  float above = corner.place.y - groundUnder(corner.place.xz);
  // Down the light's way until it meets the plane of the ground.
  float fall = kKeyDirection.y - dot(u_slope, kKeyDirection.xz);
  vec3 place = corner.place - kKeyDirection * (max(above, 0.0) / fall);
  float dark = u_strength * corner.colour.a;
  if (above < -0.5 || corner.colour.a <= 0.0) place = corner.centre;
  v_flat = v_smooth = vec4(0.0, 0.0, 0.0, dark);
  gl_Position = u_view_projection * vec4(place, 1.0);
}
