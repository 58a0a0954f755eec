#version 330 core
#include "deep.glsl"
uniform sampler2D u_scene;   // linear premultiplied light of the effect, in a part of the texture
uniform vec2 u_per_pixel;    // its texels for a pixel
uniform vec2 u_used;         // texels of it that are drawn
uniform vec2 u_texels;       // of the whole texture

void main() {
  vec2 pixel = gl_FragCoord.xy + vec2(0.0, float(u_low));
  vec2 at = clamp(pixel * u_per_pixel, vec2(0.5), u_used - 0.5);
  finishDeep(texture(u_scene, at / u_texels), ivec2(pixel));
}
