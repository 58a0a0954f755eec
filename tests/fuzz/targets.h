#pragma once

#include <string_view>

namespace npsee::fuzz {

/// What must hold for any bytes taken as a preset file: faults are reported or the preset is valid and survives writing
/// and reading. Aborts otherwise, which a fuzzer and a test both see.
void presetFile(std::string_view bytes);

/// The same for lines of `--set`: a refused line leaves the preset as it was, and what passes `validate` survives a file.
void settings(std::string_view bytes);

}  // namespace npsee::fuzz
