#include "sim/core/file_kind.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <system_error>

namespace npsee {
namespace {

struct Row {
  FileKind kind;
  std::string_view key, name, taken_by;
};
constexpr std::array kRows{Row{FileKind::recording, "npsee_recording", "a recording of a mission", "`npsee replay FILE` shows recordings."},
                           Row{FileKind::mission, "npsee_mission", "a fire mission", "`npsee mission FILE` flies missions, `npsee edit FILE` opens them."},
                           Row{FileKind::projectile, "npsee_projectile", "a projectile", "`npsee fly --projectile FILE` flies projectiles."},
                           Row{FileKind::preset, "npsee", "an explosion preset", "`npsee render FILE` draws presets, `npsee edit FILE` opens them."}};

/// Calls `take(key)` for the keys of the text's first object, not for those of objects inside it, until one is taken or the object ends.
template <class Take>
void forKeys(std::string_view text, const Take& take) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{' || text[i] == '[') ++depth;
    if ((text[i] == '}' || text[i] == ']') && --depth == 0) return;
    if (text[i] != '"') continue;
    const std::size_t begin = ++i;
    while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
    const std::size_t next = text.find_first_not_of(" \t\r\n", std::min(i + 1, text.size()));
    if (depth == 1 && next != std::string_view::npos && text[next] == ':' && take(text.substr(begin, i - begin))) return;
  }
}

std::string_view nameOf(FileKind kind) {
  for (const Row& row : kRows)
    if (row.kind == kind) return row.name;
  return "a file of npsee";
}

}  // namespace

FileKind fileKindOf(std::string_view text) {
  FileKind kind = FileKind::other;
  forKeys(text, [&](std::string_view key) {
    const auto row = std::ranges::find(kRows, key, &Row::key);
    if (row != kRows.end()) kind = row->kind;
    // Missions of the older format have no key of their own.
    else if (key == "format" && text.find("\"npsnet-scenario/") != std::string_view::npos) kind = FileKind::mission;
    return kind != FileKind::other;
  });
  return kind;
}

FileKind fileKindAt(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return FileKind::other;
  std::string head(65536, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return fileKindOf(head);
}

std::optional<Fault> otherKind(std::string_view text, std::string_view file, FileKind wanted) {
  const FileKind kind = fileKindOf(text);
  if (kind == wanted) return std::nullopt;
  for (const Row& row : kRows)
    if (row.kind == kind) return Fault{.what = "is " + std::string(row.name) + ", not " + std::string(nameOf(wanted)) + ".", .remedy = std::string(row.taken_by), .file = std::string(file), .line = 0, .pointer = {}};
  return std::nullopt;
}

}  // namespace npsee
