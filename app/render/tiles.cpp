#include "app/render/tiles.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {

void TileMask::reset(int width, int height, int side) {
  width_ = width;
  height_ = height;
  side_ = side;
  columns_ = (width + side - 1) / side;
  rows_ = (height + side - 1) / side;
  marked_ = 0;
  grid_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
}

void TileMask::mark(const PixelBox& box) {
  if (!(box.right >= 0.0 && box.high >= 0.0 && box.left < width_ && box.low < height_)) return;
  const auto tile = [&](double pixel, int count) { return static_cast<int>(std::clamp(pixel / side_, 0.0, count - 1.0)); };
  const int first_column = tile(box.left, columns_), last_column = tile(box.right, columns_), last_row = tile(box.high, rows_);
  for (int row = tile(box.low, rows_); row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column) {
      std::uint8_t& cell = grid_[static_cast<std::size_t>(row * columns_ + column)];
      marked_ += cell == 0;
      cell = 1;
    }
}

void TileMask::markAll() { mark({0.0, 0.0, static_cast<double>(width_), static_cast<double>(height_)}); }

void TileMask::markAround(const TileMask& other, int tiles) {
  // Rows first, then columns: a square is both.
  std::vector<std::uint8_t> wide(grid_.size(), 0);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      if (!other.touched(column, row)) continue;
      const auto begin = wide.begin() + row * columns_;
      std::fill(begin + std::max(column - tiles, 0), begin + std::min(column + tiles + 1, columns_), std::uint8_t{1});
    }
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      if (wide[static_cast<std::size_t>(row * columns_ + column)] == 0) continue;
      for (int to = std::max(row - tiles, 0); to < std::min(row + tiles + 1, rows_); ++to) {
        std::uint8_t& cell = grid_[static_cast<std::size_t>(to * columns_ + column)];
        marked_ += cell == 0;
        cell = 1;
      }
    }
}

void TileMesh::upload(const TileMask& mask) {
  width_ = mask.width();
  height_ = mask.height();
  vertices_.clear();
  for (int row = 0; row < mask.rows(); ++row)
    for (int column = 0; column < mask.columns(); ++column) {
      if (!mask.touched(column, row)) continue;
      const int first = column;
      while (column + 1 < mask.columns() && mask.touched(column + 1, row)) ++column;
      const auto x0 = static_cast<float>(first * mask.side()), x1 = static_cast<float>((column + 1) * mask.side());
      const auto y0 = static_cast<float>(row * mask.side()), y1 = static_cast<float>((row + 1) * mask.side());
      vertices_.insert(vertices_.end(), {x0, y0, x1, y0, x1, y1, x0, y0, x1, y1, x0, y1});
    }
  if (!attributes_) {
    attributes_ = gl::VertexArray::make();
    corners_ = gl::Buffer::make();
  }
  glBindVertexArray(attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(float)), vertices_.data(), GL_STREAM_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void TileMesh::draw(const gl::Program& program, float depth, int width, int height) const {
  program.set("u_size", static_cast<float>(width), static_cast<float>(height));
  program.set("u_depth", depth);
  glBindVertexArray(attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size() / 2));
}

}  // namespace npsee::render
