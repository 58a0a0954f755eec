// Moves the light that is too bright for the picture: what was taken leaves its place, what has come from others is added.
#include "bloom.glsl"
uniform sampler2D u_bloom;         // light that came; its alpha is 1 in cells whose light was taken
uniform float u_bloom_share = 0.0; // of the light above the threshold, which spreads; 0 none
uniform vec2 u_bloom_size;         // pixels that u_bloom spans
uniform int u_bloom_cell = 1;      // pixels a side of its cells

uniform float u_exposure = 1.0;    // the camera's, a factor on the light before highlights roll off

vec3 bloomed(vec3 light, ivec2 at) {
  if (u_bloom_share == 0.0) return light;
  float taken = texelFetch(u_bloom, at / u_bloom_cell, 0).a;
  return light + u_bloom_share * (texture(u_bloom, (vec2(at) + 0.5) / u_bloom_size).rgb - taken * tooBright(light));
}
