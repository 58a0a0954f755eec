#pragma once

#include <glad/gl.h>

#include <utility>

namespace npsee::gl {

/// Owner of one GL object name. Created empty; destroyed with the context current.
template <class Kind>
class Object {
 public:
  Object() = default;
  static Object make() {
    Object out;
    out.name_ = Kind::create();
    return out;
  }
  ~Object() { reset(); }
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }
  void reset() {
    if (name_ != 0) Kind::destroy(name_);
    name_ = 0;
  }

 private:
  GLuint name_ = 0;
};

struct BufferKind {
  static GLuint create();
  static void destroy(GLuint name);
};
struct VertexArrayKind {
  static GLuint create();
  static void destroy(GLuint name);
};
struct TextureKind {
  static GLuint create();
  static void destroy(GLuint name);
};
struct RenderbufferKind {
  static GLuint create();
  static void destroy(GLuint name);
};
struct FramebufferKind {
  static GLuint create();
  static void destroy(GLuint name);
};

using Buffer = Object<BufferKind>;
using VertexArray = Object<VertexArrayKind>;
using Texture = Object<TextureKind>;
using Renderbuffer = Object<RenderbufferKind>;
using Framebuffer = Object<FramebufferKind>;

/// Name of the oldest pending GL error ("GL_INVALID_ENUM"), clearing all of them; null if there is none.
const char* pendingError();

/// Whether that is the end of the context: nothing more will be drawn in it.
bool isLoss(const char* error);

}  // namespace npsee::gl
