#version 330 core
#include "common.glsl"
#include "mission_light.glsl"
uniform vec3 u_ray_origin;   // direction through the picture's lower left corner, one unit deep
uniform vec3 u_ray_x;        // change of that direction per pixel to the right
uniform vec3 u_ray_y;        // and per pixel up
out vec4 o_colour;

void main() {
  vec3 ray = u_ray_origin + gl_FragCoord.x * u_ray_x + gl_FragCoord.y * u_ray_y;
  vec3 sky = missionSky(ray);
  vec3 direction = normalize(ray);
  float sun = max(dot(direction, kKeyDirection), 0.0);
  sky += (1.0 - u_night) * vec3(1.0, 0.92, 0.76) * (1.6 * smoothstep(0.99990, 0.99996, sun) + 0.10 * pow(sun, 90.0)) * exp(-u_extinction * 4000.0);
  o_colour = vec4(sky, 1.0);
}
