#version 330 core
#include "common.glsl"
#include "mission_light.glsl"
#include "terrain.glsl"
out vec4 o_colour;

void main() {
  float distance_m = length(v_place);
  o_colour = finished(land(distance_m, false), max(contours(distance_m), gridLines()), distance_m);
}
