#version 330 core
#include "common.glsl"
#include "mission_light.glsl"
#include "terrain.glsl"
out vec4 o_colour;

void main() {
  float distance_m = length(v_place);
  o_colour = finished(sea(-v_place / distance_m, distance_m, u_eye_height.y - v_ground), gridLines(), distance_m);
}
