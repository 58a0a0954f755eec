#include "sim/observer/engine.h"

#include <algorithm>
#include <cmath>

namespace npsee {

using namespace observer;

namespace {

double rounded(double value, double to) { return std::floor(value / to + 0.5) * to; }

}  // namespace

bool Mission::State::sees(const Post& post, const Vec3& point, double max_range_m) const {
  const double range = levelDistance(post.eye_m, point);
  Weather weather = rec.scenario.world.weather;
  if (weather.night && litAt(point)) weather.night = false;
  if (!visibleThrough(post.setup->sensing, weather, range, max_range_m) || smokeBetween(post.eye_m, point)) return false;
  return rec.scenario.fdc.sampled_visibility ? rec.terrain.sightSampled(post.eye_m, point) : rec.terrain.sees(post.eye_m, point);
}

bool Mission::State::litAt(const Vec3& point) const {
  for (const Cloud& light : lights)
    if (now_s <= light.until_s && levelDistance(light.place_m, point) <= light.radius_m) return true;
  return false;
}

/// Smoke stands as an upright cylinder; the line of sight is cut where it passes below its top within the radius.
bool Mission::State::smokeBetween(const Vec3& from, const Vec3& to) const {
  for (const Cloud& smoke : smokes) {
    if (now_s > smoke.until_s) continue;
    const Vec3 d = to - from;
    const double d2 = d.x * d.x + d.z * d.z;
    const double along = d2 > 0.0 ? std::clamp(((smoke.place_m.x - from.x) * d.x + (smoke.place_m.z - from.z) * d.z) / d2, 0.0, 1.0) : 0.0;
    const Vec3 nearest = from + along * d;
    if (levelDistance(nearest, smoke.place_m) <= smoke.radius_m && nearest.y <= smoke.place_m.y + kSmokeHeight_m) return true;
  }
  return false;
}

/// Every observer looks at every vehicle once in kLookTicks; which of them now depends on both, so that no tick has all the work.
void Mission::State::sense() {
  const auto count = static_cast<std::int64_t>(rec.vehicles.size());
  for (std::size_t p = 0; p < posts.size(); ++p) {
    Post& post = posts[p];
    if (!post.alive) continue;
    const auto carrier = static_cast<std::size_t>(post.vehicle);
    if (rec.vehicles[carrier].destroyedAt(now_s)) {
      post.alive = false;
      for (FireMission& mission : missions)
        if (mission.post == static_cast<int>(p) && !mission.over) endMission(mission, "abandoned", "The observer's vehicle is destroyed.", nullptr);
      continue;
    }
    const Vec3 foot = vehicleAt(post.vehicle);
    post.eye_m = {foot.x, foot.y + post.setup->eye_height_m, foot.z};
    const bool moving = vehicles->speed()[carrier] > 0.0;
    post.mind->self({.x_m = rounded(foot.x + post.own_error_m.x, 1.0), .z_m = rounded(foot.z + post.own_error_m.z, 1.0), .type = post.setup->type,
                     .max_range_m = post.setup->max_range_m, .moving = moving, .night = rec.scenario.world.weather.night, .method = post.setup->method, .self_preservation = post.setup->self_preservation});
    if (tick == 0) {
      for (std::int64_t v = 0; v < count; ++v) look(static_cast<int>(p), static_cast<int>(v));
      continue;
    }
    const std::int64_t first = (tick + 7 * static_cast<std::int64_t>(p)) % kLookTicks;
    for (std::int64_t v = first; v < count; v += kLookTicks) look(static_cast<int>(p), static_cast<int>(v));
  }
}

void Mission::State::look(int p, int v) {
  Post& post = posts[static_cast<std::size_t>(p)];
  if (v == post.vehicle) return;
  const VehicleRecord& vehicle = rec.vehicles[static_cast<std::size_t>(v)];
  const double x = vehicles->x()[static_cast<std::size_t>(v)], z = vehicles->z()[static_cast<std::size_t>(v)];
  const double dx = x - post.eye_m.x, dz = z - post.eye_m.z, reach = post.setup->max_range_m;
  const bool known = post.knows[static_cast<std::size_t>(v)].known;
  // Most vehicles are out of reach: found out before anything dear.
  if (dx * dx + dz * dz > reach * reach) {
    if (known) missed(p, v);
    return;
  }
  // Whatever of it stands highest is seen first.
  const Vec3 top{x, rec.terrain.surface(x, z) + vehicle.type.height_m, z};
  if (sees(post, top, reach)) gained(p, v, std::sqrt(dx * dx + dz * dz));
  else if (known) missed(p, v);
}

/// Dempster-Shafer: each independent look adds evidence whose weight falls with range; a wrong look takes one side for another.
void Mission::State::weigh(Post& post, int v, double range_m) {
  Acquaintance& a = post.knows[static_cast<std::size_t>(v)];
  const Side side = rec.vehicles[static_cast<std::size_t>(v)].type.side;
  const Sensing& sensing = post.setup->sensing;
  if (!sensing.limited_belief) {
    a.evidence = {side == Side::hostile ? 1.0 : 0.0, side == Side::hostile ? 0.0 : 1.0, 0.0};
    return;
  }
  if (now_s - a.evidence_s < kEvidence_s) return;
  a.evidence_s = now_s;
  const double belief = beliefAt(sensing, range_m);
  const auto entity = static_cast<std::uint32_t>(&post - posts.data());
  const double draw = uniforms(rec.scenario.seed, entity * static_cast<std::uint32_t>(kMaxVehicles) + static_cast<std::uint32_t>(v), Purpose::sensing, a.looks++)[0];
  const bool mistaken = draw < 0.25 * (1.0 - belief);
  const bool hostile = (side == Side::hostile) != mistaken;
  const Combined combined = combine(a.evidence, {hostile ? belief : 0.0, hostile ? 0.0 : belief, 1.0 - belief});
  a.evidence = combined.evidence;
  a.conflict = combined.conflict;
}

void Mission::State::gained(int p, int v, double range_m) {
  Post& post = posts[static_cast<std::size_t>(p)];
  Acquaintance& a = post.knows[static_cast<std::size_t>(v)];
  const bool first = !a.seen;
  a.known = a.seen = true;
  a.misses = 0;
  weigh(post, v, range_m);
  a.believed_m = vehicleAt(v) + a.error_m;
  a.believed_m.y = rec.terrain.surface(a.believed_m.x, a.believed_m.z);
  if (first) {
    log(EventKind::contact, now_s).fields = {{"observer", post.setup->id},
                                             {"target", vehicleId(v)},
                                             {"type", rec.vehicles[static_cast<std::size_t>(v)].type.name},
                                             {"type_index", std::int64_t{rec.vehicles[static_cast<std::size_t>(v)].type.index}},
                                             {"position", a.believed_m},
                                             {"range_m", range_m},
                                             {"azimuth_mil", bearing(post.eye_m, a.believed_m) * kMilsPerRadian},
                                             {"belief", a.evidence.hostile},
                                             {"conflict", a.conflict}};
  }
  tell(p, v, range_m);
}

void Mission::State::missed(int p, int v) {
  Post& post = posts[static_cast<std::size_t>(p)];
  Acquaintance& a = post.knows[static_cast<std::size_t>(v)];
  if (!a.seen || ++a.misses < kLooksUntilLost) return;
  a.seen = false;
  log(EventKind::lost, now_s).fields = {{"observer", post.setup->id}, {"target", vehicleId(v)}, {"position", a.believed_m}, {"reason", std::string("out of sight")}};
  tell(p, v, levelDistance(post.eye_m, a.believed_m));
}

double Mission::State::nearestFriendly(const Vec3& place, int except, int* who) const {
  double best2 = kFriendlySearch_m * kFriendlySearch_m;
  int best = -1;
  for (const int f : friendlies) {
    if (f == except) continue;
    const double dx = vehicles->x()[static_cast<std::size_t>(f)] - place.x, dz = vehicles->z()[static_cast<std::size_t>(f)] - place.z;
    const double d2 = dx * dx + dz * dz;
    if (d2 >= best2 || rec.vehicles[static_cast<std::size_t>(f)].destroyedAt(now_s)) continue;
    best2 = d2;
    best = f;
  }
  if (who) *who = best;
  return best < 0 ? 1e9 : std::sqrt(best2);
}

Contact::Condition Mission::State::condition(int v) const {
  const DamageStep* damage = rec.vehicles[static_cast<std::size_t>(v)].damageAt(now_s);
  if (!damage) return Contact::Condition::whole;
  if (damage->hull >= 1.0) return Contact::Condition::destroyed;
  return damage->mobility && damage->firepower && damage->hull < 0.1 ? Contact::Condition::whole : Contact::Condition::damaged;
}

/// What the rules are told of a contact, rounded so that facts change seldom, and what the recording keeps of his belief.
void Mission::State::tell(int p, int v, double range_m) {
  Post& post = posts[static_cast<std::size_t>(p)];
  Acquaintance& a = post.knows[static_cast<std::size_t>(v)];
  const VehicleType& type = rec.vehicles[static_cast<std::size_t>(v)].type;
  Contact fact{.id = v, .type = type.index, .type_name = type.name};
  fact.x_m = rounded(a.believed_m.x, 10.0);
  fact.z_m = rounded(a.believed_m.z, 10.0);
  fact.range_m = rounded(range_m, 10.0);
  fact.azimuth_mil = rounded(bearing(post.eye_m, a.believed_m) * kMilsPerRadian, 10.0);
  fact.speed_mps = rounded(vehicles->speed()[static_cast<std::size_t>(v)], 1.0);
  fact.location_error_m = post.setup->sensing.location_cep_m + post.setup->sensing.own_cep_m;
  fact.hostile = rounded(a.evidence.hostile, 0.01);
  fact.friendly = rounded(a.evidence.friendly, 0.01);
  fact.condition = a.seen ? condition(v) : a.fact.condition;
  fact.seen = a.seen;
  const double friendly = type.side == Side::hostile || post.setup->sensing.limited_belief ? nearestFriendly(a.believed_m, v) : 1e9;
  fact.friendly_distance_m = friendly > kFriendlySearch_m ? 1e9 : rounded(friendly, 50.0);
  post.mind->contact(fact);
  post.dirty = true;
  const bool changed = fact.seen != a.fact.seen || a.recorded_s < 0.0;
  a.fact = std::move(fact);
  // Between two steps the viewport lets the ghost stand; twice a second would be too much for a thousand vehicles.
  if (!changed && now_s - a.recorded_s < 2.0) return;
  a.recorded_s = now_s;
  int number = 0;
  for (const FireMission& mission : missions)
    if (!mission.over && mission.post == p && mission.target == v) number = mission.number;
  rec.observers[static_cast<std::size_t>(p)].beliefs.push_back({now_s, v, a.seen, a.believed_m, a.evidence.hostile, a.evidence.friendly, number});
}

}  // namespace npsee
