// Lays the effect over what stands behind it: highlights rolled off, sRGB-coded, straight alpha. Where there is no effect
// nothing is written, so that the picture behind stays as it is to the last bit.
#include "srgb.glsl"
#include "bloom_add.glsl"
uniform sampler2D u_backdrop;  // linear light behind the effect, rolled off
uniform int u_behind;          // 0 nothing (transparent), 1 u_plain, 2 u_backdrop
uniform vec3 u_plain;          // linear
out vec4 o_colour;

vec3 behindAt(ivec2 at) { return u_behind == 2 ? texelFetch(u_backdrop, at, 0).rgb : u_plain; }

vec4 coded(vec4 scene, ivec2 at) {
  vec3 light = rolledOff(scene.rgb);
  // Light without cover (a flash's halo) needs some alpha to be kept in a picture without background.
  float alpha = min(max(scene.a, max(max(light.r, light.g), light.b)), 1.0);
  vec3 colour = u_behind == 0 ? light / max(alpha, 1e-4) : light + (1.0 - min(scene.a, 1.0)) * behindAt(at);
  return vec4(srgbFromLinear(min(colour, 1.0)), u_behind == 0 ? alpha : 1.0);
}

void lay(vec4 scene, ivec2 at) {
  scene.rgb = u_exposure * bloomed(scene.rgb, at);
  if (scene.a <= 0.0 && max(max(scene.r, scene.g), scene.b) <= 0.0) discard;
  o_colour = coded(scene, at);
}
