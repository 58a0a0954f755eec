// The C interface to presets and explosions.

#include "sim/c/guard.h"
#include "sim/explosion/compile.h"

#include <npsee/explosion.h>
#include <npsee/parameters.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace npsee;

struct npsee_preset {
  Preset value;
};
struct npsee_explosion {
  std::shared_ptr<const Explosion> value;
};

namespace {

/// A caller's function as the surface to fall on.
class CallersGround final : public Ground {
 public:
  explicit CallersGround(const npsee_compile_options& options) : height_(options.ground), user_(options.ground_user), detail_m_(options.ground_detail_m) {}
  double height(double x_m, double z_m) const override {
    const double height_m = height_(user_, x_m, z_m);
    return std::fabs(height_m) <= kMaxGround_m ? height_m : 0.0;
  }
  double detail() const override { return detail_m_; }

 private:
  npsee_height_function height_;
  void* user_;
  double detail_m_;
};

/// Room between two calls, one per thread and precision.
template <class Real>
std::unique_ptr<BasicFrame<Real>>& scratch() {
  thread_local std::unique_ptr<BasicFrame<Real>> frame;
  return frame;
}

template <class Frame>
unsigned fieldsOf(const Frame& f) {
  unsigned fields = kPosition;
  if (f.vx || f.vy || f.vz) fields |= kVelocity;
  if (f.r || f.g || f.b || f.a) fields |= kLook;
  if (f.qx || f.qy || f.qz || f.qw) fields |= kOrientation;
  if (f.bounces) fields |= kBounces;
  if (f.age) fields |= kAge;
  return fields;
}

template <class Real, class Frame>
void copyOut(const BasicFrame<Real>& from, const Frame& to) {
  const auto copy = [&](const auto& values, auto* into) {
    if (into != nullptr && from.count > 0) std::copy_n(values.data(), from.count, into);
  };
  copy(from.x, to.x);
  copy(from.y, to.y);
  copy(from.z, to.z);
  copy(from.vx, to.vx);
  copy(from.vy, to.vy);
  copy(from.vz, to.vz);
  copy(from.size, to.size);
  copy(from.age, to.age);
  copy(from.r, to.r);
  copy(from.g, to.g);
  copy(from.b, to.b);
  copy(from.a, to.a);
  copy(from.qx, to.qx);
  copy(from.qy, to.qy);
  copy(from.qz, to.qz);
  copy(from.qw, to.qw);
  copy(from.alive, to.alive);
  copy(from.bounces, to.bounces);
}

template <class Real, class Frame>
npsee_status evaluate(const char* function, const npsee_explosion& explosion, double t_s, const Frame& frame, int threads) {
  return c::guarded(function, [&] {
    if (!std::isfinite(t_s)) return c::refuse(NPSEE_USAGE, "the time is no finite number of seconds.");
    if (threads < 1) return c::refuse(NPSEE_USAGE, "at least one thread is needed.");
    const std::size_t count = explosion.value->particleCount();
    if (frame.capacity < count) return c::refuse(NPSEE_USAGE, "the arrays have room for " + std::to_string(frame.capacity) + " particles, and there are " + std::to_string(count) + ".");
    auto& room = scratch<Real>();
    if (!room) room = std::make_unique<BasicFrame<Real>>();
    explosion.value->at(t_s, *room, fieldsOf(frame), threads);
    copyOut(*room, frame);
    return NPSEE_OK;
  });
}

/// The library's limits, or the caller's where he sets lower ones.
CompileOptions limitsOf(const npsee_compile_options& options) {
  CompileOptions out;
  out.threads = options.threads;
  if (options.max_particles > 0) out.max_particles = static_cast<double>(options.max_particles);
  if (options.max_bytes > 0) out.max_bytes = static_cast<double>(options.max_bytes);
  return out;
}

}  // namespace

