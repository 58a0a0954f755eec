#pragma once

#include "app/gl/program.h"

#include <cstdint>
#include <vector>

namespace npsee::render {

/// A rectangle of a picture, pixels from the lower left; empty where right < left.
struct PixelBox {
  double left = 1.0, low = 1.0, right = -1.0, high = -1.0;
};

/// The parts of a picture that an effect touches, as squares of 16 pixels or as many as wanted. An effect of a hundred pieces touches a small
/// part; clearing, resolving and finishing the rest would cost more than drawing it.
class TileMask {
 public:
  static constexpr int kSide = 16;

  void reset(int width, int height, int side = kSide);
  /// Parts outside the picture do not count.
  void mark(const PixelBox& box);
  void markAll();
  /// Marks all tiles within so many tiles of a marked one of a mask of the same size.
  void markAround(const TileMask& other, int tiles);

  int side() const { return side_; }
  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return marked_ == 0; }
  bool touched(int column, int row) const { return grid_[static_cast<std::size_t>(row * columns_ + column)] != 0; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }

 private:
  int width_ = 0, height_ = 0, side_ = kSide, columns_ = 0, rows_ = 0;
  std::size_t marked_ = 0;
  std::vector<std::uint8_t> grid_;
};

/// The touched tiles as triangles, for passes that go over them.
class TileMesh {
 public:
  void upload(const TileMask& mask);
  /// Draws with the program in use, whose vertex shader is tiles.vert, at the given device depth.
  void draw(const gl::Program& program, float depth) const { draw(program, depth, width_, height_); }
  /// Into a target that stands for so many pixels of the picture.
  void draw(const gl::Program& program, float depth, int width, int height) const;

 private:
  gl::VertexArray attributes_;
  gl::Buffer corners_;
  std::vector<float> vertices_;
  int width_ = 0, height_ = 0;
};

}  // namespace npsee::render
