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

vec4 puff() {
  float r2 = dot(v_disc, v_disc);
  if (r2 >= 1.0) discard;
  vec2 turned = vec2(v_turn.x * v_disc.x - v_turn.y * v_disc.y, v_turn.y * v_disc.x + v_turn.x * v_disc.y);
  float noise = texture(u_noise, v_noise + turned * 0.22).r * 0.65 + texture(u_noise, v_noise.yx + turned * 0.55).r * 0.35;
  noise = clamp((noise - 0.5) * 2.0 + 0.5, 0.0, 1.0);
  float edge = 1.0 - r2;
  float density = clamp(edge * 1.9 - (1.0 - noise) * 1.25 * (0.30 + r2), 0.0, 1.0);
  float a = v_colour.a * density * density * (3.0 - 2.0 * density) * groundFade();
  if (v_kind < 1.5) {
    vec3 normal = normalize(v_disc.x * u_right + v_disc.y * u_up + (sqrt(edge) + 0.35 * noise) * u_back);
    // Light wraps around a cloud.
    float wrapped = clamp(dot(normal, kKeyDirection) * 0.6 + 0.4, 0.0, 1.0);
    vec3 light = kKeyLight * wrapped * (0.55 + 0.45 * noise) + ambientLight(normal);
    return vec4(mix(u_haze_colour * a, dimmed(v_colour.rgb * light * a), v_clear), a);
  }
  float heat = density * density * (0.6 + 0.8 * noise);
  vec3 glow = v_colour.rgb * (0.9 + 2.6 * heat) + vec3(0.9, 0.45, 0.12) * heat * heat;
  return vec4(mix(u_haze_colour * (0.85 * a), glow * a, v_clear), a * 0.85);
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
  if (v_kind < 2.5) return puff();
  return flash();
}
