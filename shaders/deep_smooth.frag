#version 330 core
#include "deep.glsl"
uniform sampler2DMS u_scene;  // linear premultiplied light of the effect, four samples a pixel

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  finishDeep(0.25 * (texelFetch(u_scene, at, 0) + texelFetch(u_scene, at, 1) + texelFetch(u_scene, at, 2) + texelFetch(u_scene, at, 3)), at);
}
