#version 330 core
// A blast front in the air: a square that faces the eye and holds the ball's outline.
layout(location = 0) in float a_x;     // world m
layout(location = 1) in float a_y;
layout(location = 2) in float a_z;
layout(location = 3) in float a_size;  // diameter, m; 0 = not alive
layout(location = 4) in float a_r;     // sRGB-coded
layout(location = 5) in float a_g;
layout(location = 6) in float a_b;
layout(location = 7) in float a_a;     // opacity

uniform mat4 u_view_projection;  // world to clip
uniform vec3 u_eye;              // world m
uniform vec3 u_right;            // camera axes in the world
uniform vec3 u_up;
uniform vec3 u_back;

out vec3 v_place;          // world m
flat out vec3 v_centre;    // world m
flat out float v_radius;   // m
flat out vec4 v_colour;    // sRGB-coded, opacity

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  v_centre = vec3(a_x, a_y, a_z);
  v_radius = 0.5 * a_size;
  v_colour = vec4(a_r, a_g, a_b, a_a);
  // Through the ball's nearest point, so that hills and pieces before it hide it; from inside there is no outline to see.
  float away = distance(u_eye, v_centre), depth = dot(u_eye - v_centre, u_back);
  float nearer = depth - v_radius;
  bool seen = a_size > 0.0 && nearer > 0.02 * v_radius;
  float half_side = v_radius * 1.3 * nearer / sqrt(max(depth * depth - v_radius * v_radius, 1e-6));
  // Off the axis the outline is an ellipse that leans outward.
  vec3 to_centre = v_centre - u_eye;
  vec2 at = vec2(dot(to_centre, u_right), dot(to_centre, u_up)) * (nearer / max(depth, 1e-6));
  half_side *= away / max(depth, 1e-6);
  v_place = u_eye - nearer * u_back + (at.x + half_side * corner.x) * u_right + (at.y + half_side * corner.y) * u_up;
  gl_Position = seen ? u_view_projection * vec4(v_place, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
