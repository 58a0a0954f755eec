#version 330 core
#include "common.glsl"
noperspective in vec2 v_offset;
noperspective in float v_along;
flat in float v_half_width;
flat in float v_dash;
flat in vec4 v_colour;
flat in float v_hidden;

uniform float u_behind;  // 1: this pass draws what lies behind the surface

out vec4 o_colour;  // linear, premultiplied

void main() {
  float cover = clamp(v_half_width + 0.5 - length(v_offset), 0.0, 1.0);
  if (v_dash > 0.0) {
    // Distance into the gap, so that its ends are as soft as the sides.
    float phase = mod(v_along, 2.0 * v_dash);
    cover *= clamp(0.5 * v_dash - abs(phase - 0.5 * v_dash) + 0.5, 0.0, 1.0);
  }
  float alpha = cover * v_colour.a * mix(1.0, v_hidden, u_behind);
  if (alpha <= 0.0) discard;
  o_colour = vec4(linearFromSrgb(v_colour.rgb) * alpha, alpha);
}
