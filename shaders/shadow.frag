#version 330 core
in vec2 v_disc;
flat in float v_dark;
flat in float v_soft;
out vec4 o_colour;

void main() {
  float r = length(v_disc);
  float cover = clamp((1.0 - r) / v_soft, 0.0, 1.0);
  o_colour = vec4(0.0, 0.0, 0.0, v_dark * cover * cover * (3.0 - 2.0 * cover));
}
