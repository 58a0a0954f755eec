#version 330 core
#include "common.glsl"
#include "mission_light.glsl"
#include "terrain.glsl"
out vec4 o_colour;

void main() {
  float distance_m = length(v_place);
  float depth = u_eye_height.y - v_ground;
  bool wet = depth > 0.001;
  vec3 light = wet ? sea(-v_place / distance_m, distance_m, depth) : land(distance_m, true);
  o_colour = finished(light, max(wet ? 0.0 : contours(distance_m), gridLines()), distance_m);
}
