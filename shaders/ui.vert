#version 330 core
// The editor's panels: pixels from the upper left corner to clip space.
layout(location = 0) in vec2 position;  // px
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 colour;    // sRGB-coded, straight alpha

uniform vec2 size;  // px

out vec2 fragment_texel;
out vec4 fragment_colour;

void main() {
  fragment_texel = texel;
  fragment_colour = colour;
  gl_Position = vec4(2.0 * position.x / size.x - 1.0, 1.0 - 2.0 * position.y / size.y, 0.0, 1.0);
}
