#pragma once

#include "editor/panels/row.h"

namespace npsee::editor {

/// Below the search: how far to vary, a button that draws the selected layer anew around what it is, and one that changes the seed.
void drawVaryStrip(const PanelContext& ui);
/// The lock of a row against being varied, "button:lock:NAME", at the end of its label; unlocked it shows only under the pointer.
void drawLock(const PanelContext& ui, const Row& row, const RowFrame& frame);

/// Draws values anew as one undo step: of one layer, or of all (-1), or only those of a section.
void varyLayers(const PanelContext& ui, int layer, std::optional<Section> section = {});
/// The next seed: other particles with the same settings.
void varySeed(const PanelContext& ui);

bool locked(const PanelContext& ui, const std::string& name);
void toggleLock(const PanelContext& ui, const std::string& name);

}  // namespace npsee::editor
