#include "editor/ui/theme.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

namespace npsee::editor {
namespace {

// Latin with accents, Greek, dashes and quotes, arrows, and the few mathematical signs that labels use.
constexpr std::array<ImWchar, 13> kGlyphs{0x0020, 0x00FF, 0x0100, 0x017F, 0x0370, 0x03FF, 0x2010, 0x2044, 0x2190, 0x2193, 0x2200, 0x22FF, 0};

using Candidates = std::array<const char*, 2>;
constexpr Candidates kText{"/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
constexpr Candidates kBold{"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};
constexpr Candidates kNumbers{"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf"};

ImFont* load(const Candidates& candidates, float pixels) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.OversampleH = 2;
  config.PixelSnapH = true;
  for (const char* file : candidates) {
    std::error_code missing;
    if (!std::filesystem::is_regular_file(file, missing)) continue;
    if (ImFont* font = atlas.AddFontFromFileTTF(file, pixels, &config, kGlyphs.data())) return font;
  }
  ImFontConfig built_in;
  built_in.SizePixels = std::floor(pixels);
  return atlas.AddFontDefault(&built_in);
}

}  // namespace

Fonts loadFonts(float scale) {
  Fonts fonts;
  fonts.text = load(kText, std::round(15.0f * scale));
  fonts.small = load(kText, std::round(12.5f * scale));
  fonts.bold = load(kBold, std::round(15.0f * scale));
  fonts.numbers = load(kNumbers, std::round(13.5f * scale));
  return fonts;
}

}  // namespace npsee::editor
