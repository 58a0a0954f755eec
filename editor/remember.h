#pragma once

#include "editor/desk/settings.h"
#include "editor/ui/context.h"

namespace npsee::editor {

/// What the settings say about panels and picture, at the start; and what the person has made of it, after every frame.
void bringIn(const Settings& settings, UiState& state);
void noteDown(const UiState& state, Settings& settings);

}  // namespace npsee::editor
