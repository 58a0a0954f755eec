#version 330 core
// Where a blast front meets the ground: a square that holds the ring.
layout(location = 0) in float a_x;     // world m
layout(location = 1) in float a_y;
layout(location = 2) in float a_z;
layout(location = 3) in float a_size;  // diameter of the front, m; 0 = not alive
layout(location = 4) in float a_r;     // sRGB-coded
layout(location = 5) in float a_g;
layout(location = 6) in float a_b;
layout(location = 7) in float a_a;     // opacity

uniform mat4 u_view_projection;  // world to clip
uniform float u_ground;          // ground height at the burst, world m
uniform vec2 u_slope;            // its rise per metre along x and z
uniform float u_nearer;          // share of the distance by which it is drawn before the ground it lies on
uniform vec3 u_eye;              // world m
uniform float u_metre_per_pixel; // metres that a pixel spans at a distance of one metre
uniform float u_width;           // of the ring, as a part of its radius

out vec3 v_place;          // world m
flat out vec3 v_centre;    // on the ground, world m
flat out float v_radius;   // of the ring, m
flat out float v_width;    // m
flat out vec4 v_colour;    // sRGB-coded, opacity

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  v_centre = vec3(a_x, u_ground + dot(u_slope, vec2(a_x, a_z)), a_z);
  float height = a_y - v_centre.y, radius = 0.5 * a_size;
  v_radius = sqrt(max(radius * radius - height * height, 0.0));
  v_width = max(u_width * v_radius, 1.5 * u_metre_per_pixel * distance(v_centre, u_eye));
  vec2 place = vec2(a_x, a_z) + (v_radius > 0.0 ? v_radius + v_width : 0.0) * corner;
  v_place = vec3(place.x, u_ground + dot(u_slope, place), place.y);
  v_colour = vec4(a_r, a_g, a_b, a_a);
  gl_Position = u_view_projection * vec4(mix(v_place, u_eye, u_nearer), 1.0);
}
