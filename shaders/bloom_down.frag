#version 330 core
// Half the size by the filter [1 3 3 1] / 8 along each axis: four looks between texels.
uniform sampler2D u_from;
uniform vec2 u_size;  // of u_from, texels
out vec4 o_colour;

void main() {
  vec2 at = 2.0 * gl_FragCoord.xy;
  vec4 sum = texture(u_from, (at + vec2(-0.75, -0.75)) / u_size) + texture(u_from, (at + vec2(0.75, -0.75)) / u_size);
  sum += texture(u_from, (at + vec2(-0.75, 0.75)) / u_size) + texture(u_from, (at + vec2(0.75, 0.75)) / u_size);
  o_colour = 0.25 * sum;
}
