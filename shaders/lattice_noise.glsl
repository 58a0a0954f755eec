// Value noise over the plane, 0..1, from whole numbers: the same on every driver.
float latticeValue(ivec2 at) {
  uint h = uint(at.x) * 0x9E3779B1u ^ uint(at.y) * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h ^= h >> 13;
  return float(h & 0xffffu) * (1.0 / 65535.0);
}

float latticeNoise(vec2 place) {
  vec2 cell = floor(place), f = place - cell;
  ivec2 at = ivec2(cell);
  f *= f * (3.0 - 2.0 * f);
  float low = mix(latticeValue(at), latticeValue(at + ivec2(1, 0)), f.x);
  float high = mix(latticeValue(at + ivec2(0, 1)), latticeValue(at + ivec2(1, 1)), f.x);
  return mix(low, high, f.y);
}
