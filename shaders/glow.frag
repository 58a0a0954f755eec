#version 330 core
#include "common.glsl"
#include "glow.glsl"
in vec3 v_place;
uniform vec3 u_albedo;  // of the ground, sRGB-coded
uniform vec2 u_slope;
uniform vec3 u_eye;
uniform float u_least;  // light at the edge of the patch, which fades to nothing there
out vec4 o_colour;      // light alone: it covers nothing

void main() {
  vec3 normal = vec3(-u_slope.x, 1.0, -u_slope.y);
  vec3 light = max(glowLight(v_place, normal / length(normal)) - u_least, 0.0);
  o_colour = vec4(linearFromSrgb(u_albedo) * light * clearTo(distance(v_place, u_eye)), 0.0);
}
