#include "app/commands/render_output.h"

#include "sim/core/files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <set>
#include <system_error>

#include <unistd.h>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

struct Pattern {
  std::size_t at, size;
  int digits;
};

/// Finds %d or %0Nd; `size` 0 if there is none. False if there is another or a second percent sign.
bool findPattern(std::string_view name, Pattern& out) {
  out = {name.size(), 0, 4};
  const std::size_t percent = name.find('%');
  if (percent == std::string_view::npos) return true;
  std::size_t at = percent + 1;
  int digits = 0;
  while (at < name.size() && std::isdigit(static_cast<unsigned char>(name[at])) != 0 && digits < 100) digits = 10 * digits + (name[at++] - '0');
  if (at >= name.size() || name[at] != 'd' || digits > 12 || name.find('%', at) != std::string_view::npos) return false;
  out = {percent, at + 1 - percent, std::max(digits, 1)};
  return true;
}

Expected<void> checkFolder(const fs::path& folder, const std::string& output) {
  const auto refuse = [&](const std::string& why) {
    return fail(ErrorKind::output, {.what = "cannot be written: " + why + ".", .remedy = "Make the folder first, or choose another place; nothing was changed.", .file = output, .line = 0, .pointer = {}});
  };
  std::error_code ignored;
  const fs::path place = folder.empty() ? fs::path(".") : folder;
  if (!fs::exists(place, ignored)) return refuse("the folder " + place.string() + " does not exist");
  if (!fs::is_directory(place, ignored)) return refuse(place.string() + " is not a folder");
  if (::access(place.c_str(), W_OK | X_OK) != 0) return refuse("the folder " + place.string() + ": " + std::strerror(errno));
  return {};
}

}  // namespace

std::string presetName(const std::string& file) {
  std::string name = fs::path(file).filename().string();
  for (const std::string_view ending : {".npsee.json", ".json"})
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return name;
}

Expected<OutputNames> OutputNames::make(const std::string& output, const std::vector<std::string>& presets, bool sequence, const std::string& ending) {
  OutputNames out;
  out.numbered_ = sequence;
  std::error_code ignored;
  const fs::path path(output);
  const bool folder = output.ends_with('/') || fs::is_directory(path, ignored);
  if (folder || presets.size() > 1) {
    if (!folder)
      return fail(ErrorKind::usage, "-o " + output + ": several presets need a folder to be written to.", "Name a folder, with a / at its end if it is to be made.");
    // "out/" has the parent "out", whose parent is where it stands.
    const bool missing = !fs::exists(path, ignored);
    if (auto checked = checkFolder(missing ? path.parent_path().parent_path() : path, output); !checked) return tl::unexpected<Error>(checked.error());
    auto names = inFolder(path, presets, sequence, ending);
    if (names && missing) names->missing_ = path.parent_path();
    return names;
  }
  if (!isSpecialFile(path))
    if (auto checked = checkFolder(path.parent_path(), output); !checked) return tl::unexpected<Error>(checked.error());
  const std::string name = path.filename().string();
  if (!sequence) {
    out.names_.push_back({path.parent_path(), name, ""});
    return out;
  }
  Pattern pattern{};
  if (!findPattern(name, pattern)) return fail(ErrorKind::usage, "-o " + output + ": the frame number's place cannot be read.", "Write it once, as %d or %04d; other percent signs cannot stand in a sequence's name.");
  if (pattern.size > 0) {
    out.digits_ = pattern.digits;
    out.names_.push_back({path.parent_path(), name.substr(0, pattern.at), name.substr(pattern.at + pattern.size)});
  } else if (isSpecialFile(path)) {
    out.numbered_ = false;
    out.names_.push_back({path.parent_path(), name, ""});
  } else {
    out.names_.push_back({path.parent_path(), path.stem().string() + '_', path.has_extension() ? path.extension().string() : ending});
  }
  return out;
}

Expected<OutputNames> OutputNames::inFolder(const fs::path& folder, const std::vector<std::string>& presets, bool sequence, const std::string& ending) {
  OutputNames out;
  out.numbered_ = sequence;
  std::set<std::string> seen;
  for (const std::string& preset : presets) {
    const std::string name = presetName(preset);
    if (!seen.insert(name).second)
      return fail(ErrorKind::usage, "two of the presets are called " + name + ", and their pictures would overwrite each other.", "Render them one by one with a name of their own.");
    out.names_.push_back({folder, sequence ? name + '_' : name, ending});
  }
  return out;
}

Expected<void> checkPlace(const fs::path& file) { return isSpecialFile(file) ? Expected<void>() : checkFolder(file.parent_path(), file.string()); }

Expected<void> OutputNames::makeFolder() const {
  std::error_code failed;
  if (!missing_.empty() && !fs::create_directory(missing_, failed) && failed) return cannotWrite(missing_, failed.message());
  return {};
}

std::filesystem::path OutputNames::path(std::size_t index, std::int64_t number) const {
  const Name& name = names_.at(index);
  if (!numbered_) return name.folder / (name.before + name.after);
  std::string digits = std::to_string(number);
  if (digits.size() < static_cast<std::size_t>(digits_)) digits.insert(0, static_cast<std::size_t>(digits_) - digits.size(), '0');
  return name.folder / (name.before + digits + name.after);
}

}  // namespace npsee::commands
