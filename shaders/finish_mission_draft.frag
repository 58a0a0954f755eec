#version 330 core
#include "finish_mission.glsl"
uniform sampler2D u_scene;   // linear light, in a part of the texture
uniform vec2 u_per_pixel;    // its texels for a pixel
uniform vec2 u_used;         // texels of it that are drawn
uniform vec2 u_texels;       // of the whole texture

void main() {
  vec2 at = clamp(gl_FragCoord.xy * u_per_pixel, vec2(0.5), u_used - 0.5);
  o_colour = finishedMission(texture(u_scene, at / u_texels).rgb);
}
