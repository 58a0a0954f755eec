#version 330 core
flat in vec3 v_light;  // linear
out vec4 o_colour;

void main() { o_colour = vec4(v_light, 1.0); }
