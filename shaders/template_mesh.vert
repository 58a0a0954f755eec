#version 330 core
layout(location = 0) in vec3 a_position;  // template space
layout(location = 1) in vec3 a_normal;    // unit, out of the shape

uniform mat4 u_view_projection;  // template space to clip

out vec3 v_position;
out vec3 v_normal;

void main() {
  v_position = a_position;
  v_normal = a_normal;
  gl_Position = u_view_projection * vec4(a_position, 1.0);
}
