#version 330 core
#include "common.glsl"
#include "clip.glsl"
in vec3 v_place;
flat in vec3 v_centre;
flat in float v_radius;
flat in vec4 v_colour;
uniform vec3 u_eye;
out vec4 o_colour;  // premultiplied

// 1 where the ground does not hide a point.
float overGround(vec3 place) { return place.y >= groundUnder(place.xz) ? 1.0 : 0.0; }

void main() {
  vec3 ray = normalize(v_place - u_eye), from = u_eye - v_centre;
  float along = dot(from, ray), off2 = dot(from, from) - along * along, r2 = v_radius * v_radius;
  if (off2 >= r2) discard;
  float reach = sqrt(r2 - off2), t = sqrt(off2 / r2);
  // A thin shell is seen where the eye looks along it.
  float limb = smoothstep(0.72, 0.96, t) * (1.0 - smoothstep(0.965, 1.0, t));
  float sides = 0.5 * (overGround(u_eye + (-along - reach) * ray) + overGround(u_eye + (-along + reach) * ray));
  float seen = limb * sides * v_colour.a * clearTo(length(v_place - u_eye));
  if (seen <= 0.002) discard;
  o_colour = vec4(dimmed(linearFromSrgb(v_colour.rgb) * (kSkyAmbient + 0.3 * kKeyLight)) * (0.34 * seen), 0.16 * seen);
}
