#include "app/render/deep_image.h"
#include "editor/script/parser.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace npsee::fuzz {

void uiScript(std::string_view bytes) {
  const auto script = editor::parseScript(bytes, "fuzz.txt");
  if (!script) return requireFaults(script.error());
  for (const editor::ScriptCommand& command : *script) {
    require(command.line > 0 && !command.name.empty(), "a command has a name and a line");
    for (const std::string& argument : command.arguments)
      if (const auto key = editor::parseKeyStroke(argument); key) require(!editor::keyText(*key).empty(), "a key has a name");
  }
}

void comparedPicture(std::string_view bytes) {
  const auto picture = render::parseDeepPng(bytes, "fuzz.png");
  if (!picture) return requireFaults(picture.error());
  require(picture->width > 0 && picture->height > 0, "a picture has a size");
  require(picture->rgba.size() == 4 * static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height), "a picture has all its pixels");
}

}  // namespace npsee::fuzz
