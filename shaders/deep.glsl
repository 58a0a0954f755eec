// Finishes a picture in single precision: as on the screen, or as linear light.
#include "finish.glsl"
uniform float u_effect;  // 1: the scene's texture holds the effect here, 0: there is none
uniform int u_low;       // rows of the picture below those that are finished
uniform int u_linear;    // 1: scene light, premultiplied; 0: coded as on the screen

// Takes back rolledOff: the backdrop is kept as it is displayed.
vec3 unrolled(vec3 c) {
  vec3 over = clamp((c - kKnee) / (1.0 - kKnee), 0.0, 0.999);
  return min(c, kKnee) + (1.0 - kKnee) * over / (1.0 - over);
}

void finishDeep(vec4 scene, ivec2 at) {
  scene *= u_effect;
  scene.rgb = u_exposure * bloomed(scene.rgb, at);
  if (u_linear == 0) {
    o_colour = coded(scene, at);
    return;
  }
  float cover = min(scene.a, 1.0);
  vec3 behind = u_behind == 2 ? unrolled(behindAt(at)) : behindAt(at);
  o_colour = u_behind == 0 ? vec4(scene.rgb, cover) : vec4(scene.rgb + (1.0 - cover) * behind, 1.0);
}
