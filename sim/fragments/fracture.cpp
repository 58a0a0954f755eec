#include "sim/core/random.h"
#include "sim/fragments/cut.h"
#include "sim/fragments/shells.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>
#include <queue>

namespace npsee {
namespace {

using fragments::Halves;
using fragments::Plane;

/// Triangles of all pieces together at most, against models that every cut makes larger.
constexpr std::size_t kMostFacets = 600'000;
/// A cut should leave at least this share of the volume on either side; the best of some tries is taken.
constexpr double kFairShare = 0.12;
/// Below this share of the whole a part is rounding: it stays with its neighbour.
constexpr double kDust = 1e-10;
constexpr int kTries = 6;

struct Part {
  Solid solid;
  MassProperties mass;  ///< at density 1
};

Part partOf(Solid solid) {
  MassProperties mass = massOf(solid, 1.0);
  return {std::move(solid), mass};
}

void append(Solid& to, const Solid& from) {
  const auto base = static_cast<std::uint32_t>(to.points.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (Facet facet : from.facets) {
    for (std::uint32_t& corner : facet.corners) corner += base;
    to.facets.push_back(facet);
  }
}

struct Box {
  Vec3 low, high;
};

Box boxOf(const Solid& solid) {
  Box out{solid.points.front(), solid.points.front()};
  for (const Vec3& p : solid.points) {
    out.low = {std::min(out.low.x, p.x), std::min(out.low.y, p.y), std::min(out.low.z, p.z)};
    out.high = {std::max(out.high.x, p.x), std::max(out.high.y, p.y), std::max(out.high.z, p.z)};
  }
  return out;
}

/// Uniform numbers in -1..1 for one try of one cut. No other draw has this event number.
std::array<double, 4> drawsOf(const CutSeed& seed, std::uint32_t cut, int attempt) {
  std::array<double, 4> out = uniformBlock({seed.seed, seed.stream, cut, 0, 0xffffffffu}, static_cast<std::uint32_t>(attempt));
  for (double& value : out) value = 2.0 * value - 1.0;
  return out;
}

/// A plane across the longest side of the box around a part, near its centre of mass, tilted and moved by chance, less so with every try;
/// the last try is straight through the centre.
Plane planeFor(const Part& part, const CutSeed& seed, std::uint32_t cut, int attempt) {
  const Box box = boxOf(part.solid);
  const Vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const double longest = axis == 0 ? size.x : axis == 1 ? size.y : size.z;
  const auto draws = drawsOf(seed, cut, attempt);
  const double chance = attempt + 1 < kTries ? 1.0 / (1.0 + attempt) : 0.0;
  const double tilt = 0.75 * chance;
  Vec3 normal{(axis == 0 ? 1.0 : 0.0) + tilt * draws[0], (axis == 1 ? 1.0 : 0.0) + tilt * draws[1], (axis == 2 ? 1.0 : 0.0) + tilt * draws[2]};
  normal = (1.0 / length(normal)) * normal;
  return {normal, dot(normal, part.mass.centre_m) + 0.16 * chance * longest * draws[3]};
}

/// The joined parts of one half. Parts that enclose (almost) nothing go with the largest one, so that no volume is lost.
void addParts(const Solid& half, double whole, std::vector<Part>& out) {
  if (half.facets.empty()) return;
  std::vector<Part> found;
  for (Solid& solid : fragments::joinedParts(half)) found.push_back(partOf(std::move(solid)));
  std::size_t largest = 0;
  for (std::size_t i = 1; i < found.size(); ++i)
    if (found[i].mass.volume_m3 > found[largest].mass.volume_m3) largest = i;
  bool joined = false;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (i != largest && !(found[i].mass.volume_m3 > kDust * whole)) {
      append(found[largest].solid, found[i].solid);
      found[i].solid.facets.clear();
      joined = true;
    }
  if (joined) found[largest].mass = massOf(found[largest].solid, 1.0);
  for (Part& part : found)
    if (!part.solid.facets.empty()) out.push_back(std::move(part));
}

/// Cuts a part in two or more; empty if no plane parts it.
std::vector<Part> halved(const Part& part, const CutSeed& seed, std::uint32_t cut, double whole) {
  const Box box = boxOf(part.solid);
  const double snap_m = 1e-7 * length(box.high - box.low);
  std::vector<Part> best;
  double best_share = kDust;
  for (int attempt = 0; attempt < kTries && best_share < kFairShare; ++attempt) {
    const Halves halves = fragments::cutBy(part.solid, planeFor(part, seed, cut, attempt), snap_m);
    if (halves.below.facets.empty() || halves.above.facets.empty()) continue;
    const double below = massOf(halves.below, 1.0).volume_m3, above = massOf(halves.above, 1.0).volume_m3;
    const double share = std::min(below, above) / part.mass.volume_m3;
    if (!(share > best_share)) continue;
    best_share = share;
    best.clear();
    addParts(halves.below, whole, best);
    addParts(halves.above, whole, best);
  }
  return best;
}

/// Joins the smallest part with the one nearest to it.
void joinSmallest(std::vector<Part>& parts) {
  std::size_t smallest = 0;
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (parts[i].mass.volume_m3 < parts[smallest].mass.volume_m3) smallest = i;
  std::size_t nearest = smallest;
  double best = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double distance = length(parts[i].mass.centre_m - parts[smallest].mass.centre_m);
    if (i != smallest && (nearest == smallest || distance < best)) nearest = i, best = distance;
  }
  append(parts[nearest].solid, parts[smallest].solid);
  parts[nearest].mass = massOf(parts[nearest].solid, 1.0);
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(smallest));
}

struct Waiting {
  double weight;
  std::size_t part;
  bool operator<(const Waiting& other) const { return weight != other.weight ? weight < other.weight : part > other.part; }
};

/// Cuts what is largest, give or take a factor, until there are enough parts.
void cutUp(std::vector<Part>& parts, std::size_t wanted, const CutSeed& seed) {
  double whole = 0.0;
  std::size_t facets = 0;
  for (const Part& part : parts) whole += part.mass.volume_m3, facets += part.solid.facets.size();
  std::priority_queue<Waiting> queue;
  std::uint32_t drawn = 0;
  // Large and small pieces side by side: how long a part waits varies by chance.
  const auto wait = [&](std::size_t part) { queue.push({parts[part].mass.volume_m3 * (1.0 + 0.6 * drawsOf(seed, drawn++, kTries)[0]), part}); };
  for (std::size_t i = 0; i < parts.size(); ++i) wait(i);
  for (std::uint32_t cut = 0; parts.size() < wanted && !queue.empty() && facets < kMostFacets; ++cut) {
    const std::size_t chosen = queue.top().part;
    queue.pop();
    std::vector<Part> made = halved(parts[chosen], seed, cut, whole);
    if (made.size() < 2) continue;
    facets -= parts[chosen].solid.facets.size();
    for (const Part& part : made) facets += part.solid.facets.size();
    parts[chosen] = std::move(made.front());
    wait(chosen);
    for (std::size_t i = 1; i < made.size(); ++i) {
      parts.push_back(std::move(made[i]));
      wait(parts.size() - 1);
    }
  }
}

Piece pieceOf(Part part, double density) {
  Piece out;
  out.mass = massOf(part.solid, density);
  out.solid = std::move(part.solid);
  for (Vec3& point : out.solid.points) {
    point = point - out.mass.centre_m;
    out.radius_m = std::max(out.radius_m, length(point));
  }
  return out;
}

}  // namespace

