#version 330 core
#include "finish_mission.glsl"
uniform sampler2D u_scene;  // linear light

void main() { o_colour = finishedMission(texelFetch(u_scene, ivec2(gl_FragCoord.xy), 0).rgb); }
