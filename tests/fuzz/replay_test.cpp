#include "tests/fuzz/targets.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace npsee {
namespace {

int replay(const std::string& folder, void (*target)(std::string_view)) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(NPSEE_SOURCE_DIR) + "/" + folder)) {
    if (!entry.is_regular_file()) continue;
    SCOPED_TRACE(entry.path().string());
    target(test::slurp(entry.path().string()));
    ++count;
  }
  return count;
}

// A broken promise aborts: the fuzz targets say which.
TEST(FuzzReplay, PresetFilesThatOnceBrokeAPromiseKeepIt) { EXPECT_GT(replay("tests/fuzz/corpus/preset", fuzz::presetFile), 0); }
TEST(FuzzReplay, SettingsThatOnceBrokeAPromiseKeepIt) { EXPECT_GT(replay("tests/fuzz/corpus/setting", fuzz::settings), 0); }
TEST(FuzzReplay, ShippedPresetsKeepThePromisesOfAnyFile) { EXPECT_GT(replay("presets", fuzz::presetFile), 0); }

}  // namespace
}  // namespace npsee
