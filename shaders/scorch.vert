#version 330 core
// A burnt patch on the ground: a square around the point under the particle.
layout(location = 0) in float a_x;     // world m
layout(location = 2) in float a_z;
layout(location = 3) in float a_size;  // m, 0 = not alive
layout(location = 4) in float a_r;     // sRGB-coded
layout(location = 5) in float a_g;
layout(location = 6) in float a_b;
layout(location = 7) in float a_a;     // opacity
layout(location = 8) in float a_qx;    // of the orientation: a number of the particle's own
layout(location = 10) in float a_qz;

uniform mat4 u_view_projection;  // world to clip
uniform float u_ground;          // ground height at the burst, world m
uniform vec2 u_slope;            // its rise per metre along x and z
uniform float u_nearer;          // share of the distance by which it is drawn before the ground it lies on
uniform vec3 u_eye;              // world m

out vec2 v_disc;          // length 1 at the patch's reach
out vec3 v_place;         // world m
flat out vec4 v_colour;   // sRGB-coded, opacity
flat out vec2 v_own;      // the particle's place in the noise

void main() {
  v_disc = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  vec2 place = vec2(a_x, a_z) + 0.5 * a_size * v_disc;
  v_place = vec3(place.x, u_ground + dot(u_slope, place), place.y);
  v_colour = vec4(a_r, a_g, a_b, a_a);
  v_own = 40.0 * vec2(a_qx, a_qz);
  gl_Position = u_view_projection * vec4(mix(v_place, u_eye, u_nearer), 1.0);
}
