#pragma once

#include <span>
#include <string_view>

namespace npsee::gl {

/// A file of `shaders/`, embedded when the program is built.
struct ShaderSource {
  std::string_view name;  ///< file name without folder
  std::string_view text;
};

std::span<const ShaderSource> shaderSources();

}  // namespace npsee::gl
