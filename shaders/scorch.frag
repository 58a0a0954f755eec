#version 330 core
#include "common.glsl"
#include "glow.glsl"
#include "lattice_noise.glsl"
in vec2 v_disc;
in vec3 v_place;
flat in vec4 v_colour;
flat in vec2 v_own;
uniform vec2 u_slope;
uniform vec3 u_eye;
out vec4 o_colour;  // premultiplied

void main() {
  float r = length(v_disc);
  if (r >= 1.0) discard;
  // The rim runs out in tongues, which depend on the direction alone, and in specks.
  vec2 direction = v_disc / max(r, 1e-4);
  float tongue = 0.6 * latticeNoise(v_own + 2.3 * direction) + 0.4 * latticeNoise(v_own.yx + 6.1 * direction);
  float speck = latticeNoise(v_own + 7.0 * v_disc) * 0.6 + latticeNoise(v_own.yx + 19.0 * v_disc) * 0.4;
  float reach = 0.45 + 0.55 * tongue;
  float cover = clamp((reach - r) / (0.55 * reach) + 0.9 * (speck - 0.5), 0.0, 1.0);
  cover *= cover * (3.0 - 2.0 * cover);
  cover *= clamp((1.0 - r) * 6.0, 0.0, 1.0) * (0.82 + 0.18 * speck);
  float a = v_colour.a * cover;
  vec3 albedo = linearFromSrgb(v_colour.rgb) * (0.7 + 0.6 * speck);
  vec3 normal = normalize(vec3(-u_slope.x, 1.0, -u_slope.y));
  vec3 light = dimmed(litDiffuse(albedo, normal)) + albedo * glowLight(v_place, normal);
  float clear = clearTo(distance(v_place, u_eye));
  o_colour = vec4(mix(u_haze_colour, light, clear) * a, a);
}
