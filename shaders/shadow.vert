#version 330 core
#include "common.glsl"
layout(location = 0) in float a_x;     // world m
layout(location = 1) in float a_y;
layout(location = 2) in float a_z;
layout(location = 3) in float a_size;  // m, 0 = not alive
layout(location = 7) in float a_a;     // opacity

uniform mat4 u_view_projection;  // world to clip
uniform float u_ground;          // ground height at the burst, world m
uniform vec2 u_slope;            // its rise per metre along x and z
uniform float u_nearer;          // share of the distance by which the shadow is drawn before the ground it lies on
uniform vec3 u_eye;              // world m
uniform float u_strength;        // darkness under a solid form, 0..1
uniform float u_spread;          // growth of the penumbra per metre of height

out vec2 v_disc;    // length 1 at the blob's edge
flat out float v_dark;   // darkness at its centre
flat out float v_soft;   // share of the radius that is penumbra

void main() {
  // One triangle around the blob: half the set-up work of a square.
  vec2 corner = gl_VertexID == 0 ? vec2(-1.7320508, -1.0) : gl_VertexID == 1 ? vec2(1.7320508, -1.0) : vec2(0.0, 2.0);
  float height = a_y - u_ground - dot(u_slope, vec2(a_x, a_z));
  float core = 0.40 * a_size;
  float radius = core * 1.25 + u_spread * max(height, 0.0);
  // The same shade spread over a larger area is fainter.
  float dark = u_strength * a_a * core * core / max(radius * radius, 1e-8);
  if (height < -0.5 * a_size || a_size <= 0.0 || dark < 0.02) radius = 0.0;
  vec2 along = normalize(kKeyDirection.xz);
  vec2 across = vec2(-along.y, along.x);
  vec2 centre = vec2(a_x, a_z) - kKeyDirection.xz / kKeyDirection.y * max(height, 0.25 * a_size);
  vec2 place = centre + radius * (corner.x * along / kKeyDirection.y + corner.y * across);
  v_disc = corner;
  v_dark = min(1.6 * dark, u_strength);
  v_soft = clamp((radius - 0.8 * core) / max(radius, 1e-8), 0.3, 1.0);
  vec3 on_ground = vec3(place.x, u_ground + dot(u_slope, place), place.y);
  gl_Position = u_view_projection * vec4(mix(on_ground, u_eye, u_nearer), 1.0);
}
