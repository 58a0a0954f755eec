#pragma once

#include "editor/ui/slider.h"

namespace npsee::editor {

/// Over the viewport's picture B: A left of the divider "compare:divider", or A alone while it is flipped; and above, what A is
/// ("choice:compare"), the way of comparing and the end of it. Nothing where nothing is compared.
void drawCompare(const PanelContext& ui, const Box& box);

/// The middle of the window while variations are shown: nine pictures "variation:1" to "variation:9", the edited preset in the middle. A click, or
/// Alt with the number, adopts one.
void drawVariations(const PanelContext& ui);

}  // namespace npsee::editor
