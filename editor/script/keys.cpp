#include "editor/script/parser.h"
#include "sim/core/text.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace npsee::editor {
namespace {

struct NamedKey {
  std::string_view name;
  int code;
};

// Letters, digits and function keys follow from their codes; these have names.
constexpr std::array<NamedKey, 39> kKeys{{
    {"Up", GLFW_KEY_UP}, {"Down", GLFW_KEY_DOWN}, {"Left", GLFW_KEY_LEFT}, {"Right", GLFW_KEY_RIGHT},
    {"Home", GLFW_KEY_HOME}, {"End", GLFW_KEY_END}, {"PageUp", GLFW_KEY_PAGE_UP}, {"PageDown", GLFW_KEY_PAGE_DOWN},
    {"Space", GLFW_KEY_SPACE}, {"Enter", GLFW_KEY_ENTER}, {"Escape", GLFW_KEY_ESCAPE}, {"Tab", GLFW_KEY_TAB},
    {"Backspace", GLFW_KEY_BACKSPACE}, {"Delete", GLFW_KEY_DELETE}, {"Insert", GLFW_KEY_INSERT},
    {"Comma", GLFW_KEY_COMMA}, {"Period", GLFW_KEY_PERIOD}, {"Minus", GLFW_KEY_MINUS}, {"Equal", GLFW_KEY_EQUAL}, {"Slash", GLFW_KEY_SLASH},
    {"KP0", GLFW_KEY_KP_0}, {"KP1", GLFW_KEY_KP_1}, {"KP2", GLFW_KEY_KP_2}, {"KP3", GLFW_KEY_KP_3}, {"KP4", GLFW_KEY_KP_4},
    {"KP5", GLFW_KEY_KP_5}, {"KP6", GLFW_KEY_KP_6}, {"KP7", GLFW_KEY_KP_7}, {"KP8", GLFW_KEY_KP_8}, {"KP9", GLFW_KEY_KP_9},
    {"KPEnter", GLFW_KEY_KP_ENTER}, {"F1", GLFW_KEY_F1}, {"F2", GLFW_KEY_F2}, {"F5", GLFW_KEY_F5}, {"F6", GLFW_KEY_F6}, {"F11", GLFW_KEY_F11},
    {"LeftBracket", GLFW_KEY_LEFT_BRACKET}, {"RightBracket", GLFW_KEY_RIGHT_BRACKET}, {"Apostrophe", GLFW_KEY_APOSTROPHE},
}};

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

int keyCode(std::string_view name) {
  if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])) != 0) return std::toupper(static_cast<unsigned char>(name[0]));
  for (const NamedKey& key : kKeys)
    if (lower(key.name) == lower(name)) return key.code;
  return 0;
}

}  // namespace

Expected<KeyStroke> parseKeyStroke(std::string_view text) {
  KeyStroke out;
  for (const std::string_view part : splitAt(trimmed(text), '+')) {
    const std::string word = lower(trimmed(part));
    if (word == "ctrl") out.ctrl = true;
    else if (word == "shift") out.shift = true;
    else if (word == "alt") out.alt = true;
    else if (out.code == 0 && keyCode(word) != 0) out.code = keyCode(word);
    else {
      const auto names = namesOf(kKeys, &NamedKey::name);
      const auto near = nearest(part, names);
      return fail(ErrorKind::input, "there is no key \"" + printable(part) + "\".", near ? "Did you mean " + std::string(*near) + "?" : "Letters, digits, " + listed(names) + ", with ctrl, shift and alt.");
    }
  }
  if (out.code == 0) return fail(ErrorKind::input, "\"" + printable(text) + "\" names no key.", "Write for example ctrl+S or KP8.");
  return out;
}

std::string keyText(const KeyStroke& stroke) {
  std::string out = std::string(stroke.ctrl ? "Ctrl+" : "") + (stroke.shift ? "Shift+" : "") + (stroke.alt ? "Alt+" : "");
  for (const NamedKey& key : kKeys)
    if (key.code == stroke.code) return out + std::string(key.name);
  return out + static_cast<char>(stroke.code);
}

}  // namespace npsee::editor
