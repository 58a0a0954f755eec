#include "app/gl/objects.h"

#include <cstring>

namespace npsee::gl {

#define NPSEE_GL_KIND(Kind, Gen, Delete)      \
  GLuint Kind::create() {                     \
    GLuint name = 0;                          \
    Gen(1, &name);                            \
    return name;                              \
  }                                           \
  void Kind::destroy(GLuint name) { Delete(1, &name); }

NPSEE_GL_KIND(BufferKind, glGenBuffers, glDeleteBuffers)
NPSEE_GL_KIND(VertexArrayKind, glGenVertexArrays, glDeleteVertexArrays)
NPSEE_GL_KIND(TextureKind, glGenTextures, glDeleteTextures)
NPSEE_GL_KIND(RenderbufferKind, glGenRenderbuffers, glDeleteRenderbuffers)
NPSEE_GL_KIND(FramebufferKind, glGenFramebuffers, glDeleteFramebuffers)

#undef NPSEE_GL_KIND

namespace {

// Of OpenGL 4.5 and KHR_robustness; a driver may answer so whatever version was asked for.
constexpr GLenum kContextLost = 0x0507;
constexpr const char* kContextLostName = "GL_CONTEXT_LOST";

const char* errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    case kContextLost: return kContextLostName;
    default: return "an unknown GL error";
  }
}

}  // namespace

const char* pendingError() {
  const GLenum first = glGetError();
  if (first == GL_NO_ERROR) return nullptr;
  // A lost context reports errors for ever.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
  }
  return errorName(first);
}

bool isLoss(const char* error) { return error != nullptr && std::strcmp(error, kContextLostName) == 0; }

}  // namespace npsee::gl
