#version 330 core
#include "finish.glsl"
uniform sampler2D u_scene;   // linear premultiplied light of the effect, in a part of the texture
uniform vec2 u_per_pixel;    // its texels for a pixel
uniform vec2 u_used;         // texels of it that are drawn
uniform vec2 u_texels;       // of the whole texture

void main() {
  vec2 at = clamp(gl_FragCoord.xy * u_per_pixel, vec2(0.5), u_used - 0.5);
  lay(texture(u_scene, at / u_texels), ivec2(gl_FragCoord.xy));
}
