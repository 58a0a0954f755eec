#pragma once

#include "editor/ui/slider.h"

namespace npsee::editor {

/// Over the viewport's picture: past states (onion skin), trails, arrows of speed, the figures of the moment, and the switches of these in the lower
/// right corner, "toggle:onion skin", "toggle:trails", "toggle:speed", "toggle:figures".
void drawTimeOverlays(const PanelContext& ui, const Box& box);

}  // namespace npsee::editor
