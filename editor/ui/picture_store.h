#pragma once

#include "app/gl/objects.h"
#include "editor/document/file_stamp.h"

#include <imgui.h>

#include <filesystem>
#include <map>
#include <utility>
#include <vector>

namespace npsee::editor {

/// Picture files as textures, read once and again when a file has changed.
class PictureStore {
 public:
  /// Null where the file is no picture.
  ImTextureID texture(const std::filesystem::path& file);
  /// Textures that were read since this was asked last.
  std::vector<ImTextureID> takeRead() { return std::exchange(read_, {}); }

 private:
  struct Held {
    FileStamp stamp;
    gl::Texture texture;
  };
  std::map<std::filesystem::path, Held> held_;
  std::vector<ImTextureID> read_;
};

}  // namespace npsee::editor
