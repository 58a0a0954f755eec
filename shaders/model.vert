#version 330 core
#include "common.glsl"
#include "mission_light.glsl"
// One part of a model, one instance per vehicle. Lit facet by facet.
layout(location = 0) in vec3 a_position;  // model, m
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec3 a_colour;    // sRGB-coded
layout(location = 3) in float a_paint;    // 0 its own colour, 1 the vehicle's, 2 the side's
layout(location = 4) in vec4 a_row0;      // part to eye-relative world
layout(location = 5) in vec4 a_row1;
layout(location = 6) in vec4 a_row2;
layout(location = 7) in vec4 a_body;      // sRGB-coded
layout(location = 8) in vec4 a_accent;    // sRGB-coded; 1 = burnt out

uniform mat4 u_view_projection;  // eye-relative to clip

flat out vec3 v_light;

void main() {
  vec4 p = vec4(a_position, 1.0);
  vec3 place = vec3(dot(a_row0, p), dot(a_row1, p), dot(a_row2, p));
  vec3 normal = normalize(vec3(dot(a_row0.xyz, a_normal), dot(a_row1.xyz, a_normal), dot(a_row2.xyz, a_normal)));
  vec3 colour = a_paint > 1.5 ? a_accent.rgb : (a_paint > 0.5 ? a_body.rgb : a_colour);
  vec3 albedo = mix(linearFromSrgb(colour), vec3(0.018, 0.016, 0.015), a_accent.a * (a_paint > 1.5 ? 0.85 : 0.96));
  vec3 light = albedo * missionLight(place, normal, 1.0);
  // The side has to be told by night too.
  if (a_paint > 1.5) light += albedo * 0.10 * (1.0 - a_accent.a);
  v_light = throughAir(light, place.y, length(place));
  gl_Position = u_view_projection * vec4(place, 1.0);
}
