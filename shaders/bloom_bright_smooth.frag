#version 330 core
#include "knee.glsl"
#include "bloom.glsl"
uniform sampler2DMS u_scene;  // linear premultiplied light of the effect, four samples a pixel
uniform int u_cell;    // pixels a side that become one
uniform vec2 u_last;   // the picture's last pixel
out vec4 o_colour;

vec3 sceneAt(ivec2 at) { return 0.25 * (texelFetch(u_scene, at, 0) + texelFetch(u_scene, at, 1) + texelFetch(u_scene, at, 2) + texelFetch(u_scene, at, 3)).rgb; }

#include "bloom_cell.glsl"
