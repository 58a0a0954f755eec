#version 330 core
uniform vec2 u_middle;   // pixels
uniform float u_radius;  // of the clear circle, pixels
out vec4 o_colour;       // linear, premultiplied

void main() {
  float r = distance(gl_FragCoord.xy, u_middle);
  // A little darker towards the rim, as in real binoculars, then the tube.
  float rim = smoothstep(0.86, 1.0, r / u_radius);
  float tube = clamp(r - u_radius + 0.5, 0.0, 1.0);
  o_colour = vec4(vec3(0.006), 1.0) * max(tube, 0.35 * rim * rim);
}
