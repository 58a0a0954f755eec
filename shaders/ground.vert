#version 330 core
uniform mat4 u_view_projection;  // world to clip
uniform vec3 u_centre;           // point of the ground below the eye, world m
uniform float u_reach;           // half side of the square drawn, m

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  gl_Position = u_view_projection * vec4(u_centre + vec3(corner.x, 0.0, corner.y) * u_reach, 1.0);
}
