#version 330 core
// One triangle over the whole target, from the vertex number alone.
uniform float u_depth;  // normalised device depth, 1 = far plane

void main() {
  vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
  gl_Position = vec4(corner * 2.0 - 1.0, u_depth, 1.0);
}
