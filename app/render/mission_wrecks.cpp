#include "app/render/mission_wrecks.h"

#include "app/render/mission_models.h"
#include "app/render/mission_scene.h"
#include "sim/fragments/shells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace npsee::render {
namespace {

/// A burst nearer to the middle of a vehicle than this flings its pieces. From there on it is fuel and ammunition that do so, from inside;
/// beyond the second distance the vehicle burns out in one piece. m.
constexpr double kByBurst_m = 9.0, kByLoad_m = 35.0;
/// How far from the middle of the vehicle, towards the burst, what it carries goes off, m.
constexpr double kInside_m = 0.7;
/// Pixels from which pieces are told from a wreck in one.
constexpr double kLeastPixels = 14.0;
/// A colour after the fire, as a share of what it was.
constexpr double kBurnt = 0.38;

/// Mass over outer volume of vehicles of a class, kg/m3, and how many pieces they make. Game values.
struct Make {
  double density_kgpm3;
  int pieces;
};
Make makeOf(TargetClass kind) {
  switch (kind) {
    case TargetClass::heavy_armor: return {1700.0, 46};
    case TargetClass::light_armor: return {800.0, 52};
    case TargetClass::wheeled: return {330.0, 70};
    case TargetClass::aircraft: return {260.0, 60};
    case TargetClass::watercraft: return {300.0, 50};
    case TargetClass::personnel: break;
  }
  return {1000.0, 20};
}

Colour burnt(const Colour& c) { return {kBurnt * c.r + 0.02, kBurnt * c.g + 0.018, kBurnt * c.b + 0.016}; }

}  // namespace

std::optional<Undoing> undoingOf(const Recording& recording, std::size_t vehicle, double time_s) {
  const VehicleRecord& record = recording.vehicles[vehicle];
  if (record.type.target_class == TargetClass::personnel || !record.destroyedAt(time_s)) return std::nullopt;
  const auto end = std::ranges::find_if(record.damage, [](const DamageStep& step) { return step.hull >= 1.0; });
  const Vec3 at = recording.vehiclePlace(vehicle, end->t_s);
  std::vector<int> bursts;
  recording.burstsSince(end->t_s, 0.06, bursts);
  std::optional<Undoing> out;
  double nearest = kByLoad_m;
  for (const int index : bursts) {
    const ShellRecord& shell = recording.shells[static_cast<std::size_t>(index)];
    const double distance = length(shell.burst_m - at);
    if (shell.burst_s != end->t_s || shell.smoke || shell.illumination || distance >= nearest) continue;
    nearest = distance;
    const bool inside = distance >= kByBurst_m;
    out = Undoing{end->t_s, inside ? at + (kInside_m / distance) * (shell.burst_m - at) : shell.burst_m, shell.seed + 7919 * vehicle, shell.gun >= 0 && !inside};
  }
  return out;
}

bool drawnInPieces(const MissionEye& eye, const MissionView& view, const Vec3& at, double length_m) {
  const double depth = std::max(-dot(eye.lens.back, at - eye.lens.eye), 0.1);
  const double least_px = eye.kind == MissionCamera::Kind::observer ? 0.0 : view.least_px;
  if (enlargement(eye, length_m, depth, least_px) > 1.0) return false;
  return length_m / depth / (2.0 * std::tan(0.5 * eye.lens.fov_y_rad) / eye.height) >= kLeastPixels;
}

std::shared_ptr<const SolidModel> burntSolid(const Model& model, const ModelInstance& instance, const Vec3& origin_m) {
  auto out = std::make_shared<SolidModel>();
  out->name = model.name;
  Solid surface;
  std::map<std::tuple<float, float, float, float>, std::uint16_t> known;
  for (const ModelPart& part : model.parts) {
    const PartAxes axes = axesOf(instance, part);
    const Vec3 at = instance.at_m - origin_m + axes.at;
    for (std::size_t i = part.first; i + 2 < part.first + part.count; i += 3) {
      const Model::Vertex& vertex = model.vertices[i];
      const auto [place, fresh] = known.try_emplace({vertex.colour[0], vertex.colour[1], vertex.colour[2], vertex.paint}, static_cast<std::uint16_t>(out->materials.size()));
      if (fresh) {
        const Colour own{static_cast<double>(vertex.colour[0]), static_cast<double>(vertex.colour[1]), static_cast<double>(vertex.colour[2])};
        out->materials.push_back({"", FacetPaint::own, burnt(vertex.paint > 1.5f ? instance.accent : vertex.paint > 0.5f ? instance.body : own)});
      }
      const auto first = static_cast<std::uint32_t>(surface.points.size());
      for (std::size_t corner = i; corner < i + 3; ++corner) {
        const auto& p = model.vertices[corner].position;
        surface.points.push_back(at + static_cast<double>(p[0]) * axes.right + static_cast<double>(p[1]) * axes.up + static_cast<double>(p[2]) * axes.back);
      }
      surface.facets.push_back({{first, first + 1, first + 2}, place->second});
    }
  }
  out->shells = fragments::shellsOf(std::move(surface));
  return out->shells.empty() ? nullptr : out;
}

Preset wreckPreset(const VehicleType& type, const Undoing& undoing, const Vec3& origin_m, double height_m) {
  const Make make = makeOf(type.target_class);
  Preset out;
  out.seed = static_cast<std::int64_t>(undoing.seed & 0xffffffffu);
  Layer layer;
  layer.name = "wreck";
  layer.form = Form::pieces;
  layer.count = make.pieces;
  layer.lifetime_mean_s = 600.0;
  layer.lifetime_deviation_s = 0.0;
  layer.drag_ps = 0.03;
  layer.restitution = 0.22;
  layer.friction = 0.5;
  layer.bounce_limit = 5;
  layer.rest_speed_mps = 0.9;
  layer.colour = {0.20, 0.19, 0.18};
  layer.pieces_density_kgpm3 = make.density_kgpm3;
  layer.pieces_impulse_Pas = undoing.shell ? 9000.0 : 5500.0;
  layer.pieces_reach_m = undoing.shell ? 3.0 : 1.6;
  layer.pieces_burst_m = undoing.burst_m - origin_m;
  // Nothing strikes from under the ground: a burst at its feet is as deep in the vehicle as its belly.
  layer.pieces_burst_m.y = height_m + std::clamp(layer.pieces_burst_m.y - height_m, 0.25, 3.0);
  out.layers.push_back(std::move(layer));
  return out;
}

}  // namespace npsee::render
