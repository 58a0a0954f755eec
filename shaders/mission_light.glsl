// Light and air of a mission; included after common.glsl. Places are relative to the eye.
const int kMostFlares = 6;
uniform float u_night;        // 1 by night
uniform float u_extinction;   // of the air, per metre
uniform float u_eye_over_sea; // m
uniform float u_eye_haze;     // density of the haze at the eye, 1 at the sea
uniform int u_flare_count;
uniform vec4 u_flare[kMostFlares];           // place relative to the eye, m; lit radius, m
uniform float u_flare_strength[kMostFlares]; // 0..1

const vec3 kNightKey = vec3(0.055, 0.068, 0.095);      // the moon, from where the sun stands by day
const vec3 kNightAmbient = vec3(0.020, 0.026, 0.040);
const vec3 kNightHorizon = vec3(0.022, 0.029, 0.045);
const vec3 kNightZenith = vec3(0.006, 0.009, 0.018);
const vec3 kFlareLight = vec3(1.25, 1.10, 0.78);

const float kHazeHeight = 1500.0;  // over which the haze thins to 1 / e, m

vec3 airColour() { return mix(kHorizon, kNightHorizon, u_night); }

vec3 flareLight(vec3 place, vec3 normal) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < u_flare_count; ++i) {
    vec3 to = u_flare[i].xyz - place;
    float square = dot(to, to) / (u_flare[i].w * u_flare[i].w);
    float lit = u_flare_strength[i] / (1.0 + 1.5 * square * (1.0 + square));
    sum += kFlareLight * (lit * (0.25 + 0.75 * max(dot(normal, to) * inversesqrt(max(dot(to, to), 1e-6)), 0.0)));
  }
  return sum;
}

// Diffuse light of the hour on a surface, with its openness to the sky.
vec3 missionLight(vec3 place, vec3 normal, float open) {
  float lambert = max(dot(normal, kKeyDirection), 0.0);
  vec3 day = kKeyLight * lambert + ambientLight(normal) * open;
  if (u_night < 0.5 && u_flare_count == 0) return day;
  vec3 night = kNightKey * lambert + kNightAmbient * open;
  return mix(day, night, u_night) + flareLight(place, normal);
}

// What the air leaves of a light that comes from a distance, and adds.
// The haze thins with height, so that from high above the ground is clear: `rise` is the place's height over the eye.
vec3 throughAir(vec3 light, float rise, float distance_m) {
  float there = exp(-(u_eye_over_sea + rise) / kHazeHeight);
  float mean = abs(rise) < 2.0 ? there : (u_eye_haze - there) * kHazeHeight / rise;
  return mix(airColour(), light, exp(-u_extinction * mean * distance_m));
}

vec3 missionSky(vec3 direction) {
  float up = clamp(direction.y * inversesqrt(dot(direction, direction)), 0.0, 1.0);
  float haze = 1.0 - up;
  haze *= haze;
  haze *= haze;
  // In fog the sky is white far up: the air's own thickness of some hundred metres against the visibility.
  haze = max(haze, exp(-up * 3.2 / max(u_extinction * 1600.0, 1e-3)));
  return mix(mix(kZenith, kNightZenith, u_night), airColour(), haze);
}
