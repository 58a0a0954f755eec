#version 330 core
layout(location = 0) in vec3 a_place;   // relative to the eye, m
layout(location = 1) in vec4 a_colour;  // sRGB-coded, opacity
uniform mat4 u_view_projection;         // eye-relative to clip
uniform float u_extinction;             // of the air, per metre
out vec4 v_colour;

void main() {
  v_colour = vec4(a_colour.rgb, a_colour.a * exp(-u_extinction * length(a_place)));
  gl_Position = u_view_projection * vec4(a_place, 1.0);
}
