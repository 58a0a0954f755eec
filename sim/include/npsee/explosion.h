#pragma once

#include <npsee/fragments.h>
#include <npsee/ground.h>
#include <npsee/preset.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace npsee {

/// Which quantities `Explosion::at` fills; position, size and alive are always filled.
enum FrameFields : unsigned {
  kPosition = 0,
  kVelocity = 1u << 0,
  kLook = 1u << 1,         ///< r, g, b, a
  kOrientation = 1u << 2,  ///< qx, qy, qz, qw
  kBounces = 1u << 3,
  kAge = 1u << 4,
  kAllFields = (1u << 5) - 1,
};

/// State of all particles at one time, structure of arrays, one entry per particle in layer order. `Real` is float for
/// drawing (each value the rounded double) and double for exact output.
template <class Real>
struct BasicFrame {
  std::vector<Real> x, y, z;         ///< m
  std::vector<Real> vx, vy, vz;      ///< m/s
  std::vector<Real> size;            ///< m, 0 for particles not alive
  std::vector<Real> age;             ///< s since birth, clamped to 0..lifetime
  std::vector<Real> r, g, b, a;      ///< sRGB-coded colour and opacity, 0..1; a is 0 for particles not alive
  std::vector<Real> qx, qy, qz, qw;  ///< unit quaternion, body to world
  std::vector<std::uint8_t> alive;   ///< 1 between birth and death; pieces that stand are there from time 0
  std::vector<std::uint8_t> bounces; ///< ground contacts so far
  std::size_t count = 0;             ///< particles; arrays may be longer (padding)
  double time_s = 0.0;
};
using Frame = BasicFrame<float>;
using ExactFrame = BasicFrame<double>;

/// A compiled layer's place in the frames.
struct LayerSpan {
  std::string name;
  std::size_t first = 0, count = 0;
  Form form{};
  /// Form pieces: the model in pieces. Particle i of the layer is piece i modulo their number; its size is the piece's diameter.
  std::shared_ptr<const Fragments> pieces = nullptr;
  double temperature_k = 0.0;  ///< at birth; 0 does not glow
  double cooling_s = 1.0;      ///< time to fall to 63 % of it
};

/// Box that holds what is drawn over the whole effect, all but strays, with its sizes; for cameras.
struct Extent {
  Vec3 min, max;
  double reach_m = 0.0;  ///< farthest that anything is drawn from the box's centre, strays included; of at most 300 particles a layer
  Vec3 centre() const { return 0.5 * (min + max); }  ///< Middle of the box, m.
  double radius_m() const { return 0.5 * length(max - min); }  ///< Half its diagonal, m.
};

struct CompileOptions {
  int threads = 1;            ///< at least 1; the result has equal bits for every number
  bool force_baseline = false;  ///< use the baseline instruction set even where AVX2 is present (for tests)
  double max_particles = std::numeric_limits<double>::infinity();  ///< budget of the caller, below kMaxParticles: a preset that may start more is refused
  double max_bytes = std::numeric_limits<double>::infinity();      ///< likewise for the memory it may take with all its bounces, bytes
  /// Stands for the model of every layer of pieces, instead of the one named.
  std::shared_ptr<const SolidModel> model = nullptr;
};

/// What is wrong with the models that a valid preset names: files that are missing or bad, models that do not come apart into so many
/// pieces. Empty = nothing. Reads files.
std::vector<Fault> modelFaults(const Preset& preset);

/// A preset with all random draws made and all ground contacts found. Immutable; every member function is thread-safe and
/// a pure function of its arguments.
class Explosion {
 public:
  /// Compiles `preset` with `seed` (the preset's own if empty) over `ground` (flat at the preset's ground height if null).
  /// Errors (input): an invalid preset, one over the particle limit or a budget of `options`, or a model that cannot be read or taken apart;
  /// nothing has been allocated for particles then.
  static Expected<std::shared_ptr<const Explosion>> compile(const Preset& preset,
                                                            std::optional<std::uint64_t> seed = std::nullopt,
                                                            const Ground* ground = nullptr,
                                                            const CompileOptions& options = {});
  ~Explosion();

  std::size_t particleCount() const;  ///< Of all layers, and so entries of each array of a frame.
  const std::vector<LayerSpan>& layers() const;  ///< Layers that have particles, in the order of the frames; they follow each other without gaps.

  /// Time after which nothing changes any more or every particle is dead, s.
  double duration_s() const;

  /// Bytes held per compiled explosion.
  std::size_t memoryBytes() const;

  /// Fills `out` with the state at t (s, any finite value; before 0 there is nothing but pieces that stand). Cost does not depend on t.
  /// Buffers are grown once and reused. `threads` may be any number of at least 1; the bytes do not depend on it.
  void at(double t_s, Frame& out, unsigned fields = kAllFields, int threads = 1) const;
  void at(double t_s, ExactFrame& out, unsigned fields = kAllFields, int threads = 1) const;

  /// Extent over the whole effect, for cameras.
  const Extent& extent() const;

 private:
  struct Impl;
  explicit Explosion(std::unique_ptr<Impl> impl);
  std::unique_ptr<const Impl> impl_;
};

}  // namespace npsee
