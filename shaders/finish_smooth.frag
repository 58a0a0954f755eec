#version 330 core
#include "finish.glsl"
uniform sampler2DMS u_scene;  // linear premultiplied light of the effect, four samples a pixel

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(u_scene, at, 0) + texelFetch(u_scene, at, 1) + texelFetch(u_scene, at, 2) + texelFetch(u_scene, at, 3);
  lay(0.25 * sum, at);
}
