#version 330 core
#include "common.glsl"
#include "turn.glsl"
#include "lift.glsl"
#include "clip.glsl"
#include "glow.glsl"
#include "heat.glsl"
// One particle per instance, structure of arrays: every quantity is an attribute of its own.
layout(location = 0) in float a_x;     // world m
layout(location = 1) in float a_y;
layout(location = 2) in float a_z;
layout(location = 3) in float a_size;  // m, 0 = not alive
layout(location = 4) in float a_r;     // sRGB-coded
layout(location = 5) in float a_g;
layout(location = 6) in float a_b;
layout(location = 7) in float a_a;     // opacity
layout(location = 8) in float a_qx;    // body to world
layout(location = 9) in float a_qy;
layout(location = 10) in float a_qz;
layout(location = 11) in float a_qw;
layout(location = 12) in vec3 a_position;  // mesh, body at size 1
layout(location = 13) in vec3 a_normal;    // mesh, body
layout(location = 14) in float a_temperature;  // K
layout(location = 15) in vec3 a_velocity;  // world m/s; only where surfaces are drawn

uniform mat4 u_view_projection;  // world to clip
uniform vec3 u_eye;              // world m
uniform float u_metre_per_pixel; // metres that a pixel spans at a distance of one metre
uniform vec2 u_opacity;          // opacities drawn: above x, at most y
uniform float u_two_sided;       // 1: the normal is turned towards the eye

flat out vec4 v_flat;  // premultiplied light and opacity of the facet whose last corner this is
out vec4 v_smooth;
flat out vec3 v_velocity;  // world m/s

void main() {
  vec4 q = vec4(a_qx, a_qy, a_qz, a_qw);
  vec3 centre = vec3(a_x, a_y, a_z);
  // Nothing vanishes with distance: a form is never smaller than about two pixels.
  float least = 2.5 * u_metre_per_pixel * distance(centre, u_eye);
  float size = a_size > 0.0 ? max(a_size, least) : 0.0;
  if (a_a <= u_opacity.x || a_a > u_opacity.y) size = 0.0;
  centre.y += liftOf(a_y - groundUnder(vec2(a_x, a_z)), size, upInBody(q));
  vec3 normal = rotated(q, a_normal);
  vec3 place = centre + size * rotated(q, a_position);
  if (u_two_sided > 0.5 && dot(normal, u_eye - place) < 0.0) normal = -normal;
  vec3 albedo = linearFromSrgb(vec3(a_r, a_g, a_b));
  vec3 light = dimmed(litDiffuse(albedo, normal)) + albedo * glowLight(centre, normal) + emittedLight(a_temperature);
  light = mix(u_haze_colour, light, clearTo(distance(centre, u_eye)));
  v_flat = vec4(light * a_a, a_a);
  v_smooth = v_flat;
  v_velocity = a_velocity;
  gl_ClipDistance[0] = clipDistance(place.y);
  gl_Position = u_view_projection * vec4(place, 1.0);
}
