#version 330 core
#include "common.glsl"
#include "srgb.glsl"
#include "lattice_noise.glsl"
uniform vec3 u_eye;          // world m
uniform vec3 u_ray_origin;   // world direction through the target's lower left corner, one unit deep
uniform vec3 u_ray_x;        // change of that direction per pixel to the right
uniform vec3 u_ray_y;        // and per pixel up
uniform float u_height;      // ground height, world m
uniform vec3 u_ground;       // ground colour, sRGB-coded
uniform float u_grid;        // 1 draws the metre grid, 0 leaves it out
uniform vec3 u_horizon;      // colours of the sky
uniform vec3 u_zenith;
uniform vec3 u_afterglow;    // added where the sun went down
uniform float u_stars;       // brightness of the brightest star
uniform float u_exposure;    // factor on the light
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

// Light of a sun that is gone, low over the place where it went.
vec3 afterglow(vec3 ray, float up) {
  float aside = dot(ray.xz, normalize(kKeyDirection.xz)) * inversesqrt(max(dot(ray.xz, ray.xz), 1e-12));
  float near = 0.5 + 0.5 * aside, low = max(1.0 - 3.0 * up, 0.0);
  return u_afterglow * (near * near * low * low);
}

vec3 groundColour(vec3 ray, float depth) {
  vec2 place = u_eye.xz + ray.xz * depth;
  float distance_m = depth * length(ray);

  // Exact change of the hit point per pixel: d(place) = depth * (d ray.xz - ray.xz / ray.y * d ray.y).
  vec2 slope = ray.xz / ray.y;
  vec2 footprint = depth * (abs(u_ray_x.xz - slope * u_ray_x.y) + abs(u_ray_y.xz - slope * u_ray_y.y));

  vec3 albedo = linearFromSrgb(u_ground);
  vec3 colour = dimmed(litDiffuse(albedo, vec3(0.0, 1.0, 0.0)));
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
  return mix(colour, u_horizon + afterglow(ray, 0.0), haze);
}

// One star in some cells of a net around the sky, a pixel or two wide.
float stars(vec3 direction) {
  vec2 net = 90.0 * direction.xz / (0.35 + direction.y), cell = floor(net);
  float chance = latticeValue(ivec2(cell)), bright = latticeValue(ivec2(cell) + ivec2(517, 1031));
  vec2 off = net - cell - vec2(0.25) - 0.5 * vec2(latticeValue(ivec2(cell) + ivec2(77, 3)), latticeValue(ivec2(cell) + ivec2(5, 191)));
  float width = max(90.0 * length(u_ray_x) / (0.35 + direction.y), 0.03);
  return chance < 0.12 ? bright * bright * max(1.0 - length(off) / width, 0.0) * direction.y : 0.0;
}

vec3 skyOfHour(vec3 ray) {
  vec3 direction = normalize(ray);
  float up = clamp(direction.y, 0.0, 1.0);
  float haze = 1.0 - up;
  haze *= haze;
  vec3 colour = mix(u_zenith, u_horizon, haze * haze) + afterglow(ray, up);
  return u_stars > 0.0 && up > 0.02 ? colour + u_stars * stars(direction) : colour;
}

void main() {
  vec3 ray = u_ray_origin + gl_FragCoord.x * u_ray_x + gl_FragCoord.y * u_ray_y;
  float depth = (u_height - u_eye.y) / ray.y;
  vec3 light = depth > 0.0 && abs(ray.y) > 1e-6 ? groundColour(ray, depth) : skyOfHour(ray);
  light = rolledOff(u_exposure * light);
  o_light = vec4(light, 1.0);
  o_finished = vec4(srgbFromLinear(light), 1.0);
}
