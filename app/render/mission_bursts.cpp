#include "app/render/mission_bursts.h"

#include "app/render/effect_tiles.h"
#include "app/render/meshes.h"
#include "app/render/mission_models.h"
#include "app/render/mission_scene.h"
#include "app/render/mission_smoke.h"
#include "app/render/renderer.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

/// Memory that compiled explosions may take, bytes, and how long ago a burst may be to be looked at, s.
constexpr std::size_t kMostBytes = 192u << 20;
constexpr double kLongest_s = 300.0;
/// Solid pieces of a layer that are drawn at least, and per pixel of the burst's radius: a far burst needs few.
constexpr double kLeastPieces = 120.0, kPiecesPerPixel = 14.0;
/// A burst this far above the ground is in the air, m.
constexpr double kAirBurst_m = 2.0;
/// Explosions outside the picture by more than this are not compiled, m.
constexpr double kReach_m = 400.0;
/// How far the pieces of a vehicle go.
constexpr double kFlung_m = 80.0;

/// The terrain as seen from a burst, which is its origin. Pieces fall on the sea as on land.
class PlacedGround final : public Ground {
 public:
  PlacedGround(const Terrain& terrain, const Vec3& at) : terrain_(terrain), at_(at) {}
  double height(double x, double z) const override { return terrain_.surface(x + at_.x, z + at_.z) - at_.y; }
  double detail() const override { return terrain_.detail(); }
  bool flat() const override { return terrain_.flat(); }

 private:
  const Terrain& terrain_;
  Vec3 at_;
};

/// The preset as it bursts there: in the air, or on the ground; in the mission's wind where that has one.
Preset placed(const Preset& preset, double height_m, const Vec3& wind) {
  Preset out = preset;
  if (height_m > kAirBurst_m) {
    out.burst = BurstKind::air;
    out.burst_height_m = height_m;
  }
  if (length(wind) > 0.0) out.wind_mps = wind;
  return out;
}

bool mayBeSeen(const MissionEye& eye, const Vec3& at, double radius_m) {
  const Vec3 from = at - eye.lens.eye;
  const double depth = -dot(eye.lens.back, from);
  if (depth < -radius_m) return false;
  const double tan_y = std::tan(0.5 * eye.lens.fov_y_rad), tan_x = tan_y * eye.width / eye.height;
  return std::abs(dot(eye.lens.right, from)) < std::max(depth, 0.0) * tan_x + radius_m * (1.0 + tan_x) && std::abs(dot(eye.lens.up, from)) < std::max(depth, 0.0) * tan_y + radius_m * (1.0 + tan_y);
}

}  // namespace

std::shared_ptr<const Preset> MissionBursts::presetOf(const Recording& recording, const ShellRecord& shell, const MissionView& view) {
  for (const int number : {shell.number, 0})
    if (const auto found = view.presets.find(number); found != view.presets.end() && found->second != nullptr) return found->second;
  // Where the mission names none: what a weapon of that kind does.
  const std::string name = !shell.preset.empty() ? shell.preset : shell.gun < 0 ? "impact_small" : "howitzer_155";
  return shelf_.find(name, recording.scenario.folder);
}

std::shared_ptr<const Explosion> MissionBursts::compiledFor(const Recording& recording, Key key, int threads, const std::function<std::shared_ptr<const SolidModel>(Key&)>& model) {
  const auto found = std::ranges::find(kept_, key, &Kept::key);
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return found->explosion;
  }
  const PlacedGround ground(recording.terrain, key.at);
  CompileOptions options;
  options.threads = threads;
  if (model) options.model = model(key);
  std::shared_ptr<const Explosion> compiled;
  if (!model || options.model != nullptr)
    if (auto explosion = Explosion::compile(placed(*key.preset, -ground.height(0.0, 0.0), key.wind), key.seed, &ground, options)) compiled = std::move(*explosion);
  kept_.push_front({key, std::move(compiled)});
  if (kept_.front().explosion) kept_bytes_ += kept_.front().explosion->memoryBytes();
  while (kept_bytes_ > kMostBytes && kept_.size() > 1) {
    if (kept_.back().explosion) kept_bytes_ -= kept_.back().explosion->memoryBytes();
    kept_.pop_back();
  }
  return kept_.front().explosion;
}

MissionBursts::Drawn& MissionBursts::next() {
  if (spare_.empty()) spare_.emplace_back();
  bursts_.push_back(std::move(spare_.back()));
  spare_.pop_back();
  return bursts_.back();
}

