// Parts of the ground's shaders: land near and far, sea, and shores with both. A driver that runs both sides of every branch pays for the sea
// on dry land otherwise.
in vec3 v_place;     // relative to the eye, m
in float v_ground;   // world m
in vec2 v_share;     // place as a share of the terrain

uniform sampler2D u_map;    // land by day: square root of the linear colour; roughness
uniform sampler2D u_noise;  // tiling
uniform vec2 u_eye_height;  // x: height of the eye, y: of the sea; world m
uniform vec4 u_noise_at;    // eye's place in the noise: far and near period, as shares
uniform vec2 u_noise_scale; // 1 / period, far and near, per metre
uniform vec4 u_lines;       // contour interval m (0: by distance), strength, grid spacing m, 1: map
uniform vec2 u_grid_at;     // eye's place within the grid, m
uniform float u_pixel;      // metres a pixel spans at one metre

const vec3 kShallow = vec3(0.060, 0.150, 0.165), kDeep = vec3(0.014, 0.052, 0.088);
// Mean light of the day that the map holds, to see the land by other light.
const vec3 kDayMean = vec3(1.27, 1.22, 1.14);

// Cover of a line `pixels` wide at distance `at` (in spacings) from it, where a pixel spans `change` spacings. Where lines crowd
// they fade: at four pixels from one to the next they are gone.
float lineCover(float at, float change, float pixels) {
  float near = abs(fract(at - 0.5) - 0.5) / max(change, 1e-6);
  return clamp(pixels * 0.5 + 0.5 - near, 0.0, 1.0) * clamp(0.1 / max(change, 1e-6) - 0.4, 0.0, 1.0);
}

// Plants and stones are seen from near; from far they melt into the map's colour.
float nearLook(float distance_m, float rough) {
  vec2 at = v_place.xz * u_noise_scale.y;
  float coarse = texture(u_noise, u_noise_at.zw + at).r - 0.5, fine = texture(u_noise, fract(u_noise_at.zw * 13.0) + 13.0 * at).r - 0.5;
  // A pixel at a grazing angle spans more ground.
  float pixel = distance_m * u_pixel * clamp(distance_m / max(abs(v_place.y), 0.01), 1.0, 60.0);
  float finest = 0.0;
  if (pixel < 0.6) finest = (texture(u_noise, fract(u_noise_at.zw * 83.0) + 83.0 * at).r - 0.5) * clamp(1.0 - pixel / 0.6, 0.0, 1.0);
  return 1.0 + rough * (0.45 * coarse / (1.0 + 0.05 * pixel) + 1.10 * fine / (1.0 + 1.2 * pixel) + 1.30 * finest);
}

vec3 land(float distance_m, bool from_near) {
  vec4 map = texture(u_map, v_share);
  vec3 light = map.rgb * map.rgb;
  if (from_near) light *= nearLook(distance_m, map.a);
  if (u_night > 0.5 || u_flare_count > 0) {
    vec3 normal = normalize(cross(dFdx(v_place), dFdy(v_place)));
    vec3 dark = mix(vec3(1.0), (kNightKey * 0.7 + kNightAmbient) / kDayMean, u_night);
    light *= dark + flareLight(v_place, normal.y < 0.0 ? -normal : normal) / kDayMean;
  }
  return light;
}

vec3 sea(vec3 toward, float distance_m, float depth) {
  float ripple = texture(u_noise, u_noise_at.zw * 3.0 + v_place.xz * u_noise_scale.y * 3.0).r - 0.5;
  float swell = texture(u_noise, u_noise_at.xy * 5.0 + v_place.xz * u_noise_scale.x * 5.0).r - 0.5;
  float near = clamp(60.0 / (distance_m * u_pixel * 40.0 + 1.0), 0.0, 1.0);
  vec3 normal = normalize(vec3(0.10 * ripple * near + 0.03 * swell, 1.0, 0.08 * (ripple - swell) * near));
  vec3 body = mix(kShallow, kDeep, clamp(depth / 9.0, 0.0, 1.0)) * missionLight(v_place, vec3(0.0, 1.0, 0.0), 1.0);
  float glance = 1.0 - clamp(dot(normal, toward), 0.0, 1.0);
  float fresnel = 0.02 + 0.55 * glance * glance * glance * glance;
  vec3 mirrored = reflect(-toward, normal);
  mirrored.y = abs(mirrored.y);
  vec3 colour = mix(body, missionSky(mirrored), fresnel);
  float glint = max(dot(mirrored, kKeyDirection), 0.0);
  glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint;
  return colour + (1.0 - u_night) * kKeyLight * 0.35 * glint;
}

float contours(float distance_m) {
  float interval = u_lines.x;
  if (interval <= 0.0) interval = distance_m * u_pixel < 2.2 ? 10.0 : (distance_m * u_pixel < 9.0 ? 20.0 : 50.0);
  float at = v_ground / interval, change = fwidth(v_ground) / interval;
  // A plain has no contours, even if it lies at a contour's height.
  float sloping = smoothstep(2e-5, 2e-4, change);
  return sloping * max(0.55 * lineCover(at, change, 1.0), lineCover(0.2 * at, 0.2 * change, u_lines.w > 0.5 ? 1.8 : 1.3));
}

float gridLines() {
  vec2 place = (u_grid_at + v_place.xz) / u_lines.z;
  vec2 change = fwidth(v_place.xz) / u_lines.z;
  return 0.6 * max(lineCover(place.x, change.x, 1.0), lineCover(place.y, change.y, 1.0));
}

vec4 finished(vec3 light, float marks, float distance_m) {
  light *= 1.0 - (u_lines.w > 0.5 ? 0.55 : 0.30) * u_lines.y * marks;
  return vec4(u_lines.w > 0.5 ? light : throughAir(light, v_place.y, distance_m), 1.0);
}
