// The part of light that is above the threshold of the roll-off; its hue stays.
vec3 tooBright(vec3 c) {
  const float kKnee = 0.80;
  float most = max(max(c.r, c.g), c.b);
  return c * (max(most - kKnee, 0.0) / max(most, kKnee));
}
