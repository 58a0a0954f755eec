#version 330 core
flat in vec4 v_flat;
in vec4 v_smooth;
uniform float u_facets;  // 1: one light per facet, 0: interpolated
out vec4 o_colour;

void main() { o_colour = u_facets > 0.5 ? v_flat : v_smooth; }
