#version 330 core
uniform sampler2D u_draft;  // premultiplied
uniform vec2 u_picture;     // its size, pixels
uniform int u_straight;     // 1: the picture wants straight colours
out vec4 o_colour;

void main() {
  vec4 draft = texture(u_draft, gl_FragCoord.xy / u_picture);
  o_colour = u_straight == 1 ? vec4(draft.rgb / max(draft.a, 1e-4), draft.a) : draft;
}
