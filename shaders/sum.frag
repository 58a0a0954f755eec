#version 330 core
uniform sampler2D u_scene;  // linear premultiplied light of one look
uniform float u_weight;
out vec4 o_colour;

void main() { o_colour = u_weight * texelFetch(u_scene, ivec2(gl_FragCoord.xy), 0); }
