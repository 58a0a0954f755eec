#include "sim/explosion/pieces.h"

#include "sim/core/elementary.h"
#include "sim/explosion/compile.h"
#include "sim/preset/stream.h"

#include <algorithm>
#include <cmath>

namespace npsee::explosion {
namespace {

struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
          a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

Quaternion unit(const Quaternion& q) {
  const double size = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return size > 0.0 ? Quaternion{q.x / size, q.y / size, q.z / size, q.w / size} : Quaternion{};
}

Vec3 turned(const Quaternion& q, const Vec3& v) {
  const Vec3 axis{q.x, q.y, q.z}, t = 2.0 * cross(axis, v);
  return v + q.w * t + cross(axis, t);
}

/// The shortest turn that brings one unit vector onto another.
Quaternion between(const Vec3& from, const Vec3& to) {
  const double w = 1.0 + dot(from, to);
  if (w < 1e-9) return std::fabs(from.x) < 0.9 ? unit({0.0, from.z, -from.y, 0.0}) : unit({-from.z, 0.0, from.x, 0.0});
  const Vec3 axis = cross(from, to);
  return unit({axis.x, axis.y, axis.z, w});
}

/// A face that a piece can lie on: nothing of the piece is beyond its plane.
struct Face {
  Vec3 normal;
  double distance_m = 0.0;  ///< of its plane from the centre of mass
  double area_m2 = 0.0;
};

std::vector<Face> facesOf(const Piece& piece) {
  std::vector<Face> out;
  for (const Facet& facet : piece.solid.facets) {
    const Vec3 a = piece.solid.points[facet.corners[0]];
    const Vec3 across = cross(piece.solid.points[facet.corners[1]] - a, piece.solid.points[facet.corners[2]] - a);
    const double size = length(across);
    if (!(size > 1e-9 * piece.radius_m * piece.radius_m)) continue;
    const Vec3 normal = (1.0 / size) * across;
    const double distance = dot(normal, a);
    // Triangles of one face count together.
    const auto known = std::ranges::find_if(out, [&](const Face& face) { return dot(face.normal, normal) > 0.9999; });
    if (known != out.end()) {
      known->area_m2 += 0.5 * size;
      continue;
    }
    const bool hull = std::ranges::all_of(piece.solid.points, [&](const Vec3& p) { return dot(normal, p) <= distance + 0.02 * piece.radius_m; });
    if (hull && distance > 0.0) out.push_back({normal, distance, 0.5 * size});
  }
  return out;
}

Quaternion orientationAt(const Chunk& chunk, std::size_t p, double age) {
  double sine = 0.0, cosine = 1.0;
  sineCosine(0.5 * (static_cast<double>(chunk.phase_rad[p]) + static_cast<double>(chunk.rate_radps[p]) * age), sine, cosine);
  return {static_cast<double>(chunk.axis_x[p]) * sine, static_cast<double>(chunk.axis_y[p]) * sine, static_cast<double>(chunk.axis_z[p]) * sine, cosine};
}

/// A piece turns onto the face that points down most when it would come to rest, large ones sooner, over its last hop or this long, s.
constexpr double kLongestTurn_s = 0.6;

void settle(const Piece& piece, const Chunk& chunk, std::size_t p, const Vec3& up, PiecePose& pose) {
  const std::vector<Face> faces = facesOf(piece);
  if (faces.empty()) return;
  const Arc* arcs = chunk.arcs.data() + chunk.first_arc[p];
  const std::size_t rest = chunk.rest_arc[p];
  const double end = arcs[rest].start_s, before = rest > 1 ? arcs[rest - 1].start_s : 0.0;
  const Quaternion tumbled = orientationAt(chunk, p, end);
  const double largest = std::ranges::max(faces, {}, &Face::area_m2).area_m2;
  const Face* best = nullptr;
  double best_score = -10.0;
  for (const Face& face : faces) {
    const double score = -dot(turned(tumbled, face.normal), up) + 0.8 * std::sqrt(face.area_m2 / largest);
    if (score > best_score) best_score = score, best = &face;
  }
  const Quaternion lying = product(between(turned(tumbled, best->normal), -1.0 * up), tumbled);
  pose.settled = {static_cast<float>(lying.x), static_cast<float>(lying.y), static_cast<float>(lying.z), static_cast<float>(lying.w)};
  pose.settled_rise_m = static_cast<float>(best->distance_m);
  pose.settle_to_s = end;
  pose.settle_from_s = std::max(before, end - kLongestTurn_s);
}

/// How far a piece has turned onto its face, 0 to 1, with a soft start and end.
double settledShare(const PiecePose& pose, double age) {
  if (pose.settle_to_s <= pose.settle_from_s) return pose.settle_to_s > 0.0 && age >= pose.settle_to_s ? 1.0 : 0.0;
  const double part = std::clamp((age - pose.settle_from_s) / (pose.settle_to_s - pose.settle_from_s), 0.0, 1.0);
  return part * part * (3.0 - 2.0 * part);
}

/// Between two orientations along the straight line in their space: the same way as the shortest turn, a little faster in its middle.
Quaternion mixed(const Quaternion& a, const Quaternion& b, double share) {
  const double sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0.0 ? -1.0 : 1.0, rest = 1.0 - share, s = sign * share;
  return unit({rest * a.x + s * b.x, rest * a.y + s * b.y, rest * a.z + s * b.z, rest * a.w + s * b.w});
}

/// What air leaves of a piece's speed by its area over its mass: the quadratic law of a tumbling body over its first moments, which stops a pane
/// of glass and hardly slows an engine. What follows is the layer's own drag, the same for all.
///
///   v' = v / (1 + v t / L),   L = 2 m / (rho C S / 4)
///
/// v speed from the burst [m/s], t = 0.3 s, m mass [kg], S surface [m^2], rho = 1.225 kg/m^3, C = 1.1 [-]. S / 4 is the mean area that a convex body
/// shows in all directions (Cauchy 1841). Valid for pieces that turn over many times; docs/physics.md.
double speedLeft(const Piece& piece, double speed_mps) {
  constexpr double kTime_s = 0.3, kDensity_kgpm3 = 1.225, kCoefficient = 1.1;
  double twice_surface = 0.0;
  for (const Facet& facet : piece.solid.facets) {
    const Vec3 a = piece.solid.points[facet.corners[0]];
    twice_surface += length(cross(piece.solid.points[facet.corners[1]] - a, piece.solid.points[facet.corners[2]] - a));
  }
  if (!(piece.mass.mass_kg > 0.0)) return speed_mps;
  return speed_mps / (1.0 + speed_mps * kTime_s * (kDensity_kgpm3 * kCoefficient * 0.125 * twice_surface) / (2.0 * piece.mass.mass_kg));
}

/// In the order in which the burst reaches them: particles of a layer that takes its time start one after the other.
Expected<std::shared_ptr<const Fragments>> nearestFirst(Expected<std::shared_ptr<const Fragments>> cut, const Vec3& burst) {
  if (!cut) return cut;
  auto sorted = std::make_shared<Fragments>(**cut);
  std::ranges::stable_sort(sorted->pieces, {}, [&](const Piece& piece) { return length(piece.mass.centre_m - burst); });
  return std::shared_ptr<const Fragments>(std::move(sorted));
}

}  // namespace

Expected<std::shared_ptr<const Fragments>> fragmentsOf(const Preset& preset, std::size_t index, std::uint64_t seed, const SolidModel* instead) {
  const Layer& layer = preset.layers[index];
  const CutSeed cuts{seed, layerStream(layer)};
  const auto placed = [&](Error error) {
    for (Fault& fault : error.faults)
      if (fault.file.empty()) fault.pointer = "/layers/" + std::to_string(index) + "/pieces/model";
    return tl::unexpected<Error>(std::move(error));
  };
  if (instead != nullptr) return nearestFirst(cutToPieces(*instead, particleCount(layer), layer.pieces_density_kgpm3, cuts), layer.pieces_burst_m);
  auto model = findSolidModel(layer.pieces_model, preset.folder.path);
  if (!model) return placed(std::move(model.error()));
  auto cut = cutToPieces(placedModel(std::move(*model), layer.pieces_scale, layer.pieces_heading_rad), particleCount(layer), layer.pieces_density_kgpm3, cuts);
  if (!cut) return placed(std::move(cut.error()));
  return nearestFirst(std::move(cut), layer.pieces_burst_m);
}

double leastReach(const Piece& piece) {
  const std::vector<Face> faces = facesOf(piece);
  return faces.empty() ? 0.0 : std::ranges::min(faces, {}, &Face::distance_m).distance_m;
}

void launchPiece(const Layer& layer, const Piece& piece, Launch& out) {
  const Fling fling = flingOf(piece, {layer.pieces_impulse_Pas, layer.pieces_reach_m, layer.pieces_burst_m});
  out.place = piece.mass.centre_m + layer.region_offset_m;
  const double speed = length(fling.velocity_mps);
  // Without drag there is no air.
  out.velocity = layer.drag_ps > 0.0 && speed > 0.0 ? (speedLeft(piece, speed) / speed) * fling.velocity_mps : fling.velocity_mps;
  out.size_m = 2.0 * piece.radius_m;
  const double rate = length(fling.spin_radps);
  out.axis = rate > 0.0 ? (1.0 / rate) * fling.spin_radps : Vec3{0.0, 1.0, 0.0};
  out.phase_rad = 0.0;
  out.rate_radps = rate;
}

void settlePieces(const Ground& ground, CompiledLayer& layer) {
  for (std::size_t i = 0; i < layer.poses.size(); ++i) {
    const Chunk& chunk = layer.chunks[i / kChunkParticles];
    const std::size_t p = i % kChunkParticles;
    layer.poses[i].settled_rise_m = layer.poses[i].rise_m;
    if (chunk.rest_arc[p] == kNoRest || layer.constants.follow) continue;
    const Arc& rest = chunk.arcs[chunk.first_arc[p] + chunk.rest_arc[p]];
    const Vec3 up = ground.flat() ? Vec3{0.0, 1.0, 0.0} : ground.normal(static_cast<double>(rest.x), static_cast<double>(rest.z));
    settle(layer.fragments->pieces[i % layer.fragments->pieces.size()], chunk, p, up, layer.poses[i]);
  }
}

template <class Real>
void posePieces(const CompiledLayer& layer, double t, const FrameView<Real>& view) {
  for (std::size_t i = 0; i < layer.poses.size(); ++i) {
    const PiecePose& pose = layer.poses[i];
    const Chunk& chunk = layer.chunks[i / kChunkParticles];
    const std::size_t p = i % kChunkParticles;
    const double since = t - (chunk.birth_s.empty() ? layer.constants.start_s : chunk.birth_s[p]);
    const double age = std::clamp(since, 0.0, chunk.lifetime_s[p]), share = settledShare(pose, age);
    // From the exact height, so that a frame of floats is the rounded frame of doubles.
    const double y = stateOf(layer.constants, chunk, static_cast<int>(p), age).y;
    view.y[i] = static_cast<Real>(y + static_cast<double>(pose.rise_m) + share * (static_cast<double>(pose.settled_rise_m) - static_cast<double>(pose.rise_m)));
    if (view.vx && since < 0.0) view.vx[i] = view.vy[i] = view.vz[i] = Real(0);
    if (!view.qx || share <= 0.0) continue;
    const Quaternion lying{static_cast<double>(pose.settled[0]), static_cast<double>(pose.settled[1]), static_cast<double>(pose.settled[2]), static_cast<double>(pose.settled[3])};
    const Quaternion q = mixed(orientationAt(chunk, p, std::min(age, pose.settle_to_s)), lying, share);
    view.qx[i] = static_cast<Real>(q.x);
    view.qy[i] = static_cast<Real>(q.y);
    view.qz[i] = static_cast<Real>(q.z);
    view.qw[i] = static_cast<Real>(q.w);
  }
}

template void posePieces<float>(const CompiledLayer&, double, const FrameView<float>&);
template void posePieces<double>(const CompiledLayer&, double, const FrameView<double>&);

}  // namespace npsee::explosion

namespace npsee {

std::vector<Fault> modelFaults(const Preset& preset) {
  std::vector<Fault> out;
  for (std::size_t i = 0; i < preset.layers.size(); ++i) {
    if (preset.layers[i].form != Form::pieces) continue;
    auto cut = explosion::fragmentsOf(preset, i, static_cast<std::uint64_t>(preset.seed), nullptr);
    if (!cut) out.insert(out.end(), cut.error().faults.begin(), cut.error().faults.end());
  }
  return out;
}

}  // namespace npsee