void MissionBursts::addBurst(const Recording& recording, const ShellRecord& shell, double time_s, const MissionView& view, const MissionEye& eye) {
  const Key key{presetOf(recording, shell, view), shell.seed, shell.burst_m, recording.scenario.world.weather.wind_mps};
  const double age = time_s - shell.burst_s;
  if (age > longestDuration(*key.preset) || !mayBeSeen(eye, shell.burst_m, kReach_m)) return;
  const auto explosion = compiledFor(recording, key, view.threads);
  if (explosion == nullptr || age > explosion->duration_s()) return;
  const Extent& extent = explosion->extent();
  const Vec3 centre = shell.burst_m + extent.centre();
  if (!mayBeSeen(eye, centre, std::max(extent.radius_m(), extent.reach_m) + 5.0)) return;

  Drawn& drawn = next();
  drawn.origin = shell.burst_m;
  drawn.layers = explosion->layers();
  drawn.depth_m = -dot(eye.lens.back, centre - eye.lens.eye);
  explosion->at(age, drawn.frame, kSceneFields, view.threads);
  // Pieces of a layer are independent draws, so its first ones are a fair sample of all.
  const double metre_per_pixel = 2.0 * std::tan(0.5 * eye.lens.fov_y_rad) / eye.height * std::max(drawn.depth_m, 1.0);
  const double pieces = kLeastPieces + kPiecesPerPixel * extent.radius_m() / metre_per_pixel;
  for (LayerSpan& layer : drawn.layers)
    if (isSolid(layer.form) && static_cast<double>(layer.count) > pieces) layer.count = static_cast<std::size_t>(pieces);
  drawn.ground = groundAt(recording.terrain, shell.burst_m, eye.lens.eye, light_);
  drawn.ground.glow = glowOf(drawn.frame, drawn.layers);
}

void MissionBursts::addWreck(const Recording& recording, std::size_t vehicle, const Undoing& undoing, double time_s, const MissionView& view, const MissionEye& eye, const ModelPass& models) {
  const VehicleRecord& record = recording.vehicles[vehicle];
  Key wanted;
  wanted.seed = undoing.seed;
  wanted.at = recording.vehiclePlace(vehicle, undoing.time_s);
  wanted.vehicle = static_cast<int>(vehicle);
  wanted.since_s = undoing.time_s;
  const auto explosion = compiledFor(recording, wanted, view.threads, [&](Key& key) {
    // As it stood just before.
    const double before_s = std::nextafter(undoing.time_s, -1.0);
    const ModelInstance instance = vehicleInstance(recording, vehicle, before_s, aimedAt(recording, static_cast<int>(vehicle), before_s), models);
    key.preset = std::make_shared<const Preset>(wreckPreset(record.type, undoing, key.at, instance.at_m.y - key.at.y));
    return burntSolid(models.models()[instance.model], instance, key.at);
  });
  if (explosion == nullptr || explosion->layers().empty()) return;
  in_pieces_[vehicle] = 1;
  Drawn& drawn = next();
  drawn.origin = wanted.at;
  drawn.layers = explosion->layers();
  drawn.depth_m = -dot(eye.lens.back, wanted.at - eye.lens.eye);
  // What lies, lies on.
  explosion->at(std::min(time_s - undoing.time_s, 0.99 * explosion->duration_s()), drawn.frame, kVelocity | kLook | kOrientation, view.threads);
  drawn.ground = groundAt(recording.terrain, wanted.at, eye.lens.eye, light_);
}

void MissionBursts::addWrecks(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const ModelPass& models) {
  struct Near {
    double depth_m;
    std::size_t vehicle;
    Undoing undoing;
  };
  std::vector<Near> near;
  in_pieces_.assign(recording.vehicles.size(), 0);
  for (std::size_t i = 0; i < recording.vehicles.size(); ++i) {
    const VehicleRecord& record = recording.vehicles[i];
    if (record.damage.empty() || record.track.legs.empty()) continue;
    const auto undoing = undoingOf(recording, i, time_s);
    if (!undoing) continue;
    const Vec3 at = recording.vehiclePlace(i, time_s);
    if (!drawnInPieces(eye, view, at, drawnLength(record.type)) || !mayBeSeen(eye, at, kFlung_m)) continue;
    near.push_back({-dot(eye.lens.back, at - eye.lens.eye), i, *undoing});
  }
  std::ranges::stable_sort(near, {}, &Near::depth_m);
  if (near.size() > kMostInPieces) near.resize(kMostInPieces);
  for (const Near& wreck : near) addWreck(recording, wreck.vehicle, wreck.undoing, time_s, view, eye, models);
}

