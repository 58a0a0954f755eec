#version 330 core
layout(location = 0) in vec3 a_corner;  // x and z relative to the eye, m; ground height in the world, m (in z)
layout(location = 1) in float a_skirt;  // m below

uniform mat4 u_view_projection;  // eye-relative to clip
uniform vec2 u_eye_height;       // x: height of the eye, y: of the sea; world m
uniform vec4 u_place;            // eye's place as a share of the terrain (x, z), and shares per metre

out vec3 v_place;      // relative to the eye, m
out float v_ground;    // world m
out vec2 v_share;      // place as a share of the terrain

void main() {
  float shown = max(a_corner.z, u_eye_height.y);
  v_place = vec3(a_corner.x, shown - u_eye_height.x - a_skirt, a_corner.y);
  v_ground = a_corner.z;
  v_share = u_place.xy + a_corner.xy * u_place.zw;
  gl_Position = u_view_projection * vec4(v_place, 1.0);
}
