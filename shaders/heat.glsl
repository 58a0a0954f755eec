// Light that hot pieces give off (app/render/heat.h).
uniform vec3 u_emitted[32];  // at 700 K, 800 K, ...

vec3 emittedLight(float temperature) {
  float at = (temperature - 700.0) / 100.0;
  if (at <= 0.0) return vec3(0.0);
  int i = min(int(at), 30);
  return mix(u_emitted[i], u_emitted[i + 1], min(at - float(i), 1.0));
}
