#version 330 core
#include "finish.glsl"
uniform sampler2D u_scene;  // linear premultiplied light of the effect, in a part of the texture
uniform vec2 u_scale;       // pixels of the picture to one of the draft, each way

// What a draft adds to the finished picture behind it, so that this one keeps its sharp lines: (1 - a) of what is behind and this make the
// finished pixel. It is not below 0, since the coding is concave and 0 at 0. Without anything behind: the coded colour, premultiplied.
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 scene = texelFetch(u_scene, at, 0);
  scene.rgb *= u_exposure;
  ivec2 place = ivec2(gl_FragCoord.xy * u_scale);
  float a = min(scene.a, 1.0);
  vec4 whole = coded(scene, place);
  o_colour = u_behind == 0 ? vec4(whole.rgb * whole.a, whole.a) : vec4(max(whole.rgb - (1.0 - a) * srgbFromLinear(behindAt(place)), 0.0), a);
}