void MissionBursts::prepare(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const MissionLight& light, const ModelPass& models) {
  if (ground_ != recording.terrain.heights().data()) {
    kept_.clear();
    kept_bytes_ = 0;
    ground_ = recording.terrain.heights().data();
  }
  for (Drawn& drawn : bursts_) spare_.push_back(std::move(drawn));
  bursts_.clear();
  light_ = light;
  std::vector<int> recent;
  recording.burstsSince(time_s, kLongest_s, recent);
  // The youngest first; ties by number.
  std::ranges::sort(recent, [&](int a, int b) {
    const ShellRecord &first = recording.shells[static_cast<std::size_t>(a)], &second = recording.shells[static_cast<std::size_t>(b)];
    return first.burst_s != second.burst_s ? first.burst_s > second.burst_s : a < b;
  });
  for (const int index : recent) {
    if (bursts_.size() >= kMostBursts) break;
    const ShellRecord& shell = recording.shells[static_cast<std::size_t>(index)];
    // Light and smoke have their own looks, unless the mission asks for a preset.
    if ((!shell.illumination && !shell.smoke) || !shell.preset.empty()) addBurst(recording, shell, time_s, view, eye);
  }
  addWrecks(recording, time_s, view, eye, models);
  for (Smoke& smoke : missionSmoke(recording, time_s, eye)) {
    Drawn& drawn = next();
    drawn.origin = smoke.origin;
    drawn.frame = std::move(smoke.frame);
    drawn.layers = std::move(smoke.layers);
    drawn.ground = groundAt(recording.terrain, smoke.origin, eye.lens.eye, light_);
    drawn.depth_m = -dot(eye.lens.back, smoke.origin - eye.lens.eye);
  }
  std::ranges::stable_sort(bursts_, [](const Drawn& a, const Drawn& b) { return a.depth_m > b.depth_m; });
}

Expected<void> MissionBursts::drawOpaque(EffectPasses& effects, const MissionEye& eye) {
  for (const Drawn& drawn : bursts_) {
    const View view = eye.viewFrom(drawn.origin);
    effects.upload(drawn.frame, drawn.layers);
    if (drawn.ground.land && drawn.ground.height_m > -60.0)
      if (auto done = effects.drawScorch(drawn.frame, drawn.layers, view, drawn.ground); !done) return done;
    if (!light_.night && drawn.ground.height_m > -60.0)
      if (auto done = effects.drawShadows(drawn.frame, drawn.layers, view, drawn.ground); !done) return done;
    if (drawn.ground.height_m > -60.0)
      if (auto done = effects.drawGlow(view, drawn.ground); !done) return done;
    if (drawn.ground.height_m > -60.0)
      if (auto done = effects.drawShockRings(drawn.frame, drawn.layers, view, drawn.ground); !done) return done;
    if (auto done = effects.drawOpaque(drawn.frame, drawn.layers, view, drawn.ground); !done) return done;
  }
  return {};
}

Expected<void> MissionBursts::drawBlended(EffectPasses& effects, const MissionEye& eye) {
  for (const Drawn& drawn : bursts_) {
    const View view = eye.viewFrom(drawn.origin);
    if (auto done = effects.drawBlended(drawn.frame, drawn.layers, view, drawn.ground); !done) return done;
    if (!std::ranges::any_of(drawn.layers, [](const LayerSpan& layer) { return layer.form == Form::shock; })) continue;
    effects.upload(drawn.frame, drawn.layers);
    if (auto done = effects.drawShockShells(drawn.frame, drawn.layers, view, drawn.ground); !done) return done;
  }
  return {};
}

void MissionBursts::markBright(TileMask& mask, const MissionEye& eye) const {
  for (const Drawn& drawn : bursts_) render::markBright(mask, drawn.frame, drawn.layers, eye.viewFrom(drawn.origin));
}

std::size_t MissionBursts::particles() const {
  std::size_t sum = 0;
  for (const Drawn& drawn : bursts_)
    for (const LayerSpan& layer : drawn.layers) sum += layer.count;
  return sum;
}

}  // namespace npsee::render
