#version 330 core
layout(location = 0) in vec4 a_clip;
layout(location = 1) in vec2 a_offset;    // pixels from the middle of the line or dot
layout(location = 2) in float a_half_width;  // pixels
layout(location = 3) in vec2 a_dash;      // length of dashes, place along the line; pixels
layout(location = 4) in vec4 a_colour;    // sRGB-coded, opacity
layout(location = 5) in float a_hidden;   // factor on the opacity behind the surface

noperspective out vec2 v_offset;
noperspective out float v_along;
flat out float v_half_width;
flat out float v_dash;
flat out vec4 v_colour;
flat out float v_hidden;

void main() {
  v_offset = a_offset;
  v_along = a_dash.y;
  v_half_width = a_half_width;
  v_dash = a_dash.x;
  v_colour = a_colour;
  v_hidden = a_hidden;
  gl_Position = a_clip;
}
