#version 330 core
#include "common.glsl"
in vec2 v_place;

uniform float u_reach;   // radius of the disc, template units
uniform float u_pixels;  // width of a line, pixels
uniform vec2 u_region;   // half-axes of the region's ellipse; 0 = not shown here
uniform vec3 u_line;     // colour of the grid, sRGB-coded
uniform vec3 u_tint;     // colour of the region, sRGB-coded

out vec4 o_colour;  // linear, premultiplied

// Cover of lines `spacing` apart and about u_pixels wide.
float lines(vec2 place, float spacing) {
  vec2 pixel = max(fwidth(place), vec2(1e-6));
  vec2 away = abs(fract(place / spacing - 0.5) - 0.5) * spacing / pixel;
  vec2 cover = clamp(1.0 + 0.5 * (u_pixels - 1.0) - away, 0.0, 1.0) * clamp(1.5 - 6.0 * u_pixels * pixel / spacing, 0.0, 1.0);
  return max(cover.x, cover.y);
}

float axes(vec2 place) {
  vec2 away = abs(place) / max(fwidth(place), vec2(1e-6));
  vec2 cover = clamp(1.3 + 0.8 * (u_pixels - 1.0) - away, 0.0, 1.0);
  return max(cover.x, cover.y);
}

void main() {
  float radius = length(v_place) / u_reach;
  float fade = clamp(1.0 - radius, 0.0, 1.0);
  fade = fade * (2.0 - fade);
  float alpha = 0.05 * fade;
  alpha = max(alpha, 0.20 * fade * lines(v_place, 0.25));
  alpha = max(alpha, 0.45 * fade * axes(v_place));
  vec4 colour = vec4(linearFromSrgb(u_line) * alpha, alpha);
  if (u_region.x > 0.0) {
    vec2 inside = v_place / u_region;
    float level = dot(inside, inside);
    float cover = 0.16 * clamp((1.0 - level) / max(fwidth(level), 1e-6) + 0.5, 0.0, 1.0);
    colour = vec4(linearFromSrgb(u_tint) * cover, cover) + (1.0 - cover) * colour;
  }
  o_colour = colour;
}
