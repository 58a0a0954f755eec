#pragma once

#include "app/render/mission_camera.h"
#include "app/render/model_pass.h"

#include <npsee/explosion.h>
#include <npsee/recording.h>

#include <memory>
#include <optional>

namespace npsee::render {

struct MissionView;

/// The burst that took a vehicle apart.
struct Undoing {
  double time_s = 0.0;
  Vec3 burst_m;             ///< in the world
  std::uint64_t seed = 0;
  bool shell = false;       ///< of artillery; else a round that struck, or what the vehicle carried
};

/// Whether a vehicle has come apart by a time: destroyed by a burst near it. Figures never do. A function of the recording alone.
std::optional<Undoing> undoingOf(const Recording& recording, std::size_t vehicle, double time_s);

/// Whether it is drawn in pieces: large enough to see them, and at its true size.
bool drawnInPieces(const MissionEye& eye, const MissionView& view, const Vec3& at, double length_m);

/// A vehicle's model, burnt, in the directions of the world and relative to `origin_m`; null if it has no inside.
std::shared_ptr<const SolidModel> burntSolid(const Model& model, const ModelInstance& instance, const Vec3& origin_m);

/// How a vehicle comes apart: one layer of pieces, flung by the burst. Its model is given relative to `origin_m`, and stands `height_m` above.
Preset wreckPreset(const VehicleType& type, const Undoing& undoing, const Vec3& origin_m, double height_m);

}  // namespace npsee::render
