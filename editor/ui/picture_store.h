#pragma once

#include "app/gl/objects.h"
#include "editor/document/file_stamp.h"

#include <imgui.h>

#include <filesystem>
#include <map>

namespace npsee::editor {

/// Picture files as textures, read once and again when a file has changed.
class PictureStore {
 public:
  /// Null where the file is no picture.
  ImTextureID texture(const std::filesystem::path& file);

 private:
  struct Held {
    FileStamp stamp;
    gl::Texture texture;
  };
  std::map<std::filesystem::path, Held> held_;
};

}  // namespace npsee::editor
