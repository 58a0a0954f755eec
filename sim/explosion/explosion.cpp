#include <npsee/explosion.h>

#include "sim/core/parallel.h"
#include "sim/explosion/compile.h"
#include "sim/explosion/extent.h"
#include "sim/preset/validate.h"

#include <npsee/units.h>

#include <algorithm>
#include <mutex>

namespace npsee {

using explosion::Chunk;
using explosion::CompiledLayer;
using explosion::FrameView;
using explosion::Kernels;

struct Explosion::Impl {
  std::vector<CompiledLayer> layers;
  std::vector<LayerSpan> spans;
  std::size_t particles = 0;
  double duration_s = 0.0;
  const Kernels* kernels = nullptr;
  Vec3 burst;
  double ground_y = 0.0;
  mutable std::once_flag extent_once;
  mutable Extent extent;

  template <class Real>
  void at(double t_s, BasicFrame<Real>& out, unsigned fields, int threads) const;
};

namespace {

template <class Real>
void resizeFrame(BasicFrame<Real>& frame, std::size_t count, unsigned fields) {
  const auto grow = [count](auto& values) {
    if (values.size() < count) values.resize(count);
  };
  for (auto* values : {&frame.x, &frame.y, &frame.z, &frame.size}) grow(*values);
  if (fields & kVelocity)
    for (auto* values : {&frame.vx, &frame.vy, &frame.vz}) grow(*values);
  if (fields & kLook)
    for (auto* values : {&frame.r, &frame.g, &frame.b, &frame.a}) grow(*values);
  if (fields & kOrientation)
    for (auto* values : {&frame.qx, &frame.qy, &frame.qz, &frame.qw}) grow(*values);
  if (fields & kAge) grow(frame.age);
  grow(frame.alive);
  if (fields & kBounces) grow(frame.bounces);
  frame.count = count;
}

/// Pointers to the chunk's part of the frame; null where a field is not wanted.
template <class Real>
FrameView<Real> viewOf(BasicFrame<Real>& frame, std::size_t first, unsigned fields) {
  const auto at = [first](std::vector<Real>& values, bool wanted) { return wanted ? values.data() + first : nullptr; };
  const bool velocity = fields & kVelocity, look = fields & kLook, turn = fields & kOrientation;
  return {at(frame.x, true), at(frame.y, true), at(frame.z, true), at(frame.vx, velocity), at(frame.vy, velocity), at(frame.vz, velocity), at(frame.size, true),
          at(frame.age, fields & kAge), at(frame.r, look), at(frame.g, look), at(frame.b, look), at(frame.a, look), at(frame.qx, turn), at(frame.qy, turn), at(frame.qz, turn),
          at(frame.qw, turn), frame.alive.data() + first, fields & kBounces ? frame.bounces.data() + first : nullptr};
}

void evaluateBy(const Kernels& kernels, const CompiledLayer& layer, const Chunk& chunk, double t, const FrameView<float>& view) { kernels.evaluate(layer.constants, chunk, t, view); }
void evaluateBy(const Kernels& kernels, const CompiledLayer& layer, const Chunk& chunk, double t, const FrameView<double>& view) {
  kernels.evaluate_exact(layer.constants, chunk, t, view);
}

bool runs(const Preset& preset, const Layer& layer) {
  const Layer* at = &layer;
  for (std::size_t hop = 0; hop <= preset.layers.size(); ++hop) {
    if (!at->enabled) return false;
    const int parent = findLayer(preset, at->parent);
    if (parent < 0) return true;
    at = &preset.layers[static_cast<std::size_t>(parent)];
  }
  return false;
}

/// Layer numbers with every parent before its children, otherwise in the preset's order.
std::vector<std::size_t> parentsFirst(const Preset& preset) {
  std::vector<std::size_t> order;
  std::vector<bool> placed(preset.layers.size(), false);
  while (order.size() < preset.layers.size()) {
    for (std::size_t i = 0; i < preset.layers.size(); ++i) {
      const int parent = findLayer(preset, preset.layers[i].parent);
      if (placed[i] || (parent >= 0 && !placed[static_cast<std::size_t>(parent)])) continue;
      placed[i] = true;
      order.push_back(i);
    }
  }
  return order;
}

double lastDeath(const CompiledLayer& layer) {
  double last = 0.0;
  for (const Chunk& chunk : layer.chunks)
    for (int i = 0; i < chunk.count; ++i) {
      const auto p = static_cast<std::size_t>(i);
      last = std::max(last, (chunk.birth_s.empty() ? layer.constants.start_s : chunk.birth_s[p]) + chunk.lifetime_s[p]);
    }
  return last;
}

}  // namespace

template <class Real>
void Explosion::Impl::at(double t_s, BasicFrame<Real>& out, unsigned fields, int threads) const {
  resizeFrame(out, particles, fields);
  out.time_s = t_s;
  for (const CompiledLayer& layer : layers)
    parallelFor(threads, layer.chunks.size(), [&](std::size_t i) {
      const Chunk& chunk = layer.chunks[i];
      evaluateBy(*kernels, layer, chunk, t_s, viewOf(out, chunk.first, fields));
    });
  for (const CompiledLayer& layer : layers)
    if (!layer.poses.empty()) explosion::posePieces(layer, t_s, viewOf(out, layer.first, fields));
}

Explosion::Explosion(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Explosion::~Explosion() = default;

Expected<std::shared_ptr<const Explosion>> Explosion::compile(const Preset& preset, std::optional<std::uint64_t> seed, const Ground* ground, const CompileOptions& options) {
  if (std::vector<Fault> faults = validate(preset); !faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  if (const double most = particleBudget(preset); most > options.max_particles)
    return fail(ErrorKind::input, "the layers start " + shortest(most) + " particles, above the caller's limit of " + shortest(options.max_particles) + ".", "Lower a density or count.");
  const FlatGround flat(preset.ground_height_m);
  const Ground& surface = ground != nullptr ? *ground : flat;
  // What validate() allows is for flat ground; uneven ground may take more.
  const double most_bytes = std::min(options.max_bytes, kMaxMemory);
  if (const double most = memoryBudget(preset, surface.flat()); most > most_bytes)
    return fail(ErrorKind::input, "the layers may take " + shortest(most) + " bytes with all their bounces" + (surface.flat() ? "" : " over this ground") + ", above the " + (most_bytes < options.max_bytes ? "" : "caller's ") + "limit of " + shortest(most_bytes) + ".",
                "Lower a bounce_limit, density or count.");

  auto impl = std::make_unique<Impl>();
  impl->kernels = options.force_baseline ? &explosion::baselineKernels() : &explosion::bestKernels();
  impl->ground_y = surface.height(0.0, 0.0);
  impl->burst = {0.0, surface.height(0.0, 0.0) + (preset.burst == BurstKind::air ? preset.burst_height_m : 0.0), 0.0};

  // Children need their parents' arcs; frames keep the preset's order.
  std::vector<CompiledLayer> compiled(preset.layers.size());
  for (const std::size_t i : parentsFirst(preset)) {
    const Layer& layer = preset.layers[i];
    if (!runs(preset, layer)) continue;
    const int parent = findLayer(preset, layer.parent);
    const std::uint64_t own_seed = seed.value_or(static_cast<std::uint64_t>(preset.seed));
    std::shared_ptr<const Fragments> fragments;
    if (layer.form == Form::pieces) {
      auto cut = explosion::fragmentsOf(preset, i, own_seed, options.model.get());
      if (!cut) return tl::unexpected<Error>(std::move(cut.error()));
      fragments = std::move(*cut);
    }
    compiled[i] = explosion::compileLayer({preset, layer, own_seed, surface, parent >= 0 ? &compiled[static_cast<std::size_t>(parent)] : nullptr, *impl->kernels, std::max(1, options.threads), 0,
                                           std::move(fragments)});
  }
  for (std::size_t i = 0; i < compiled.size(); ++i) {
    if (!runs(preset, preset.layers[i])) continue;
    CompiledLayer& layer = compiled[i];
    layer.first = impl->particles;
    for (Chunk& chunk : layer.chunks) chunk.first += layer.first;
    impl->particles += layer.count;
    impl->duration_s = std::max(impl->duration_s, lastDeath(layer));
    impl->spans.push_back({layer.name, layer.first, layer.count, layer.form, layer.fragments, preset.layers[i].temperature_k, preset.layers[i].cooling_s});
    impl->layers.push_back(std::move(layer));
  }
  return std::shared_ptr<const Explosion>(new Explosion(std::move(impl)));
}

std::size_t Explosion::particleCount() const { return impl_->particles; }
const std::vector<LayerSpan>& Explosion::layers() const { return impl_->spans; }
double Explosion::duration_s() const { return impl_->duration_s; }

std::size_t Explosion::memoryBytes() const {
  std::size_t bytes = sizeof(Impl);
  for (const CompiledLayer& layer : impl_->layers) bytes += layer.memory->bytes() + layer.chunks.capacity() * sizeof(Chunk) + layer.poses.capacity() * sizeof(explosion::PiecePose) + (layer.fragments ? layer.fragments->bytes() : 0);
  return bytes;
}

void Explosion::at(double t_s, Frame& out, unsigned fields, int threads) const { impl_->at(t_s, out, fields, threads); }
void Explosion::at(double t_s, ExactFrame& out, unsigned fields, int threads) const { impl_->at(t_s, out, fields, threads); }

const Extent& Explosion::extent() const {
  std::call_once(impl_->extent_once, [this] { impl_->extent = explosion::extentOf(impl_->layers, impl_->burst, impl_->ground_y); });
  return impl_->extent;
}

}  // namespace npsee
