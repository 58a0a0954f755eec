#version 330 core
#include "common.glsl"
#include "mission_light.glsl"
#include "terrain.glsl"
out vec4 o_colour;

// The world goes on level here, only to be looked over: grey like an unprinted margin.
void main() {
  float distance_m = length(v_place);
  bool wet = v_ground < u_eye_height.y - 0.001;
  vec3 light = (wet ? vec3(0.050, 0.085, 0.105) : vec3(0.150, 0.150, 0.115)) * missionLight(v_place, vec3(0.0, 1.0, 0.0), 1.0);
  o_colour = finished(light, 0.0, distance_m);
}
