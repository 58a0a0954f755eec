#version 330 core
#include "common.glsl"
#include "turn.glsl"
#include "clip.glsl"
#include "glow.glsl"
#include "heat.glsl"
#include "pieces.glsl"

uniform mat4 u_view_projection;  // world to clip
uniform vec3 u_eye;              // world m
uniform vec2 u_opacity;          // opacities drawn: above x, at most y

flat out vec4 v_flat;  // premultiplied light and opacity
out vec4 v_smooth;
flat out vec3 v_velocity;  // world m/s

// Soot and raw edges: what a cut laid bare is darker and has little colour of its own.
const float kTorn = 0.30;

void main() {
  Placed corner = placedCorner();
  float a = corner.colour.a;
  if (a <= u_opacity.x || a > u_opacity.y) corner.place = corner.centre;
  vec3 own = linearFromSrgb(a_colour.rgb), layers = linearFromSrgb(corner.colour.rgb);
  vec3 albedo = a_colour.w < 0.5 ? own : layers;
  if (a_colour.w > 1.5) albedo = kTorn * mix(vec3(dot(layers, vec3(0.3, 0.6, 0.1))), layers, 0.5);
  vec3 light = dimmed(litDiffuse(albedo, corner.normal)) + albedo * glowLight(corner.centre, corner.normal) + emittedLight(corner.temperature);
  light = mix(u_haze_colour, light, clearTo(distance(corner.centre, u_eye)));
  v_flat = vec4(light * a, a);
  v_smooth = v_flat;
  v_velocity = corner.velocity;
  gl_ClipDistance[0] = clipDistance(corner.place.y);
  gl_Position = u_view_projection * vec4(corner.place, 1.0);
}
