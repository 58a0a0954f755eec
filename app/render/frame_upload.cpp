#include "app/render/frame_upload.h"

#include <array>
#include <cstddef>

namespace npsee::render {
namespace {

constexpr std::size_t kSections = 12;

void instanceAttribute(unsigned location, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, 1, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(location, 1);
}

}  // namespace

void FrameUpload::upload(const Frame& frame) {
  if (!buffer_) buffer_ = gl::Buffer::make();
  count_ = frame.count;
  const std::array<const std::vector<float>*, kSections> arrays{&frame.x, &frame.y, &frame.z, &frame.size, &frame.r, &frame.g,
                                                                &frame.b, &frame.a, &frame.qx, &frame.qy, &frame.qz, &frame.qw};
  const std::size_t bytes = count_ * sizeof(float);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(kSections * bytes), nullptr, GL_STREAM_DRAW);
  for (std::size_t section = 0; section < kSections; ++section)
    if (arrays[section]->size() >= count_)
      glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(section * bytes), static_cast<GLsizeiptr>(bytes), arrays[section]->data());
}

void FrameUpload::bind(std::size_t first, bool with_orientation, std::size_t every) const {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  const std::size_t sections = with_orientation ? kSections : std::size_t{kQx};
  for (std::size_t section = 0; section < sections; ++section)
    instanceAttribute(static_cast<unsigned>(section), every * sizeof(float), (section * count_ + first) * sizeof(float));
}

void BlendedUpload::upload(std::span<const BlendedInstance> instances) {
  if (!buffer_) buffer_ = gl::Buffer::make();
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(), GL_STREAM_DRAW);
}

void BlendedUpload::bind(std::size_t first) const {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  const std::size_t base = first * sizeof(BlendedInstance);
  for (unsigned location = kX; location <= kQw; ++location) instanceAttribute(location, sizeof(BlendedInstance), base + location * sizeof(float));
  instanceAttribute(kKind, sizeof(BlendedInstance), base + offsetof(BlendedInstance, kind));
}

}  // namespace npsee::render
