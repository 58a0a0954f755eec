#version 330 core
// Double the size by a tent; blended onto what is there.
uniform sampler2D u_from;
uniform vec2 u_size;    // of u_from, texels
uniform float u_scale;
out vec4 o_colour;

void main() {
  vec2 at = 0.5 * gl_FragCoord.xy;
  vec4 sum = texture(u_from, (at + vec2(-0.5, -0.5)) / u_size) + texture(u_from, (at + vec2(0.5, -0.5)) / u_size);
  sum += texture(u_from, (at + vec2(-0.5, 0.5)) / u_size) + texture(u_from, (at + vec2(0.5, 0.5)) / u_size);
  o_colour = vec4((0.25 * u_scale) * sum.rgb, 0.0);
}
