#version 330 core
#include "surface.glsl"
flat in vec3 v_velocity;  // world m/s

void main() { o_surface = surfaceAt(v_velocity); }
