#version 330 core
in vec2 v_map;
uniform sampler2D u_map;  // share of the ground's light that smoke takes
uniform float u_share;    // of the sun's part in it beside that of the day
out vec4 o_colour;

void main() {
  float dark = u_share * texture(u_map, v_map).r;
  if (dark < 0.002) discard;
  o_colour = vec4(0.0, 0.0, 0.0, dark);
}
