#version 330 core
layout(location = 0) in vec2 a_corner;  // pixels from the lower left
uniform vec2 u_size;    // picture, pixels
uniform float u_depth;  // normalised device depth, 1 = far plane

void main() { gl_Position = vec4(a_corner / u_size * 2.0 - 1.0, u_depth, 1.0); }
