#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::render {

/// Keyword of the text that says from what a picture was made; see recipeOf.
inline constexpr std::string_view kRecipeKeyword = "npsee recipe";

/// Puts a tEXt chunk behind the header of an encoded PNG.
void insertPngText(std::vector<std::uint8_t>& png, std::string_view keyword, std::string_view text);

/// The text of a keyword in a PNG whose every chunk is whole (its length and checksum hold, and the last one ends it); nothing
/// for a damaged or cut file, or one without the text.
std::optional<std::string> textOfWholePng(std::string_view png, std::string_view keyword);

}  // namespace npsee::render
