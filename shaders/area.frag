#version 330 core
#include "common.glsl"
in vec4 v_colour;   // sRGB-coded, opacity
out vec4 o_colour;  // linear, premultiplied

void main() { o_colour = vec4(linearFromSrgb(v_colour.rgb) * v_colour.a, v_colour.a); }
