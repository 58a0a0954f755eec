#version 330 core
#include "common.glsl"
#include "srgb.glsl"
uniform vec3 u_eye;          // world m
uniform vec3 u_ray_origin;   // world direction through the target's lower left corner, one unit deep
uniform vec3 u_ray_x;        // change of that direction per pixel to the right
uniform vec3 u_ray_y;        // and per pixel up
uniform float u_height;      // ground height, world m
uniform vec3 u_ground;       // ground colour, sRGB-coded
uniform float u_grid;        // 1 draws the metre grid, 0 leaves it out
uniform float u_haze;        // distance at which haze covers 40 %, m
layout(location = 0) out vec4 o_light;     // linear, rolled off
layout(location = 1) out vec4 o_finished;  // sRGB-coded

// Cover of lines `spacing` metres apart and `width` metres wide, box-filtered over the pixel's footprint, fading out where
// the lines would be closer than a few pixels.
float gridCover(vec2 place, vec2 footprint, float spacing, float width) {
  vec2 size = footprint / spacing;
  vec2 at = abs(fract(place / spacing - 0.5) - 0.5);
  vec2 half_width = 0.5 * max(vec2(width / spacing), size);
  vec2 strength = min(vec2(width / spacing) / (2.0 * half_width), 1.0);
  vec2 cover = clamp((half_width + 0.5 * size - at) / size, 0.0, 1.0) * strength;
  vec2 fade = clamp(1.5 - 6.0 * size, 0.0, 1.0);
  cover *= fade;
  return max(cover.x, cover.y);
}

vec3 groundColour(vec3 ray, float depth) {
  vec2 place = u_eye.xz + ray.xz * depth;
  float distance_m = depth * length(ray);

  // Exact change of the hit point per pixel: d(place) = depth * (d ray.xz - ray.xz / ray.y * d ray.y).
  vec2 slope = ray.xz / ray.y;
  vec2 footprint = depth * (abs(u_ray_x.xz - slope * u_ray_x.y) + abs(u_ray_y.xz - slope * u_ray_y.y));

  vec3 albedo = linearFromSrgb(u_ground);
  vec3 colour = litDiffuse(albedo, vec3(0.0, 1.0, 0.0));
  if (u_grid > 0.5) {
    float lines = 0.30 * gridCover(place, footprint, 1.0, 0.03);
    lines = max(lines, 0.45 * gridCover(place, footprint, 10.0, 0.08));
    lines = max(lines, 0.55 * gridCover(place, footprint, 100.0, 0.30));
    colour = mix(colour, colour * 0.25, lines);
  }
  float clear = exp(-distance_m / u_haze);
  float haze = (1.0 - clear) * (1.0 - clear);
  // Near the ground distance alone would leave a hard horizon, so a few degrees below it are hazy too.
  float below_horizon = abs(ray.y) / length(ray);
  haze = max(haze, exp(-below_horizon * 38.0));
  if (u_eye.y < u_height) colour *= 0.5;
  return mix(colour, kHorizon, haze);
}

void main() {
  vec3 ray = u_ray_origin + gl_FragCoord.x * u_ray_x + gl_FragCoord.y * u_ray_y;
  float depth = (u_height - u_eye.y) / ray.y;
  vec3 light = depth > 0.0 && abs(ray.y) > 1e-6 ? groundColour(ray, depth) : skyColour(ray);
  light = rolledOff(light);
  o_light = vec4(light, 1.0);
  o_finished = vec4(srgbFromLinear(light), 1.0);
}
