#include "app/render/contact_sheet.h"

#include "app/render/glyphs.h"

#include <algorithm>
#include <cstdint>

namespace npsee::render {
namespace {

/// Dots from one letter to the next, and above the line.
constexpr int kAdvance = kGlyphWidth + 1, kLineHeight = 7;

struct Area {
  int left, top, right, bottom;  ///< right and bottom excluded
};

void mixPixel(std::uint8_t* pixel, int value, int share_percent) {
  for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>((pixel[c] * (100 - share_percent) + value * share_percent) / 100);
}

void fill(Image& image, const Area& cell, const Area& area, int value, int share_percent) {
  for (int y = std::max(area.top, cell.top); y < std::min(area.bottom, cell.bottom); ++y)
    for (int x = std::max(area.left, cell.left); x < std::min(area.right, cell.right); ++x) mixPixel(image.pixel(x, y), value, share_percent);
}

}  // namespace

void placeInSheet(Image& sheet, const Image& picture, int column, int row) {
  for (int y = 0; y < picture.height; ++y)
    std::copy_n(picture.pixel(0, y), static_cast<std::size_t>(picture.width) * 4, sheet.pixel(column * picture.width, row * picture.height + y));
}

void captionCell(Image& sheet, int cell_width, int cell_height, int column, int row, std::string_view text) {
  const Area cell{column * cell_width, row * cell_height, (column + 1) * cell_width, (row + 1) * cell_height};
  const int dot = std::max(1, cell_height / 180), margin = 4 * dot;
  const int width = kAdvance * static_cast<int>(text.size()) * dot, height = kLineHeight * dot;
  const int left = cell.left + 2 * margin, top = cell.bottom - 2 * margin - height;
  // A plate under the text: it has to be read over sky, ground and fire alike.
  fill(sheet, cell, {left - margin, top - margin, left + width + margin - dot, top + height + margin}, 18, 62);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const Glyph& glyph = glyphOf(text[i]);
    for (int y = 0; y < kGlyphHeight; ++y)
      for (int x = 0; x < kGlyphWidth; ++x) {
        if (((glyph[static_cast<std::size_t>(y)] >> (kGlyphWidth - 1 - x)) & 1) == 0) continue;
        const int at_x = left + (kAdvance * static_cast<int>(i) + x) * dot, at_y = top + y * dot;
        fill(sheet, cell, {at_x, at_y, at_x + dot, at_y + dot}, 226, 100);
      }
  }
}

}  // namespace npsee::render
