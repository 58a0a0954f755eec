#pragma once

#include <imgui.h>

namespace npsee::editor {

enum class Icon { play, pause, to_start, to_end, step_back, step_on, event_back, event_on, loop, plus, minus, copy, bin, eye, eye_off, reset, cross, chevron_right, chevron_down, folder, file, up, search, frame, solo, lock, lock_open, dice, seed, paste, flip, grid };

/// Draws an icon as simple strokes around `centre`, within a square of `size` pixels.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);

}  // namespace npsee::editor
