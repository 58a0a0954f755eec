#version 330 core
uniform vec3 u_eye;          // world m
uniform vec3 u_ray_origin;   // world direction through the target's lower left corner, one unit deep
uniform vec3 u_ray_x;        // change of that direction per pixel to the right
uniform vec3 u_ray_y;        // and per pixel up
uniform float u_height;      // ground height, world m
out vec4 o_surface;          // depth, m; motion, pixels; 1

void main() {
  float ray_y = u_ray_origin.y + gl_FragCoord.x * u_ray_x.y + gl_FragCoord.y * u_ray_y.y;
  float depth = (u_height - u_eye.y) / ray_y;
  if (!(depth > 0.0 && abs(ray_y) > 1e-6)) discard;
  o_surface = vec4(depth, 0.0, 0.0, 1.0);
}
