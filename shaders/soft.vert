#version 330 core
#include "common.glsl"
#include "clip.glsl"
#include "glow.glsl"
// Soft forms, sorted from back to front. One particle per instance.
layout(location = 0) in float a_x;     // world m
layout(location = 1) in float a_y;
layout(location = 2) in float a_z;
layout(location = 3) in float a_size;  // m
layout(location = 4) in float a_r;     // sRGB-coded
layout(location = 5) in float a_g;
layout(location = 6) in float a_b;
layout(location = 7) in float a_a;     // opacity
layout(location = 8) in float a_vx;    // world m/s
layout(location = 9) in float a_vy;
layout(location = 10) in float a_vz;
layout(location = 11) in float a_seed; // 0..1, the particle's own
layout(location = 12) in vec3 a_light;  // of smoke: optical depth towards the sun from its lit and its far side; share of the sky
layout(location = 14) in float a_kind; // 0 streak, 1 smoke, 2 fire, 3 flash

uniform mat4 u_view_projection;  // world to clip
uniform vec3 u_eye;              // world m
uniform vec3 u_right;            // camera axes in the world
uniform vec3 u_up;
uniform float u_metre_per_pixel; // metres that a pixel spans at a distance of one metre

flat out vec4 v_colour;   // linear, straight opacity
flat out float v_kind;
flat out vec2 v_noise;    // the particle's place in the noise
flat out vec2 v_turn;     // its rotation, cosine and sine
out vec2 v_disc;          // -1..1
out float v_above;        // height over the ground, m
flat out float v_clear;
flat out float v_radius;  // m
flat out vec3 v_velocity; // world m/s
flat out float v_dense;   // of a puff: its cover is 1 - (1 + 4 v_dense)^-2 through the middle
flat out vec3 v_shade;    // share of the sun on the lit side and on the far side, share of the sky
flat out vec3 v_glow;     // light of flashes and fire on a cloud

// As leftThrough of smoke_shade.h.
vec2 leftThrough(vec2 depth) {
  vec2 q = 1.0 + 0.5 * depth;
  return 1.0 / (q * q);
}

const float kShutter = 1.0 / 50.0;  // s, what a streak's length shows of its motion

// Corners of the octagon around the unit disc, in the order of a strip: a sixth of a square's pixels lie outside a disc.
const float kShort = 0.41421357;  // tan(22.5 degrees)
const vec2 kOctagon[8] = vec2[8](vec2(-1.0, -kShort), vec2(-kShort, -1.0), vec2(-1.0, kShort), vec2(kShort, -1.0),
                                 vec2(-kShort, 1.0), vec2(1.0, -kShort), vec2(kShort, 1.0), vec2(1.0, kShort));

// A streak is a rectangle; what is left of its strip has no area.
vec2 cornerOf(bool streak) {
  int n = min(gl_VertexID, 3);
  return streak ? vec2(float(n & 1), float(n >> 1)) * 2.0 - 1.0 : kOctagon[gl_VertexID];
}

void main() {
  vec2 corner = cornerOf(a_kind < 0.5);
  vec3 centre = vec3(a_x, a_y, a_z);
  vec3 to_eye = u_eye - centre;
  float pixel = u_metre_per_pixel * length(to_eye);
  float opacity = a_a;
  vec3 place;
  if (a_kind < 0.5) {
    vec3 velocity = vec3(a_vx, a_vy, a_vz);
    float speed = length(velocity);
    vec3 along = speed > 1e-4 ? velocity / speed : u_up;
    vec3 side = cross(along, to_eye);
    float side_length = length(side);
    side = side_length > 1e-5 ? side / side_length : u_right;
    float width = max(0.16 * a_size, 0.9 * pixel);
    float reach = max(0.5 * a_size + 0.5 * kShutter * speed, width);
    v_radius = width;
    place = centre + along * (reach * corner.y) + side * (width * corner.x);
    place.y += width;
  } else {
    float radius = max(0.5 * a_size, pixel);
    v_radius = radius;
    place = centre + radius * (corner.x * u_right + corner.y * u_up);
  }
  float angle = 6.2831853 * a_seed;
  v_turn = vec2(cos(angle), sin(angle));
  v_noise = vec2(fract(a_seed * 17.0), fract(a_seed * 61.0));
  v_colour = vec4(linearFromSrgb(vec3(a_r, a_g, a_b)), opacity);
  v_kind = a_kind;
  v_dense = 0.25 * (inversesqrt(1.0 - 0.965 * clamp(opacity, 0.0, 1.0)) - 1.0);
  // What a bright cloud stops of the light it mostly passes on forwards, so that it is as if it were thinner (similarity relation).
  float albedo = dot(v_colour.rgb, vec3(0.3333));
  v_shade = vec3(leftThrough(a_light.xy * (1.0 - 0.75 * albedo)), 0.35 + 0.65 * a_light.z);
  v_velocity = vec3(a_vx, a_vy, a_vz);
  // A cloud scatters what comes from any side: half of what a facing surface would get.
  vec3 towards = u_glow_place.xyz - centre;
  v_glow = 0.5 * u_glow / (dot(towards, towards) + u_glow_place.w);
  v_disc = corner;
  v_above = place.y - groundUnder(place.xz);
  v_clear = clearTo(length(to_eye));
  gl_ClipDistance[0] = clipDistance(place.y);
  gl_Position = u_view_projection * vec4(place, 1.0);
}
