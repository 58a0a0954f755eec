#version 330 core
#include "knee.glsl"
#include "bloom.glsl"
uniform sampler2D u_scene;  // linear premultiplied light of the effect
uniform int u_cell;    // pixels a side that become one
uniform vec2 u_last;   // the picture's last pixel
out vec4 o_colour;

vec3 sceneAt(ivec2 at) { return texelFetch(u_scene, at, 0).rgb; }

#include "bloom_cell.glsl"
