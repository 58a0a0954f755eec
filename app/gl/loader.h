#pragma once

#include <npsee/error.h>

#include <string>

namespace npsee::gl {

class Context;

/// A function by name, as the context's library finds it.
using FindFunction = void (*(*)(const char* name))();

/// Loads the GL 3.3 functions for the context that is current. Error kind graphics if it offers less.
Expected<void> loadFunctions(FindFunction find, const Context* owner);

/// Loads them again if another context's were loaded last: the loader keeps one set per process, and two drivers in one
/// process (window and offscreen, in tests) have different ones.
void ensureFunctions(FindFunction find, const Context* owner);

/// GL_RENDERER and GL_VERSION in one line.
std::string describeDriver();

}  // namespace npsee::gl
