#version 330 core
// Square around the base plane's disc, from the vertex number alone.
uniform mat4 u_view_projection;  // template space to clip
uniform float u_reach;           // radius of the disc, template units
uniform float u_level;           // height of the plane

out vec2 v_place;  // x, z

void main() {
  v_place = (vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0) * u_reach;
  gl_Position = u_view_projection * vec4(v_place.x, u_level, v_place.y, 1.0);
}
