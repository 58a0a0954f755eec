#version 330 core
#include "common.glsl"
#include "glow.glsl"
in vec3 v_place;
flat in vec3 v_centre;
flat in float v_radius;
flat in float v_width;
flat in vec4 v_colour;
uniform vec2 u_slope;
uniform vec3 u_eye;
out vec4 o_colour;  // premultiplied

// 1 at 0, falling smoothly to 0 at -1 and 1.
float bump(float x) {
  float y = max(1.0 - x * x, 0.0);
  return y * y;
}

void main() {
  float from_front = distance(v_place, v_centre) - v_radius;
  // Denser air bends light: what lies behind the front is seen darker, the front itself bright.
  float bright = bump(from_front / v_width) * v_colour.a, dark = bump((from_front + 1.6 * v_width) / (1.4 * v_width)) * v_colour.a;
  if (bright + dark <= 0.0) discard;
  vec3 colour = linearFromSrgb(v_colour.rgb), normal = normalize(vec3(-u_slope.x, 1.0, -u_slope.y));
  // Bent light of the sky, and a little of the flash, which would outshine it.
  vec3 light = dimmed(litDiffuse(colour, normal)) + 0.15 * colour * glowLight(v_place, normal);
  float clear = clearTo(distance(v_place, u_eye));
  o_colour = vec4(light * (0.42 * bright * clear), (0.22 * bright + 0.34 * dark) * clear);
}
