#version 330 core
#include "soft.glsl"
out vec4 o_colour;  // premultiplied

// soft.frag for puffs of smoke alone, as most are. A driver without branches works out every form at every pixel.
void main() { o_colour = smokeLight(cloudHere()); }
