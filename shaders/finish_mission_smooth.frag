#version 330 core
#include "finish_mission.glsl"
uniform sampler2DMS u_scene;  // linear light, four samples a pixel

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  o_colour = finishedMission(0.25 * (texelFetch(u_scene, at, 0) + texelFetch(u_scene, at, 1) + texelFetch(u_scene, at, 2) + texelFetch(u_scene, at, 3)).rgb);
}
