#version 330 core
// The shadow of smoke on the plane of the ground: a rectangle along the throw of the light.
uniform mat4 u_view_projection;  // world to clip
uniform float u_ground;          // ground height at the burst, world m
uniform vec2 u_slope;            // its rise per metre along x and z
uniform float u_nearer;          // share of the distance by which it is drawn before the ground it lies on
uniform vec3 u_eye;              // world m
uniform vec2 u_throw;            // unit vector x, z that shadows are thrown along
uniform vec2 u_origin;           // of the map along the throw and across it, m
uniform vec2 u_extent;           // of the map, m

out vec2 v_map;  // 0..1

void main() {
  v_map = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  vec2 at = u_origin + u_extent * v_map;
  vec2 place = at.x * u_throw + at.y * vec2(-u_throw.y, u_throw.x);
  vec3 on_ground = vec3(place.x, u_ground + dot(u_slope, place), place.y);
  gl_Position = u_view_projection * vec4(mix(on_ground, u_eye, u_nearer), 1.0);
}
