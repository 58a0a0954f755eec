#version 330 core
uniform sampler2D u_edges;   // premultiplied light of pieces in pixels that they cover in part
uniform sampler2D u_depths;  // their device depth
uniform vec2 u_between;      // device depths from which and up to which they are laid
out vec4 o_colour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(u_depths, at, 0).r;
  if (depth < u_between.x || depth >= u_between.y) discard;
  o_colour = texelFetch(u_edges, at, 0);
}
