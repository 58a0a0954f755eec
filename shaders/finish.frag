#version 330 core
// From linear, premultiplied light to the picture: highlights rolled off, background added, sRGB-coded, straight alpha.
uniform sampler2D u_scene;       // linear premultiplied light
uniform vec4 u_background;       // sRGB-coded; alpha 0 = transparent
uniform vec3 u_background_light; // the same, linear
uniform int u_flip_height;       // 0: as it is; else the height in pixels, and rows are written from the top
out vec4 o_colour;

// Identity up to the knee, then smoothly towards 1, so that plain colours stay what they are and fire does not clip.
vec3 rolledOff(vec3 c) {
  const float kKnee = 0.80;
  vec3 over = max(c - kKnee, 0.0) / (1.0 - kKnee);
  return min(c, kKnee) + (1.0 - kKnee) * over / (1.0 + over);
}

vec3 srgbFromLinear(vec3 c) {
  vec3 high = 1.055 * pow(max(c, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  if (u_flip_height > 0) at.y = u_flip_height - 1 - at.y;
  vec4 scene = texelFetch(u_scene, at, 0);
  // A plain background passes through unchanged to the last bit.
  if (scene.a <= 0.0 && max(max(scene.r, scene.g), scene.b) <= 0.0) {
    o_colour = u_background;
    return;
  }
  vec3 light = rolledOff(scene.rgb);
  if (u_background.a > 0.5) {
    o_colour = vec4(srgbFromLinear(min(light + (1.0 - min(scene.a, 1.0)) * u_background_light, 1.0)), 1.0);
    return;
  }
  // Light without cover (a flash's halo) needs some alpha to be kept in a picture without background.
  float alpha = min(max(scene.a, max(max(light.r, light.g), light.b)), 1.0);
  o_colour = vec4(srgbFromLinear(min(light / max(alpha, 1e-4), 1.0)), alpha);
}
