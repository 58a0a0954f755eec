// The part of light that is above the threshold of the roll-off; its hue stays. After knee.glsl.
vec3 tooBright(vec3 c) {
  float most = max(max(c.r, c.g), c.b);
  return c * (max(most - kKnee, 0.0) / max(most, kKnee));
}
