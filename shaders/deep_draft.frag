#version 330 core
#include "deep.glsl"
#include "enlarged.glsl"

void main() {
  vec2 pixel = gl_FragCoord.xy + vec2(0.0, float(u_low));
  finishDeep(enlargedAt(pixel), ivec2(pixel));
}
