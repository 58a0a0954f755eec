#version 330 core
// The patch of ground that an explosion lights: a square around the point under the lamp.
uniform mat4 u_view_projection;  // world to clip
uniform float u_ground;          // ground height at the burst, world m
uniform vec2 u_slope;            // its rise per metre along x and z
uniform float u_nearer;          // share of the distance by which it is drawn before the ground it lies on
uniform vec3 u_eye;              // world m
uniform vec4 u_glow_place;       // world m, squared radius
uniform float u_reach;           // half the side of the square, m

out vec3 v_place;  // world m

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  vec2 place = u_glow_place.xz + u_reach * corner;
  v_place = vec3(place.x, u_ground + dot(u_slope, place), place.y);
  gl_Position = u_view_projection * vec4(mix(v_place, u_eye, u_nearer), 1.0);
}
