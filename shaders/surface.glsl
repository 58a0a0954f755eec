// What is known of the nearest surface: its depth along the viewing direction in metres, and where it goes on the picture.
uniform mat4 u_view_projection;  // world to clip
uniform vec2 u_size;             // picture, pixels
uniform float u_low;             // rows of it below those that are drawn
uniform float u_frame;           // time that motion is measured over, s
out vec4 o_surface;

// Depth, m; motion to the right and up, pixels; 1.
vec4 surfaceAt(vec3 velocity) {
  // clip = matrix * (place, 1) is linear, so the next frame's is this one's and the matrix times the way moved. The last row of
  // the matrix makes w the depth.
  float depth = 1.0 / gl_FragCoord.w;
  vec2 here = (gl_FragCoord.xy + vec2(0.0, u_low)) / u_size * 2.0 - 1.0;
  vec4 way = u_view_projection * vec4(velocity * u_frame, 0.0);
  // What would pass the eye within a frame has no place on the next picture; it goes as far as a twentieth of its depth.
  float next_depth = max(depth + way.w, 0.05 * depth);
  return vec4(depth, 0.5 * u_size * (way.xy - here * (next_depth - depth)) / next_depth, 1.0);
}
