#pragma once

#include "editor/ui/context.h"
#include "editor/ui/slider.h"

namespace npsee::editor {

/// Which part of the world a rectangle of the screen shows: north up, x to the right, z down.
struct PlanView {
  Box box;
  double centre_x = 0.0, centre_z = 0.0, metre_per_px = 1.0;

  ImVec2 pixel(const Place& at) const {
    return {box.at.x + 0.5f * box.width + static_cast<float>((at.x_m - centre_x) / metre_per_px), box.at.y + 0.5f * box.height + static_cast<float>((at.z_m - centre_z) / metre_per_px)};
  }
  Place place(const ImVec2& pixel) const {
    return {centre_x + static_cast<double>(pixel.x - box.at.x - 0.5f * box.width) * metre_per_px, centre_z + static_cast<double>(pixel.y - box.at.y - 0.5f * box.height) * metre_per_px};
  }
  bool inside(const ImVec2& p, float margin) const { return p.x >= box.at.x - margin && p.x <= box.right() + margin && p.y >= box.at.y - margin && p.y <= box.end().y + margin; }
};

/// Relief and contours of the part shown.
void drawGround(const PanelContext& ui, const PlanView& view);
/// Reach of the guns, lines of fire, shells, bursts, beliefs, goals, and the ruler.
void drawPlanLines(const PanelContext& ui, const PlanView& view);

}  // namespace npsee::editor