std::size_t Fragments::bytes() const {
  std::size_t out = sizeof *this;
  for (const Piece& piece : pieces) out += sizeof piece + piece.solid.points.capacity() * sizeof(Vec3) + piece.solid.facets.capacity() * sizeof(Facet);
  return out;
}

Expected<std::shared_ptr<const Fragments>> cutToPieces(const SolidModel& model, std::int64_t count, double density_kgpm3, const CutSeed& seed) {
  if (count < 1 || count > kMaxPieces)
    return fail(ErrorKind::input, "a model cannot be cut into " + std::to_string(count) + " pieces.", "Choose a count from 1 to " + std::to_string(kMaxPieces) + ".");
  const auto wanted = static_cast<std::size_t>(count);
  std::vector<Part> parts;
  for (const Solid& shell : model.shells) parts.push_back(partOf(shell));
  cutUp(parts, wanted, seed);
  while (parts.size() > wanted) joinSmallest(parts);
  if (parts.size() < wanted)
    return fail(ErrorKind::input, "the model " + printable(model.name) + " can be cut into " + std::to_string(parts.size()) + " pieces only, not into " + std::to_string(wanted) + ".", "Lower the count, or simplify the model.");
  auto out = std::make_shared<Fragments>();
  out->materials = model.materials;
  out->pieces.reserve(parts.size());
  for (Part& part : parts) out->pieces.push_back(pieceOf(std::move(part), density_kgpm3));
  return std::shared_ptr<const Fragments>(std::move(out));
}

}  // namespace npsee
