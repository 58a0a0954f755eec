#pragma once

#include <string>

namespace npsee::commands {

/// Names the program's build: the same for the same bytes, another for any other build, whatever its version. Hexadecimal. The identifier that the linker
/// made of what it linked; where it made none, the hash of the program's file.
const std::string& buildId();

}  // namespace npsee::commands
