#include "tests/support/display.h"
#include "tests/support/process.h"

#include <npsee/preset.h>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <sstream>
#include <thread>

namespace npsee {
namespace {

using namespace std::chrono_literals;

/// Polls until `done` holds; false after ten seconds.
bool eventually(const std::function<bool()>& done) {
  for (const auto end = std::chrono::steady_clock::now() + 10s; std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(20ms))
    if (done()) return true;
  return false;
}

/// The real window on a display of its own, driven by xdotool. What it shows is where the same editor without a window says.
class EditorWindow : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::copy_file(std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json", file_);
    test::spill(folder_ / "items.txt", "print items\n");
    const auto listed = test::npseeRun({"edit", file_, "--headless", "--time", "0.8", "--size", "1200x760", "--script", folder_ / "items.txt"});
    std::istringstream lines(listed.out);
    for (std::string state, place, name; lines >> state >> place && std::getline(lines >> std::ws, name);) places_[name] = place;
    ASSERT_TRUE(places_.contains("thumb:fragments.ejection_angle")) << listed.err << listed.out;
    ended_ = std::async(std::launch::async, [this] { return test::npseeRun({"edit", file_, "--time", "0.8", "--size", "1200x760", "--print-state"}, display_.environment()); });
    ASSERT_TRUE(eventually([this] { return window("work - npsee"); })) << (ended_.wait_for(0s) == std::future_status::ready ? ended_.get().err : "no window");
    display_.xdotool({"windowfocus", "--sync", window_});
  }
  /// Finds the window by its title, which shows what the editor has made of the input.
  bool window(const std::string& title) {
    const auto found = test::run("/usr/bin/env", {"xdotool", "search", "--name", '^' + title + '$'}, display_.environment());
    if (found.exit_code == 0) window_ = found.out.substr(0, found.out.find('\n'));
    return found.exit_code == 0;
  }
  // Nothing waits between events: the editor must not lose what is shorter than a frame.
  void point(const std::string& item, int dx = 0) {
    const std::string& place = places_.at(item);
    const std::size_t comma = place.find(',');
    display_.xdotool({"mousemove", "--window", window_, std::to_string(std::stoi(place.substr(0, comma)) + dx), place.substr(comma + 1)});
  }
  void drag(const std::string& item, int dx) {
    point(item);
    display_.xdotool({"mousedown", "1"});
    for (int i = 1; i <= 4; ++i) point(item, dx * i / 4);
    display_.xdotool({"mouseup", "1"});
  }
  void click(const std::string& item) {
    point(item);
    display_.xdotool({"mousedown", "1"});
    display_.xdotool({"mouseup", "1"});
  }
  void key(const std::string& name) {
    const std::size_t plus = name.rfind('+');
    if (plus != std::string::npos) display_.xdotool({"keydown", name.substr(0, plus)});
    display_.xdotool({"key", name.substr(plus + 1)});
    if (plus != std::string::npos) display_.xdotool({"keyup", name.substr(0, plus)});
  }
  /// What the editor printed when it ended, by name.
  std::map<std::string, double> state() {
    EXPECT_TRUE(ended_.wait_for(30s) == std::future_status::ready) << "the window is still open";
    const auto result = ended_.get();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::map<std::string, double> out;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);)
      if (const std::size_t at = line.find('='); at != std::string::npos) out[line.substr(0, at)] = std::strtod(line.c_str() + at + 1, nullptr);
    return out;
  }

  test::TemporaryFolder folder_;
  std::string file_ = folder_ / "work.npsee.json";
  test::VirtualDisplay display_;
  std::map<std::string, std::string> places_;
  std::future<test::ProcessResult> ended_;
  std::string window_;
};

TEST_F(EditorWindow, IsDrivenByMouseAndKeyboardSavesAndCloses) {
  drag("thumb:fragments.ejection_angle", -30);
  EXPECT_TRUE(eventually([this] { return window("work \\* - npsee"); })) << "the drag marks the document";
  key("Control_L+s");
  EXPECT_TRUE(eventually([this] { return window("work - npsee"); })) << "saving clears the mark";
  const auto saved = loadPreset(file_);
  ASSERT_TRUE(saved.has_value());
  EXPECT_LT(saved->layers[0].ejection_angle_rad, 0.85);
  display_.xdotool({"windowsize", "--sync", window_, "1000", "640"});
  key("Control_L+z");
  EXPECT_TRUE(eventually([this] { return window("work \\* - npsee"); })) << "undo is not what the file holds";
  key("Control_L+q");
  EXPECT_NE(ended_.wait_for(500ms), std::future_status::ready) << "unsaved work is asked about";
  key("Control_L+s");
  EXPECT_TRUE(eventually([this] { return window("work - npsee"); }));
  key("Control_L+q");
  const auto end = state();
  EXPECT_EQ(end.at("undo"), 0.0);
  EXPECT_EQ(end.at("window.width"), 1000.0);
  EXPECT_EQ(end.at("window.height"), 640.0);
  EXPECT_EQ(loadPreset(file_)->layers[0], Layer(loadPreset(std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json")->layers[0]));
}

TEST_F(EditorWindow, ClosingItAsksAboutUnsavedWork) {
  drag("thumb:fragments.ejection_angle", -30);
  EXPECT_TRUE(eventually([this] { return window("work \\* - npsee"); }));
  display_.askToClose(window_);
  EXPECT_NE(ended_.wait_for(500ms), std::future_status::ready) << "unsaved work is asked about";
  key("Control_L+s");
  EXPECT_TRUE(eventually([this] { return window("work - npsee"); }));
  display_.askToClose(window_);
  EXPECT_EQ(state().at("undo"), 1.0);
}

TEST_F(EditorWindow, ThesisKeysMoveTheCamera) {
  test::spill(folder_ / "camera.txt", "print all\n");
  const auto before = test::npseeRun({"edit", file_, "--headless", "--time", "0.8", "--size", "1200x760", "--script", folder_ / "camera.txt"}).out;
  const auto value = [&](const std::string& name) { return std::strtod(before.c_str() + before.find('\n' + name + '=') + name.size() + 2, nullptr); };
  key("Home");
  key("KP_8");
  key("Left");
  click("button:step on");
  key("Control_L+q");
  const auto end = state();
  EXPECT_GT(end.at("eye.y"), value("eye.y"));
  EXPECT_GT(end.at("target.y"), value("target.y"));
  EXPECT_GT(end.at("eye.x"), std::strtod(before.c_str() + before.find("eye.x=") + 6, nullptr));
  EXPECT_EQ(end.at("eye.z"), value("eye.z"));
  EXPECT_GT(end.at("time"), 0.8);
}

}  // namespace
}  // namespace npsee
