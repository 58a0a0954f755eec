#pragma once

#include <imgui.h>

namespace npsee::editor {

/// Colours of the editor's look (docs: quiet, so that the explosion is the brightest thing on the screen).
struct Theme {
  ImU32 background, panel, raised, line, text, dim, accent, geometry, error, good;
  bool dark = true;
};

Theme darkTheme();
/// Equal contrast on a light ground.
Theme lightTheme();

/// `colour` with another opacity, 0..1.
ImU32 faded(ImU32 colour, float opacity);

/// Gives ImGui the colours and metrics, for a display scaled by `scale`.
void applyTheme(const Theme& theme, float scale);

struct Fonts {
  ImFont* text = nullptr;     ///< 15 px
  ImFont* small = nullptr;    ///< 12.5 px, for hints and headings
  ImFont* bold = nullptr;     ///< 15 px semibold
  ImFont* numbers = nullptr;  ///< 13.5 px, fixed width
};

/// Loads Inter and JetBrains Mono from the system, else DejaVu, else ImGui's built-in font, into the current context's atlas.
Fonts loadFonts(float scale);

}  // namespace npsee::editor
