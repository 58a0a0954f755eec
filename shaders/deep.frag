#version 330 core
#include "deep.glsl"
uniform sampler2D u_scene;  // linear premultiplied light of the effect

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) + ivec2(0, u_low);
  finishDeep(texelFetch(u_scene, at, 0), at);
}
