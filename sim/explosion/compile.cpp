#include "sim/explosion/compile.h"

#include "sim/core/parallel.h"
#include "sim/explosion/children.h"
#include "sim/explosion/emission.h"
#include "sim/explosion/shock_growth.h"
#include "sim/preset/stream.h"
#include "sim/preset/validate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>

namespace npsee::explosion {
namespace {

Flight flightOf(const Preset& preset, const Layer& layer) {
  Flight out;
  if (layer.trajectory == Trajectory::linear) return out;
  out.a = layer.buoyancy_mps2 - preset.gravity_mps2;
  // What flows along the ground lies on it.
  if (layer.follow_ground) out.a = std::max(out.a, 0.0);
  out.k = layer.drag_ps;
  if (out.k <= 0.0) return out;
  out.wx = preset.wind_mps.x;
  out.wy = layer.follow_ground ? 0.0 : preset.wind_mps.y;
  out.wz = preset.wind_mps.z;
  out.law = out.k < kWeakDrag_ps ? FlightLaw::series : FlightLaw::exponential;
  if (out.law == FlightLaw::exponential) {
    out.inverse_k = 1.0 / out.k;
    out.uy = out.wy + out.a / out.k;
  }
  return out;
}

/// A layer that collides is kept above the ground, which the eddies know only where it is flat.
Turbulence turbulenceOf(const CompileJob& job) {
  const Layer& layer = job.layer;
  if (layer.turbulence_m <= 0.0 || ((layer.collide || layer.follow_ground) && !job.ground.flat())) return {};
  return makeTurbulence(layer.turbulence_m, layer.turbulence_size_m, job.ground.height(0.0, 0.0), job.seed);
}

LayerConstants constantsOf(const CompileJob& job) {
  const Layer& layer = job.layer;
  LayerConstants c;
  c.flight = flightOf(job.preset, layer);
  if (job.parent == nullptr) c.origin_y = job.ground.height(0.0, 0.0) + (job.preset.burst == BurstKind::air ? job.preset.burst_height_m : 0.0);
  c.ground_y = job.ground.flat() ? job.ground.height(0.0, 0.0) : 0.0;
  c.turbulence = turbulenceOf(job);
  c.start_s = layer.start_s;
  c.follow = layer.follow_ground;
  c.collide = layer.collide && !layer.follow_ground;
  c.restitution = layer.restitution;
  c.friction = layer.friction;
  c.rest_speed_mps = layer.rest_speed_mps;
  c.bounce_limit = static_cast<int>(layer.bounce_limit);
  c.colour = layer.colour;
  c.colour_variation = layer.colour_variation;
  c.opacity = layer.opacity;
  c.colour_over_life = layer.colour_over_life;
  c.opacity_over_life = layer.opacity_over_life;
  c.size_over_life = layer.size_over_life;
  if (layer.form == Form::shock && c.size_over_life.empty()) c.size_over_life = shockGrowth();
  if (layer.form == Form::shock && c.opacity_over_life.empty()) c.opacity_over_life = shockFading();
  if (layer.form == Form::pieces) {
    c.stands = layer.pieces_stand && job.parent == nullptr;
    c.colour_variation = 0.0;
  }
  return c;
}

/// Bytes a particle of the layer is likely to need: its arcs with their start times, and what it draws.
std::size_t expectedBytes(const Layer& layer, bool flat) { return 60 + static_cast<std::size_t>(std::min(mostArcs(layer, flat), 7.0) * 36.0); }

/// Everything the chunks of one layer share while it is compiled.
struct LayerBuild {
  const CompileJob& job;
  const LayerConstants& constants;
  Emission emission;
  std::uint32_t stream;
  std::size_t per_event;               ///< particles per event
  std::vector<ParentEvent> events;     ///< empty for a layer of the burst itself
  std::vector<double> path_ages;       ///< of children along a path: the parent's age at which each starts
  bool own_births;                     ///< birth times differ between particles
  double centre_above;                 ///< height of the burst's centre above the ground
  std::vector<double> reaches;         ///< form pieces: leastReach of each
};

/// Launch of particle `number` of the layer, in the frame of the layer's origin, and its time of birth.
Launch launchOf(const LayerBuild& build, std::size_t number, double& birth) {
  const Layer& layer = build.job.layer;
  const std::size_t in_event = number % build.per_event;
  ParticleIdentity identity{build.job.seed, build.stream, static_cast<std::uint32_t>(in_event), 0, 0};
  const bool child = build.job.parent != nullptr;
  const ParentEvent event = child ? build.events[number / build.per_event] : ParentEvent{};
  identity.parent = event.parent;
  identity.event = event.event;

  Launch out = launch(build.emission, identity, build.centre_above);
  const double part = (static_cast<double>(in_event) + out.birth_part) / static_cast<double>(build.per_event);
  birth = layer.start_s + layer.duration_s * part;
  if (build.job.fragments) launchPiece(layer, build.job.fragments->pieces[in_event], out);
  if (!child) return out;

  const ChildStart start = childStart(*build.job.parent, event, layer.trigger, build.path_ages.empty() ? 0.0 : build.path_ages[number]);
  birth += start.time_s;
  out.place = out.place + Vec3{start.motion.x, start.motion.y, start.motion.z};
  out.velocity = out.velocity + layer.inherit_velocity * Vec3{start.motion.vx, start.motion.vy, start.motion.vz};
  return out;
}

/// Room a thread reuses from chunk to chunk.
struct Scratch {
  Launches launches;
  ArcRoom room;
  std::vector<Arc> arcs;
  std::vector<float> heights, starts;
};

std::unique_ptr<Scratch>& threadScratch() {
  thread_local std::unique_ptr<Scratch> scratch;
  return scratch;
}

void sizeChunk(Chunk& chunk, const LayerBuild& build) {
  const auto padded = static_cast<std::size_t>((chunk.count + 3) / 4 * 4);
  for (auto* floats : {&chunk.size_m, &chunk.axis_x, &chunk.axis_y, &chunk.axis_z, &chunk.phase_rad, &chunk.rate_radps}) floats->assign(padded, 0.0f);
  chunk.lifetime_s.assign(padded, 0.0);
  if (build.own_births) chunk.birth_s.assign(padded, 0.0);
  chunk.first_arc.assign(padded, 0);
  chunk.last_arc.assign(padded, 0);
  chunk.rest_arc.assign(padded, kNoRest);
  chunk.first_row.assign(padded / 4 + 1, 0);
}

/// Lets a piece fly as a point below its centre, see PiecePose; one that stands on the ground begins there.
void lower(const LayerBuild& build, std::size_t number, Launch& drawn, PiecePose& pose) {
  if (!build.constants.collide) return;
  const LayerConstants& c = build.constants;
  const double above = drawn.place.y + c.origin_y - build.job.ground.height(drawn.place.x + c.origin_x, drawn.place.z + c.origin_z);
  pose.rise_m = static_cast<float>(std::clamp(above, 0.0, build.reaches[number % build.per_event]));
  drawn.place.y -= static_cast<double>(pose.rise_m);
}

void drawChunk(const LayerBuild& build, std::size_t first_number, Chunk& chunk, Launches& launches, std::vector<PiecePose>& poses) {
  for (int i = 0; i < chunk.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    double birth = 0.0;
    Launch drawn = launchOf(build, first_number + at, birth);
    if (!poses.empty()) lower(build, first_number + at, drawn, poses[first_number + at]);
    // Launch place and velocity are what the first arc stores, so that frames at birth and flights from there agree to the last bit.
    launches.x[at] = static_cast<float>(drawn.place.x);
    launches.y[at] = static_cast<float>(drawn.place.y);
    launches.z[at] = static_cast<float>(drawn.place.z);
    launches.vx[at] = floatTowardsZero(drawn.velocity.x);
    launches.vy[at] = build.constants.follow ? std::fabs(drawn.velocity.y) : drawn.velocity.y;
    launches.vz[at] = floatTowardsZero(drawn.velocity.z);
    launches.lifetime_s[at] = chunk.lifetime_s[at] = drawn.lifetime_s;
    if (build.own_births) chunk.birth_s[at] = birth;
    chunk.size_m[at] = static_cast<float>(drawn.size_m);
    chunk.axis_x[at] = static_cast<float>(drawn.axis.x);
    chunk.axis_y[at] = static_cast<float>(drawn.axis.y);
    chunk.axis_z[at] = static_cast<float>(drawn.axis.z);
    chunk.phase_rad[at] = static_cast<float>(drawn.phase_rad);
    chunk.rate_radps[at] = static_cast<float>(drawn.rate_radps);
  }
  // Lanes beyond the last particle fly nowhere and live no time.
  const auto padded = static_cast<std::size_t>((chunk.count + lanes::kEight - 1) / lanes::kEight * lanes::kEight);
  for (auto at = static_cast<std::size_t>(chunk.count); at < padded; ++at)
    for (double* values : {launches.x, launches.y, launches.z, launches.vx, launches.vy, launches.vz, launches.lifetime_s}) values[at] = 0.0;
}

/// Pieces that start under the ground start on it, as seen from the layer's origin. What follows the ground starts as high over it as it
/// would over level ground.
void liftToGround(const LayerBuild& build, int count, Launches& launches) {
  const LayerConstants& c = build.constants;
  if (!c.collide && !c.follow) return;
  const Ground& surface = build.job.ground;
  const double level = surface.height(0.0, 0.0);
  const bool moved = c.follow && build.job.parent == nullptr && !surface.flat();
  for (int i = 0; i < count; ++i) {
    if (moved) launches.y[i] = static_cast<float>(launches.y[i] + surface.height(launches.x[i] + c.origin_x, launches.z[i] + c.origin_z) - level);
    const double ground = build.job.ground.height(launches.x[i] + c.origin_x, launches.z[i] + c.origin_z);
    if (launches.y[i] + c.origin_y < ground) launches.y[i] = static_cast<float>(ground - c.origin_y);
  }
}

void findArcsOfEight(const LayerBuild& build, const Launches& from, int first, ArcRoom& room) {
  if (build.job.ground.flat()) {
    build.job.kernels.find_arcs(build.constants, from, first, room);
    return;
  }
  const LayerConstants& c = build.constants;
  for (int lane = 0; lane < lanes::kEight; ++lane) {
    const int i = first + lane;
    room.last[lane] = 0;
    room.rests[lane] = false;
    room.arcs[lane][0] = {from.y[i], from.vy[i], static_cast<float>(from.x[i]), static_cast<float>(from.z[i]), static_cast<float>(from.vx[i]), static_cast<float>(from.vz[i])};
    room.heights[lane][0] = 0.0f;
    const Motion<double> motion{from.x[i] + c.origin_x, from.y[i] + c.origin_y, from.z[i] + c.origin_z, from.vx[i], from.vy[i], from.vz[i]};
    if (c.follow) findArcsAlongGround(c, build.job.ground, motion, from.lifetime_s[i], room, lane);
    else findArcsOnHeights(c, build.job.ground, motion, from.lifetime_s[i], room, lane);
  }
}

/// The next float at or below x >= 0.
float roundedDown(double x) {
  const auto rounded = static_cast<float>(x);
  return rounded > x ? std::bit_cast<float>(std::bit_cast<std::uint32_t>(rounded) - 1) : rounded;
}

/// Appends the start times by which the arcs of four particles are found.
void keepStarts(const ArcRoom& room, int first_lane, std::vector<float>& starts) {
  const int* last = room.last + first_lane;
  const int rows = *std::max_element(last, last + lanes::kLanes);
  const std::size_t before = starts.size();
  starts.resize(before + static_cast<std::size_t>(lanes::kLanes * rows), std::numeric_limits<float>::infinity());
  for (int lane = 0; lane < lanes::kLanes; ++lane) {
    float* to = starts.data() + before + lane;
    for (int number = 1; number <= last[lane]; ++number, to += lanes::kLanes) *to = roundedDown(room.arcs[first_lane + lane][number].start_s);
  }
}

/// Keeps the arcs of the four particles whose lanes begin at `first_lane`.
void keepArcs(const ArcRoom& room, int first_lane, int four, bool own_heights, Chunk& chunk, Scratch& scratch) {
  const int* last = room.last + first_lane;
  keepStarts(room, first_lane, scratch.starts);
  chunk.first_row[static_cast<std::size_t>(four) + 1] = static_cast<std::uint32_t>(scratch.starts.size() / 4);
  for (int lane = 0; lane < lanes::kLanes; ++lane) {
    const auto particle = static_cast<std::size_t>(4 * four + lane);
    const Arc* arcs = room.arcs[first_lane + lane];
    chunk.first_arc[particle] = static_cast<std::uint32_t>(scratch.arcs.size());
    chunk.last_arc[particle] = static_cast<std::uint8_t>(last[lane]);
    chunk.rest_arc[particle] = room.rests[first_lane + lane] ? static_cast<std::uint8_t>(last[lane]) : kNoRest;
    scratch.arcs.insert(scratch.arcs.end(), arcs, arcs + last[lane] + 1);
    if (own_heights) scratch.heights.insert(scratch.heights.end(), room.heights[first_lane + lane], room.heights[first_lane + lane] + last[lane] + 1);
  }
}

void compileChunk(const LayerBuild& build, std::size_t first_number, Chunk& chunk, std::vector<PiecePose>& poses) {
  auto& kept = threadScratch();
  if (!kept) kept = std::make_unique<Scratch>();
  Scratch& scratch = *kept;
  const bool own_heights = !build.job.ground.flat();
  scratch.arcs.clear();
  scratch.heights.clear();
  scratch.starts.clear();
  sizeChunk(chunk, build);
  drawChunk(build, first_number, chunk, scratch.launches, poses);
  liftToGround(build, chunk.count, scratch.launches);
  const int fours = static_cast<int>(chunk.lifetime_s.size() / 4);
  for (int four = 0; four < fours; four += 2) {
    findArcsOfEight(build, scratch.launches, 4 * four, scratch.room);
    keepArcs(scratch.room, 0, four, own_heights, chunk, scratch);
    if (four + 1 < fours) keepArcs(scratch.room, lanes::kLanes, four + 1, own_heights, chunk, scratch);
  }
  chunk.arcs.assign(scratch.arcs.begin(), scratch.arcs.end());
  chunk.heights.assign(scratch.heights.begin(), scratch.heights.end());
  chunk.starts.assign(scratch.starts.begin(), scratch.starts.end());
}

}  // namespace

void releaseCompileScratch() { threadScratch().reset(); }

Motion<double> stateOf(const LayerConstants& c, const Chunk& chunk, int particle, double age_s) {
  const auto p = static_cast<std::size_t>(particle);
  const double age = std::clamp(age_s, 0.0, chunk.lifetime_s[p]);
  const Arc* first = chunk.arcs.data() + chunk.first_arc[p];
  int number = chunk.last_arc[p];
  while (number > 0 && first[number].start_s > age) --number;
  const Arc& arc = first[number];
  const bool origin = number == 0;
  const double later_y = chunk.heights.empty() ? c.ground_y : static_cast<double>(chunk.heights[chunk.first_arc[p] + static_cast<std::size_t>(number)]);
  const Motion<double> m{static_cast<double>(arc.x) + (origin ? c.origin_x : 0.0), origin ? arc.start_s + c.origin_y : later_y, static_cast<double>(arc.z) + (origin ? c.origin_z : 0.0),
                         static_cast<double>(arc.vx), arc.vy, static_cast<double>(arc.vz)};
  const double tau = number == chunk.rest_arc[p] ? 0.0 : age - (origin ? 0.0 : arc.start_s);
  Motion<double> out = flownBy(c.flight, m, tau);
  if (c.turbulence.amplitude_m > 0.0) {
    const bool still = number == chunk.rest_arc[p];
    const double pace = 1.0 / (chunk.lifetime_s[p] > 0.0 ? chunk.lifetime_s[p] : 1.0);
    stir<double>(c.turbulence, (still ? arc.start_s : age) * pace, still ? 0.0 : pace, out);
  }
  return out;
}

CompiledLayer compileLayer(const CompileJob& job) {
  CompiledLayer out;
  out.constants = constantsOf(job);
  out.name = job.layer.name;
  out.form = job.layer.form;
  out.first = job.first;

  const bool child = job.parent != nullptr;
  LayerBuild build{job, out.constants, Emission(job.preset, job.layer, child), layerStream(job.layer), static_cast<std::size_t>(particleCount(job.layer)), {}, {},
                   child || job.layer.duration_s > 0.0, out.constants.origin_y - job.ground.height(0.0, 0.0), {}};
  if (job.fragments) {
    out.fragments = job.fragments;
    for (const Piece& piece : job.fragments->pieces) build.reaches.push_back(leastReach(piece));
  }
  if (child) build.events = parentEvents(*job.parent, job.layer.trigger);
  out.count = build.per_event * (child ? build.events.size() : 1);
  if (child && job.layer.trigger == Trigger::path) build.path_ages = pathAges(*job.parent, build.events, build.per_event, job.layer.path_spacing, job.threads);
  if (job.fragments) out.poses.resize(out.count);
  out.memory = std::make_unique<Arena>(out.count * expectedBytes(job.layer, job.ground.flat()));
  out.chunks.reserve((out.count + kChunkParticles - 1) / kChunkParticles);
  // One by one: copies of a chunk would leave the arena.
  for (std::size_t first = 0; first < out.count; first += kChunkParticles) out.chunks.emplace_back(out.memory.get());
  parallelFor(job.threads, out.chunks.size(), [&](std::size_t i) {
    Chunk& chunk = out.chunks[i];
    chunk.first = out.first + i * kChunkParticles;
    chunk.count = static_cast<int>(std::min<std::size_t>(kChunkParticles, out.count - i * kChunkParticles));
    compileChunk(build, i * kChunkParticles, chunk, out.poses);
  });
  if (job.fragments) settlePieces(job.ground, out);
  return out;
}

}  // namespace npsee::explosion
