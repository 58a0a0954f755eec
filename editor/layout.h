#pragma once

#include "editor/ui/context.h"

namespace npsee::editor {

/// The one window: menu bar, panels left and right of the viewport, time line and status below; bars between them drag.
void drawLayout(const PanelContext& ui);

}  // namespace npsee::editor
