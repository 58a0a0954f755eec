#include "app/render/fine_frames.h"

#include "app/render/frame_particles.h"
#include "app/render/meshes.h"
#include "app/render/quality.h"

#include <algorithm>

namespace npsee::render {

double FineFrames::timeOf(int look) { return kShutter_s * (((7 * look + 3) % kLooks + 0.5) / kLooks - 0.5); }

std::array<double, 2> FineFrames::asideOf(int look, int width, int height) {
  const int column = look % 4, row = look / 4;
  return {2.0 / width * ((column + 0.5) / 4.0 - 0.5), 2.0 / height * ((row + 0.5) / 4.0 - 0.5)};
}

View FineFrames::viewOf(const View& view, int look, int width, int height) {
  View out = view;
  const std::array<double, 2> aside = asideOf(look, width, height);
  // A place on the picture is clip.xy / clip.w: moving it all aside adds a share of the last row.
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 2; ++row) out.view_projection[4 * column + row] += static_cast<float>(aside[static_cast<std::size_t>(row)] * static_cast<double>(view.view_projection[4 * column + 3]));
  return out;
}

const Frame& FineFrames::frameOf(const Frame& frame, std::span<const LayerSpan> layers, int look) {
  if (look == 0) moved_ = frame;
  if (frame.vx.size() < frame.count) return moved_;
  const auto dt = static_cast<float>(timeOf(look));
  for (const LayerSpan& layer : layers) {
    if (!isSolid(layer.form) && layer.form != Form::pieces) continue;
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i) {
      moved_.x[i] = frame.x[i] + dt * frame.vx[i];
      moved_.y[i] = frame.y[i] + dt * frame.vy[i];
      moved_.z[i] = frame.z[i] + dt * frame.vz[i];
    }
  }
  return moved_;
}

}  // namespace npsee::render
