#version 330 core
uniform sampler2DMS u_samples;  // premultiplied light of the pieces, four samples a pixel
uniform sampler2DMS u_depths;   // device depth; 1 where there is none
uniform float u_one_piece;      // factor on the distance within which samples belong together
layout(location = 0) out vec4 o_whole;  // what hides all behind it
layout(location = 1) out vec4 o_edge;   // what covers the pixel in part
layout(location = 2) out float o_near;  // its device depth; 2: nothing is kept

// As kOpaque of solid_pass.h.
const float kOpaque = 0.998;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 depths = vec4(texelFetch(u_depths, at, 0).r, texelFetch(u_depths, at, 1).r, texelFetch(u_depths, at, 2).r, texelFetch(u_depths, at, 3).r);
  mat4 light = mat4(texelFetch(u_samples, at, 0), texelFetch(u_samples, at, 1), texelFetch(u_samples, at, 2), texelFetch(u_samples, at, 3));
  float nearest = min(min(depths.x, depths.y), min(depths.z, depths.w));
  // The distance is as 1 / (1 - depth), but for the far plane's share.
  vec4 near = step(1.0 - nearest, (1.0 - depths) * u_one_piece);
  vec4 front = 0.25 * (light * near);
  float others = 4.0 - dot(near, vec4(1.0));
  vec4 behind = others > 0.0 ? light * (1.0 - near) / others : vec4(0.0);
  bool whole = front.a >= kOpaque;
  // Of two pieces in one pixel the one behind hides what is behind it.
  vec4 behind_depths = mix(depths, vec4(1.0), near);
  float second = behind.a >= kOpaque ? min(min(behind_depths.x, behind_depths.y), min(behind_depths.z, behind_depths.w)) : 1.0;
  o_whole = whole ? front : behind;
  o_edge = whole ? vec4(0.0) : front;
  o_near = whole || front.a <= 0.0 ? 2.0 : nearest;
  gl_FragDepth = whole ? nearest : second;
}
