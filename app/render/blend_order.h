#pragma once

#include "app/render/frame_upload.h"
#include "app/render/smoke_shade.h"
#include "app/render/view.h"

#include <cstdint>
#include <span>
#include <vector>

namespace npsee::render {

/// Which of a frame's blended particles are wanted.
enum class Blended { all, soft, pieces };

/// The particles that are blended (soft forms, and solid ones that are not opaque), from back to front. Ties keep the
/// order of the frame, so that equal frames give equal pictures. Buffers are kept from frame to frame.
class BlendOrder {
 public:
  /// Neighbours in the order that one call can draw.
  struct Run {
    Form form;  ///< any soft form stands for all of them
    std::size_t first, count;
    std::shared_ptr<const Fragments> pieces;  ///< that the instances are of; their kind is the number of the piece
  };

  /// `shade` is the light inside the smoke; without it all puffs stand in full light and none is left out as hidden by others.
  void sort(const Frame& frame, std::span<const LayerSpan> layers, const View& view, Blended wanted, const SmokeShade* shade = nullptr);
  std::span<const BlendedInstance> instances() const { return instances_; }
  std::span<const Run> runs() const { return runs_; }

 private:
  struct Entry {
    float depth;
    std::uint32_t index;
    std::uint32_t layer;
  };
  std::vector<Entry> entries_;
  std::vector<BlendedInstance> instances_;
  std::vector<Run> runs_;
};

}  // namespace npsee::render
