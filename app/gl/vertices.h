#pragma once

#include "app/gl/objects.h"

#include <cstddef>
#include <vector>

namespace npsee::gl {

/// Fills a buffer with the items of a vector and leaves it bound to `target`. `usage` as for glBufferData.
template <class Item>
void upload(GLenum target, const Buffer& buffer, const std::vector<Item>& items, GLenum usage) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), usage);
}

/// Lets the bound vertex array take the floats of a location from the buffer bound to GL_ARRAY_BUFFER: `components` floats at
/// `offset` bytes, one item every `stride` bytes. With a divisor of 1 an item belongs to an instance instead of a vertex.
inline void attribute(GLuint location, GLint components, std::size_t stride, std::size_t offset, GLuint divisor = 0) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(location, divisor);
}

}  // namespace npsee::gl
