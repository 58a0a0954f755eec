#pragma once

#include <npsee/parameters.h>

#include <optional>

namespace npsee {

/// "#rrggbb" in lower case if every component is a whole 255th, else nothing.
std::optional<std::string> hexColour(const Colour& colour);
std::optional<Colour> parseHexColour(std::string_view text);

}  // namespace npsee
