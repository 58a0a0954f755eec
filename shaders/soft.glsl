// The light and cover of a soft form at a fragment.
#include "common.glsl"
#include "clip.glsl"
flat in vec4 v_colour;
flat in float v_kind;
flat in vec2 v_noise;
flat in vec2 v_turn;
in vec2 v_disc;
in float v_above;         // height over the ground, m
flat in float v_clear;    // share of the light that the air lets through
flat in float v_radius;
flat in float v_dense;    // of a puff: its cover is 1 - (1 + 4 v_dense)^-2 through the middle
flat in vec3 v_shade;     // share of the sun on the lit side and on the far side, share of the sky
flat in vec3 v_glow;      // light of flashes and fire on a cloud

uniform float u_detail = 1.0;   // 0: coarse noise alone, for drafts
uniform sampler2D u_noise;   // tiling value noise, 0..1
uniform vec3 u_right;        // camera axes in the world
uniform vec3 u_up;
uniform vec3 u_back;         // towards the eye

// Rounds off where a disc would cut the ground in a hard line.
float groundFade() { return u_fade == 0.0 ? 1.0 : clamp(v_above / (0.35 * v_radius) + 0.04, 0.0, 1.0); }

vec4 streak() {
  // On slivers thinner than a pixel the corners' values are carried on beyond the edge, where cover would be negative.
  float across = max(1.0 - abs(v_disc.x), 0.0);
  float along = max(1.0 - v_disc.y * v_disc.y, 0.0);
  float a = v_colour.a * smoothstep(0.0, 0.7, across) * along;
  return vec4(mix(u_haze_colour * a, v_colour.rgb * (1.2 + 2.0 * across * along) * a, v_clear), a);
}

// What smoke and fire have in common at a fragment.
struct Cloud {
  float a;      // cover
  float body;   // share of the densest, 0..1
  float noise;  // 0..1
  float edge;   // 1 in the middle, 0 at the rim
};

// A ball of cloud whose rim is eaten by noise, so that neighbours run into each other instead of standing as balls. Its cover follows
// the length of the chord through it, as that of a medium does.
Cloud cloudHere() {
  float r2 = dot(v_disc, v_disc);
  if (r2 >= 1.0) discard;
  vec2 turned = vec2(v_turn.x * v_disc.x - v_turn.y * v_disc.y, v_turn.y * v_disc.x + v_turn.x * v_disc.y);
  float coarse = texture(u_noise, v_noise + turned * 0.13).r;
  // The coarse billows drag the fine ones along, which makes wisps of dots.
  float fine = coarse;
  if (u_detail > 0.5) fine = texture(u_noise, v_noise.yx + turned * 0.42 + (coarse - 0.5) * 0.30).r;
  float noise = clamp((0.6 * coarse + 0.4 * fine - 0.5) * 2.3 + 0.5, 0.0, 1.0);
  float edge = 1.0 - r2;
  float body = clamp(1.5 * (edge - 0.85 * (1.0 - noise)), 0.0, 1.0);
  float depth = v_dense * body * (1.0 + 3.0 * body);
  float a = depth * (2.0 + depth) / ((1.0 + depth) * (1.0 + depth)) * groundFade();
  return Cloud(a, body, noise, edge);
}

vec4 smokeLight(Cloud cloud) {
  float bulge = sqrt(cloud.edge);
  vec3 normal = normalize(v_disc.x * u_right + v_disc.y * u_up + (bulge + 0.35 * cloud.noise) * u_back);
  // Light wraps around a cloud, and its hollows lie in shadow.
  float facing = dot(normal, kKeyDirection);
  float wrapped = clamp(facing * 0.62 + 0.38, 0.0, 1.0);
  float sun = wrapped * mix(v_shade.y, v_shade.x, 0.5 + 0.5 * facing);
  // Even soot scatters some of what meets it; without it the sun would draw no side on it.
  vec3 albedo = v_colour.rgb + 0.045;
  vec3 light = kKeyLight * (1.3 * sun * (0.35 + 0.65 * cloud.noise)) + ambientLight(normal) * (v_shade.z * (0.7 + 0.3 * cloud.noise));
  return vec4(mix(u_haze_colour * cloud.a, (dimmed(albedo * light) + albedo * v_glow) * cloud.a, v_clear), cloud.a);
}

vec4 fireLight(Cloud cloud) {
  float heat = cloud.body * cloud.body * (0.6 + 0.8 * cloud.noise);
  vec3 glow = v_colour.rgb * (0.9 + 2.6 * heat) + vec3(0.9, 0.45, 0.12) * heat * heat;
  return vec4(mix(u_haze_colour * (0.85 * cloud.a), glow * cloud.a, v_clear), cloud.a * 0.85);
}

vec4 flash() {
  float r = length(v_disc);
  if (r >= 1.0) discard;
  float fall = 1.0 - r;
  float halo = fall * fall * fall;
  float core = smoothstep(0.62, 0.15, r);
  float a = v_colour.a * groundFade();
  vec3 light = v_colour.rgb * (1.1 * halo + 3.0 * core) + vec3(core);
  return vec4(light * a * v_clear, a * core);
}

// Premultiplied.
vec4 softLight() {
  if (v_kind < 0.5) return streak();
  if (v_kind > 2.5) return flash();
  Cloud cloud = cloudHere();
  if (v_kind < 1.5) return smokeLight(cloud);
  return fireLight(cloud);
}
