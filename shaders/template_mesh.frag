#version 330 core
#include "common.glsl"
in vec3 v_position;
in vec3 v_normal;

uniform vec3 u_eye;     // template space
uniform vec3 u_light;   // towards the lamp, template space, unit: over the viewer's left shoulder
uniform vec3 u_colour;  // sRGB-coded
uniform float u_quiet;  // 1: a quiet fill behind the facets' edges

out vec4 o_colour;  // linear, premultiplied

void main() {
  vec3 view = normalize(u_eye - v_position);
  vec3 normal = normalize(v_normal);
  bool inside = dot(normal, view) < 0.0;
  if (inside) normal = -normal;
  vec3 albedo = linearFromSrgb(u_colour) * (inside ? 0.42 : 1.0);
  float lambert = max(dot(normal, u_light), 0.0);
  float fill = 0.5 + 0.5 * normal.y;
  float facing = max(dot(normal, view), 0.0);
  vec3 colour = albedo * (0.10 + 0.12 * fill + 0.78 * lambert);
  float shine = max(dot(normal, normalize(u_light + view)), 0.0);
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  float edge = 1.0 - facing;
  edge *= edge * edge;
  if (!inside) colour += vec3(0.10) * shine * shine + albedo * 0.22 * edge;
  if (u_quiet > 0.5) colour = linearFromSrgb(u_colour) * (0.35 + 0.65 * lambert) * (inside ? 0.6 : 1.0);
  o_colour = vec4(colour, 1.0);
}
