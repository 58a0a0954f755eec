// The one lamp that stands for all flashes and fire of an effect.
uniform vec4 u_glow_place = vec4(0.0, 0.0, 0.0, 1.0);  // world m, squared radius
uniform vec3 u_glow = vec3(0.0);                       // linear light times m2

// Light on a surface at a place. The lamp is a ball, so that ground it touches gets light at a slant too.
vec3 glowLight(vec3 place, vec3 normal) {
  vec3 towards = u_glow_place.xyz - place;
  float d2 = dot(towards, towards) + u_glow_place.w;
  float slant = dot(normal, towards) + 0.6 * sqrt(u_glow_place.w);
  return u_glow * (max(slant, 0.0) / (d2 * sqrt(d2)));
}
