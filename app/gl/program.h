#pragma once

#include "app/gl/objects.h"

#include <npsee/error.h>

#include <string_view>

namespace npsee::gl {

/// A linked GLSL program. Uniforms are set by name with the program in use; a name that the compiler dropped is ignored.
class Program {
 public:
  Program() = default;

  /// Compiles and links embedded shader files (`shaders/NAME`). A line `#include "file.glsl"` is replaced by that file.
  /// Error kind graphics with the driver's log.
  static Expected<Program> fromFiles(std::string_view vertex_file, std::string_view fragment_file);
  /// The same into this object.
  Expected<void> load(std::string_view vertex_file, std::string_view fragment_file);

  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  explicit operator bool() const { return name_ != 0; }
  GLuint name() const { return name_; }
  void use() const { glUseProgram(name_); }

  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, float x, float y) const;
  void set(const char* uniform, float x, float y, float z) const;
  void set(const char* uniform, float x, float y, float z, float w) const;
  void setMatrix(const char* uniform, const float (&column_major)[16]) const;

 private:
  GLuint name_ = 0;
};

}  // namespace npsee::gl