extern "C" {

npsee_status npsee_preset_load(const char* path, npsee_preset** preset) {
  NPSEE_MAKES(preset);
  NPSEE_NEEDS(path);
  return c::guarded(__func__, [&] { return c::handOver(loadPreset(path), preset); });
}

npsee_status npsee_preset_parse(const char* text, size_t length, const char* name, const char* folder, npsee_preset** preset) {
  NPSEE_MAKES(preset);
  NPSEE_NEEDS(text);
  return c::guarded(__func__, [&] { return c::handOver(parsePreset({text, length}, c::orEmpty(name), c::orEmpty(folder)), preset); });
}

npsee_status npsee_preset_set(npsee_preset* preset, const char* setting) {
  NPSEE_NEEDS(preset);
  NPSEE_NEEDS(setting);
  return c::guarded(__func__, [&] { return c::settle(applySetting(preset->value, setting)); });
}

npsee_status npsee_preset_text(const npsee_preset* preset, char* buffer, size_t capacity, size_t* length) {
  NPSEE_NEEDS(preset);
  return c::guarded(__func__, [&] { return c::copyText(presetText(preset->value), buffer, capacity, length); });
}

npsee_status npsee_preset_save(const npsee_preset* preset, const char* path) {
  NPSEE_NEEDS(preset);
  NPSEE_NEEDS(path);
  return c::guarded(__func__, [&] { return c::settle(savePreset(preset->value, path)); });
}

void npsee_preset_free(npsee_preset* preset) { delete preset; }

npsee_compile_options npsee_compile_options_default(void) {
  npsee_compile_options out{};
  out.threads = 1;
  out.ground_detail_m = 1.0;
  return out;
}

npsee_status npsee_explosion_compile(const npsee_preset* preset, const npsee_compile_options* options, npsee_explosion** explosion) {
  NPSEE_MAKES(explosion);
  NPSEE_NEEDS(preset);
  return c::guarded(__func__, [&] {
    const npsee_compile_options chosen = options != nullptr ? *options : npsee_compile_options_default();
    if (chosen.threads < 1) return c::refuse(NPSEE_USAGE, "at least one thread is needed.");
    if (chosen.ground != nullptr && !(std::isfinite(chosen.ground_detail_m) && chosen.ground_detail_m > 0.0)) return c::refuse(NPSEE_USAGE, "ground_detail_m is not above 0.");
    const CallersGround ground(chosen);
    const auto seed = chosen.has_seed != 0 ? std::optional<std::uint64_t>(chosen.seed) : std::nullopt;
    return c::handOver(Explosion::compile(preset->value, seed, chosen.ground != nullptr ? &ground : nullptr, limitsOf(chosen)), explosion);
  });
}

size_t npsee_explosion_particles(const npsee_explosion* explosion) { return explosion != nullptr ? explosion->value->particleCount() : 0; }
double npsee_explosion_duration_s(const npsee_explosion* explosion) { return explosion != nullptr ? explosion->value->duration_s() : 0.0; }
size_t npsee_explosion_memory_bytes(const npsee_explosion* explosion) { return explosion != nullptr ? explosion->value->memoryBytes() : 0; }
size_t npsee_explosion_layers(const npsee_explosion* explosion) { return explosion != nullptr ? explosion->value->layers().size() : 0; }

npsee_status npsee_explosion_layer(const npsee_explosion* explosion, size_t index, npsee_layer* layer) {
  NPSEE_NEEDS(explosion);
  NPSEE_NEEDS(layer);
  return c::guarded(__func__, [&] {
    const auto& layers = explosion->value->layers();
    if (index >= layers.size()) return c::refuse(NPSEE_USAGE, "there are " + std::to_string(layers.size()) + " layers, counted from 0.");
    const LayerSpan& span = layers[index];
    *layer = {span.name.c_str(), findParameter(Scope::layer, "form")->choices[static_cast<std::size_t>(span.form)].data(), span.first, span.count};
    return NPSEE_OK;
  });
}

npsee_status npsee_explosion_extent(const npsee_explosion* explosion, double min_m[3], double max_m[3]) {
  NPSEE_NEEDS(explosion);
  NPSEE_NEEDS(min_m);
  NPSEE_NEEDS(max_m);
  return c::guarded(__func__, [&] {
    const Extent& extent = explosion->value->extent();
    c::put(extent.min, min_m);
    c::put(extent.max, max_m);
    return NPSEE_OK;
  });
}

double npsee_explosion_reach_m(const npsee_explosion* explosion) { return explosion != nullptr ? explosion->value->extent().reach_m : 0.0; }

npsee_status npsee_explosion_at(const npsee_explosion* explosion, double t_s, const npsee_frame* frame, int threads) {
  NPSEE_NEEDS(explosion);
  NPSEE_NEEDS(frame);
  return evaluate<double>(__func__, *explosion, t_s, *frame, threads);
}

npsee_status npsee_explosion_at_float(const npsee_explosion* explosion, double t_s, const npsee_float_frame* frame, int threads) {
  NPSEE_NEEDS(explosion);
  NPSEE_NEEDS(frame);
  return evaluate<float>(__func__, *explosion, t_s, *frame, threads);
}

void npsee_release_scratch(void) {
  scratch<double>().reset();
  scratch<float>().reset();
  explosion::releaseCompileScratch();
}

void npsee_explosion_free(npsee_explosion* explosion) { delete explosion; }

}
