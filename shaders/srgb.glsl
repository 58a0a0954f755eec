// Linear light to a displayable picture.
#include "knee.glsl"

// Identity up to the knee, then smoothly towards 1, so that plain colours stay what they are and fire does not clip.
vec3 rolledOff(vec3 c) {
  vec3 over = max(c - kKnee, 0.0) / (1.0 - kKnee);
  return min(c, kKnee) + (1.0 - kKnee) * over / (1.0 + over);
}

// IEC 61966-2-1.
vec3 srgbFromLinear(vec3 c) {
  vec3 high = 1.055 * pow(max(c, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, lessThan(c, vec3(0.0031308)));
}
