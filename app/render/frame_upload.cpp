#include "app/render/frame_upload.h"

#include "app/gl/vertices.h"
#include "app/render/heat.h"

#include <array>
#include <cstddef>

namespace npsee::render {
namespace {

constexpr std::size_t kSections = 12;

}  // namespace

void FrameUpload::upload(const Frame& frame, std::span<const LayerSpan> layers) {
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
  temperaturesOf(frame, layers, temperatures_);
  if (temperatures_.empty()) return;
  if (!heat_) heat_ = gl::Buffer::make();
  gl::upload(GL_ARRAY_BUFFER, heat_, temperatures_, GL_STREAM_DRAW);
}

void FrameUpload::bind(std::size_t first, bool with_orientation, std::size_t every) const {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  const std::size_t sections = with_orientation ? kSections : std::size_t{kQx};
  for (std::size_t section = 0; section < sections; ++section)
    gl::attribute(static_cast<unsigned>(section), 1, every * sizeof(float), (section * count_ + first) * sizeof(float), 1);
  if (!with_orientation) return;
  if (temperatures_.empty()) {
    // A vertex array keeps what an earlier frame needed.
    glDisableVertexAttribArray(kTemperature);
    glVertexAttrib1f(kTemperature, 0.0f);
    return;
  }
  glBindBuffer(GL_ARRAY_BUFFER, heat_.name());
  gl::attribute(kTemperature, 1, every * sizeof(float), first * sizeof(float), 1);
}

void FrameUpload::uploadVelocities(const Frame& frame) {
  // Without them nothing moves.
  std::vector<float> vectors(3 * frame.count, 0.0f);
  const bool moving = frame.vx.size() >= frame.count && frame.vy.size() >= frame.count && frame.vz.size() >= frame.count;
  for (std::size_t i = 0; moving && i < frame.count; ++i) {
    vectors[3 * i] = frame.vx[i];
    vectors[3 * i + 1] = frame.vy[i];
    vectors[3 * i + 2] = frame.vz[i];
  }
  if (!velocities_) velocities_ = gl::Buffer::make();
  gl::upload(GL_ARRAY_BUFFER, velocities_, vectors, GL_STREAM_DRAW);
}

void FrameUpload::bindVelocities(std::size_t first) const {
  glBindBuffer(GL_ARRAY_BUFFER, velocities_.name());
  gl::attribute(kVelocityVector, 3, 3 * sizeof(float), 3 * first * sizeof(float), 1);
}

void BlendedUpload::upload(std::span<const BlendedInstance> instances) {
  if (!buffer_) buffer_ = gl::Buffer::make();
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(), GL_STREAM_DRAW);
}

void BlendedUpload::bind(std::size_t first, bool with_light) const {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  const std::size_t base = first * sizeof(BlendedInstance);
  for (unsigned location = kX; location <= kQw; ++location) gl::attribute(location, 1, sizeof(BlendedInstance), base + location * sizeof(float), 1);
  gl::attribute(kKind, 1, sizeof(BlendedInstance), base + offsetof(BlendedInstance, kind), 1);
  if (with_light) gl::attribute(kMeshPosition, 3, sizeof(BlendedInstance), base + offsetof(BlendedInstance, light), 1);
}

}  // namespace npsee::render
