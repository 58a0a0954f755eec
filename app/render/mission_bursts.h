#pragma once

#include "app/render/effect_passes.h"
#include "app/render/mission_camera.h"
#include "app/render/mission_light.h"
#include "app/render/mission_wrecks.h"
#include "app/render/preset_shelf.h"

#include <npsee/explosion.h>
#include <npsee/recording.h>

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace npsee::render {

class TileMask;
struct MissionView;

/// Most bursts drawn in one picture: the youngest. Their pieces are thinned out with distance.
inline constexpr std::size_t kMostBursts = 64;

/// The explosions of a mission's shells, each compiled over the ground around its burst, and what else is made of particles:
/// flares, burning wrecks, smoke of guns that fired.
class MissionBursts {
 public:
  /// Makes ready what is to be drawn at a moment. Compiled explosions are kept from picture to picture within a bounded memory, the
  /// least recently drawn are dropped first.
  void prepare(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const MissionLight& light, const ModelPass& models);

  /// Shadows and opaque forms, then, when everything opaque is drawn, what is blended, far ones first.
  Expected<void> drawOpaque(EffectPasses& effects, const MissionEye& eye);
  Expected<void> drawBlended(EffectPasses& effects, const MissionEye& eye);

  /// Marks where bursts may be brighter than a picture can show.
  void markBright(TileMask& mask, const MissionEye& eye) const;

  /// By vehicle: 1 for those that are drawn in pieces, as prepared; all others stand whole.
  std::span<const char> inPieces() const { return in_pieces_; }

  std::size_t count() const { return bursts_.size(); }
  std::size_t particles() const;
  std::size_t compiled() const { return kept_.size(); }
  const std::vector<std::string>& warnings() const { return shelf_.warnings(); }

  /// Preset of a shell's burst under a view.
  std::shared_ptr<const Preset> presetOf(const Recording& recording, const ShellRecord& shell, const MissionView& view);

 private:
  /// One effect to draw: particles placed relative to `origin`.
  struct Drawn {
    Vec3 origin;
    Frame frame;
    std::vector<LayerSpan> layers;
    GroundLevel ground;
    double depth_m = 0.0;
  };
  struct Key {
    std::shared_ptr<const Preset> preset;
    std::uint64_t seed = 0;
    Vec3 at;
    Vec3 wind;
    int vehicle = -1;  ///< that comes apart, its preset made for it; -1 = a burst
    double since_s = 0.0;
    bool operator==(const Key& other) const { return vehicle == other.vehicle && since_s == other.since_s && seed == other.seed && at == other.at && wind == other.wind && (vehicle >= 0 || preset == other.preset || *preset == *other.preset); }
  };
  struct Kept {
    Key key;
    std::shared_ptr<const Explosion> explosion;  // null: it could not be compiled
  };
  /// `model` makes the model of pieces, where a vehicle comes apart; without one there is nothing to compile.
  std::shared_ptr<const Explosion> compiledFor(const Recording& recording, Key key, int threads, const std::function<std::shared_ptr<const SolidModel>(Key&)>& model = nullptr);
  void addWrecks(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const ModelPass& models);
  void addWreck(const Recording& recording, std::size_t vehicle, const Undoing& undoing, double time_s, const MissionView& view, const MissionEye& eye, const ModelPass& models);
  void addBurst(const Recording& recording, const ShellRecord& shell, double time_s, const MissionView& view, const MissionEye& eye);
  Drawn& next();

  PresetShelf shelf_;
  std::list<Kept> kept_;  // the most recently drawn first
  std::size_t kept_bytes_ = 0;
  const float* ground_ = nullptr;  // samples of the terrain they were compiled over
  MissionLight light_;
  std::vector<Drawn> bursts_;
  std::vector<Drawn> spare_;
  std::vector<char> in_pieces_;
};

}  // namespace npsee::render
