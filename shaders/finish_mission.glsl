// A mission's linear light to the finished picture: highlights rolled off, sRGB-coded. Ground and sky cover all of it, so there is
// nothing behind.
#include "srgb.glsl"
#include "bloom_add.glsl"
out vec4 o_colour;

// sRGB-coded within 0.0015 of IEC 61966-2-1 from three square roots, which cost a fraction of a power.
vec3 quickSrgb(vec3 c) {
  vec3 s1 = sqrt(c), s2 = sqrt(s1), s3 = sqrt(s2);
  return 0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * c;
}

vec4 finishedMission(vec3 light) {
  light = u_exposure * bloomed(light, ivec2(gl_FragCoord.xy));
  return vec4(clamp(quickSrgb(max(rolledOff(light), 0.0)), 0.0, 1.0), 1.0);
}
