#include "app/commands/render_caption.h"

#include "app/commands/render_output.h"
#include "sim/core/text.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace npsee::commands {
namespace {

/// Calls `text` and `placeholder` with the parts of the pattern in order. A brace that nothing closes is text.
void walk(const std::string& pattern, const std::function<void(std::string_view)>& text, const std::function<void(std::string_view)>& placeholder) {
  std::string_view rest = pattern;
  while (!rest.empty()) {
    const std::size_t open = rest.find('{'), close = rest.find('}', open == std::string_view::npos ? 0 : open);
    if (open == std::string_view::npos || close == std::string_view::npos) return text(rest);
    text(rest.substr(0, open));
    placeholder(rest.substr(open + 1, close - open - 1));
    rest.remove_prefix(close + 1);
  }
}

}  // namespace

Expected<void> checkCaption(const std::string& pattern) {
  const std::vector<std::string_view> known{"time", "frame", "seed", "title", "name"};
  std::optional<std::string> wrong;
  walk(pattern, [](std::string_view) {}, [&](std::string_view word) {
    if (std::find(known.begin(), known.end(), word) == known.end()) wrong = word;
  });
  if (!wrong) return {};
  const auto near = nearest(*wrong, known);
  return fail(ErrorKind::usage, "--caption: there is no {" + *wrong + "}." + (near ? " Did you mean {" + std::string(*near) + "}?" : std::string()), "A caption may hold {time}, {frame}, {seed}, {title} and {name}; none leaves it out.");
}

std::string captionOf(const std::string& pattern, const Preset& preset, const std::string& file, const Shot& shot) {
  std::string out;
  walk(pattern, [&](std::string_view text) { out += text; }, [&](std::string_view word) {
    if (word == "time") out += withDecimals(shot.time_s, 2);
    else if (word == "frame") out += std::to_string(shot.number);
    else if (word == "seed") out += std::to_string(preset.seed);
    else if (word == "title") out += preset.title.empty() ? presetName(file) : preset.title;
    else if (word == "name") out += presetName(file);
  });
  return out;
}

}  // namespace npsee::commands
