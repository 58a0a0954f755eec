#version 330 core
#include "soft.glsl"
out vec4 o_colour;  // premultiplied

void main() { o_colour = softLight(); }
