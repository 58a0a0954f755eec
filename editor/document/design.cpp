#include "editor/document/design.h"

namespace npsee::editor {

void Design::rename(const std::string& from, const std::string& to) {
  if (solo.erase(from) > 0) solo.insert(to);
  std::set<std::string> kept;
  for (const std::string& name : locked) kept.insert(name.starts_with(from + '.') ? to + name.substr(from.size()) : name);
  locked = std::move(kept);
}

}  // namespace npsee::editor
