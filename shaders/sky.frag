#version 330 core
#include "common.glsl"
uniform vec3 u_ray_origin;  // world direction through the target's lower left corner, one unit deep
uniform vec3 u_ray_x;       // change of that direction per pixel to the right
uniform vec3 u_ray_y;       // and per pixel up
out vec4 o_colour;

void main() { o_colour = vec4(skyColour(u_ray_origin + gl_FragCoord.x * u_ray_x + gl_FragCoord.y * u_ray_y), 1.0); }
