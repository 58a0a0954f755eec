uniform sampler2D u_scene;   // linear premultiplied light of a draft, in a part of the texture
uniform vec2 u_per_pixel;    // its texels for a pixel of the picture
uniform vec2 u_used;         // texels of it that are drawn
uniform vec2 u_texels;       // of the whole texture

/// The draft's light at a place of the picture, in pixels.
vec4 enlargedAt(vec2 pixel) {
  vec2 at = clamp(pixel * u_per_pixel, vec2(0.5), u_used - 0.5);
  return texture(u_scene, at / u_texels);
}
