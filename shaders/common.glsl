// Shared by all shaders: world is x east, y up, z south, metres; colours are linear unless said otherwise.

// Sun or moon by the hour of an explosion (app/render/hour_light.cpp); missions keep the afternoon's.
uniform vec3 u_towards_key = vec3(-0.5263, 0.7105, 0.4671);  // unit length: afternoon sun in the south-west
uniform vec3 u_key_light = vec3(1.42, 1.32, 1.16);
#define kKeyDirection u_towards_key
#define kKeyLight u_key_light
const vec3 kSkyAmbient = vec3(0.30, 0.35, 0.42);
const vec3 kGroundAmbient = vec3(0.21, 0.19, 0.165);
const vec3 kHorizon = vec3(0.450, 0.510, 0.560);
const vec3 kZenith = vec3(0.110, 0.200, 0.345);

// sRGB-coded to linear, within 0.002 of IEC 61966-2-1 over 0..1, without a power function.
vec3 linearFromSrgb(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }

vec3 ambientLight(vec3 normal) { return mix(kGroundAmbient, kSkyAmbient, 0.5 + 0.5 * normal.y); }

vec3 litDiffuse(vec3 albedo, vec3 normal) {
  return albedo * (kKeyLight * max(dot(normal, kKeyDirection), 0.0) + ambientLight(normal));
}

// In a mission the light of the hour and the air between count; elsewhere both stay as they are by default.
uniform float u_dimmed = 0.0;          // share of the light that is missing
uniform vec3 u_daylight = vec3(1.0);   // on the sun and the sky, by the hour of an explosion
uniform float u_haze_extinction = 0.0; // of the air, per metre
uniform vec3 u_haze_colour = vec3(0.0);

vec3 dimmed(vec3 light) { return light * (u_daylight * (1.0 - u_dimmed)); }
// Without haze exactly 1, which a driver's exp(0) need not be.
float clearTo(float distance_m) { return u_haze_extinction > 0.0 ? exp(-u_haze_extinction * distance_m) : 1.0; }
