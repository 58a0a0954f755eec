#include "app/gl/loader.h"

#include <glad/gl.h>

namespace npsee::gl {
namespace {

/// Whose functions the process-wide loader holds.
const Context*& loadedFor() {
  static const Context* owner = nullptr;
  return owner;
}

std::string text(GLenum what) {
  const GLubyte* value = glGetString(what);
  return value != nullptr ? reinterpret_cast<const char*>(value) : "unknown";
}

}  // namespace

Expected<void> loadFunctions(FindFunction find, const Context* owner) {
  const int version = gladLoadGL(find);
  loadedFor() = owner;
  if (version < GLAD_MAKE_VERSION(3, 3))
    return fail(ErrorKind::graphics,
                "the driver offers OpenGL " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." + std::to_string(GLAD_VERSION_MINOR(version)) + ", npsee needs 3.3.",
                "LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software driver.");
  return {};
}

void ensureFunctions(FindFunction find, const Context* owner) {
  if (loadedFor() == owner) return;
  gladLoadGL(find);
  loadedFor() = owner;
}

std::string describeDriver() { return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION); }

}  // namespace npsee::gl
