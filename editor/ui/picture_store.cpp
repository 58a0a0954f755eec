#include "editor/ui/picture_store.h"

#include "app/render/image.h"

#include <cstdint>

namespace npsee::editor {
namespace {

/// Thumbnails of a very large library: all are read again as they come into view.
constexpr std::size_t kMostHeld = 400;

gl::Texture upload(const render::Image& image) {
  gl::Texture texture = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

ImTextureID idOf(const gl::Texture& texture) { return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.name())); }

}  // namespace

ImTextureID PictureStore::texture(const std::filesystem::path& file) {
  const FileStamp stamp = stampOf(file);
  auto held = held_.find(file);
  if (held == held_.end() || held->second.stamp != stamp) {
    if (held_.size() >= kMostHeld) held_.clear();
    const auto image = render::readPng(file);
    held = held_.insert_or_assign(file, Held{stamp, image ? upload(*image) : gl::Texture()}).first;
    if (image) read_.push_back(idOf(held->second.texture));
  }
  return held->second.texture ? idOf(held->second.texture) : nullptr;
}

}  // namespace npsee::editor
