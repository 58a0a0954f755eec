#pragma once

#include "app/render/image.h"

#include <string_view>

namespace npsee::render {

/// Copies `picture` into the cell at (column, row) of `sheet`, whose cells all have the picture's size.
void placeInSheet(Image& sheet, const Image& picture, int column, int row);

/// Writes a line of ASCII text into the lower left corner of the cell, as far as it fits.
void captionCell(Image& sheet, int cell_width, int cell_height, int column, int row, std::string_view text);

}  // namespace npsee::render
