#version 330 core
in vec2 fragment_texel;
in vec4 fragment_colour;

uniform sampler2D picture;  // the font's coverage, or a picture shown in a panel

out vec4 colour;

void main() { colour = fragment_colour * texture(picture, fragment_texel); }
