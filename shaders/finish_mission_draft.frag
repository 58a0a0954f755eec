#version 330 core
#include "finish_mission.glsl"
#include "enlarged.glsl"

void main() { o_colour = finishedMission(enlargedAt(gl_FragCoord.xy).rgb); }
