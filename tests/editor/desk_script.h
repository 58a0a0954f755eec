#pragma once

#include "tests/editor/editor_script.h"

#include <map>

namespace npsee::test {

/// Scripted sessions that remember things, in folders of their own.
class DeskScript : public EditorScript {
 protected:
  std::map<std::string, std::string> environment() const { return {{"XDG_CONFIG_HOME", folder_ / "config"}, {"XDG_STATE_HOME", folder_ / "state"}, {"XDG_CACHE_HOME", folder_ / "cache"}}; }
  std::vector<std::string> arguments(const std::string& script, const std::string& file) {
    spill(folder_ / "script.txt", script);
    std::vector<std::string> out{"edit"};
    if (!file.empty()) out.push_back(file);
    out.insert(out.end(), {"--headless", "--remember", "--script", folder_ / "script.txt"});
    return out;
  }
  ProcessResult start(const std::string& script, const std::string& file) { return npseeRun(arguments(script, file), environment()); }
  void remembers(const std::string& script, const std::string& file = "") {
    const auto result = start(script, file);
    EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  }
};

}  // namespace npsee::test
