#pragma once

#include <array>
#include <cstdint>

namespace npsee::render {

/// A letter of our own small font, 5 x 7 dots and two rows below the line: one byte per row, bit 4 is the left column.
inline constexpr int kGlyphWidth = 5, kGlyphHeight = 9;
using Glyph = std::array<std::uint8_t, kGlyphHeight>;

/// The glyph of a printable ASCII character; a hollow box for any other.
const Glyph& glyphOf(char letter);

}  // namespace npsee::render
