#include "tests/support/display.h"
#include "tests/support/process.h"
#include "tests/support/small_mission.h"

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

/// Polls until `done` holds; false after a minute, which even a very busy machine does not need.
bool eventually(const std::function<bool()>& done) {
  for (const auto end = std::chrono::steady_clock::now() + 60s; std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(20ms))
    if (done()) return true;
  return false;
}

/// The real window on a display of its own, driven by xdotool. What it shows is where the same editor without a window says.
class EditorWindow : public testing::Test {
 protected:
  /// Opens `file_`, which is called `name`, at a moment.
  void open(const std::string& name, const std::string& time) {
    test::spill(folder_ / "items.txt", "print items\n");
    const std::vector<std::string> shared{"edit", file_, "--time", time, "--size", "1200x760"};
    const auto with = [&shared](std::initializer_list<std::string> more) {
      std::vector<std::string> out = shared;
      out.insert(out.end(), more);
      return out;
    };
    const auto listed = test::npseeRun(with({"--headless", "--script", folder_ / "items.txt"}));
    std::istringstream lines(listed.out);
    for (std::string state, place, item; lines >> state >> place && std::getline(lines >> std::ws, item);) places_[item] = place;
    ASSERT_TRUE(places_.contains("thumb:time")) << listed.err << listed.out;
    ended_ = std::async(std::launch::async, [this, arguments = with({"--print-state"})] { return test::npseeRun(arguments, environment()); });
    ASSERT_TRUE(eventually([&] { return window(name + " - npsee"); })) << (ended_.wait_for(0s) == std::future_status::ready ? ended_.get().err : "no window");
    display_.xdotool({"windowfocus", "--sync", window_});
  }
  /// The display, and folders of our own for what the editor remembers.
  std::map<std::string, std::string> environment() const {
    auto out = display_.environment();
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"}) out[name] = folder_ / name;
    return out;
  }
  /// Finds the window by its title, which shows what the editor has made of the input.
  bool window(const std::string& title) {
    const auto found = test::run("/usr/bin/env", {"xdotool", "search", "--name", '^' + title + '$'}, display_.environment());
    if (found.exit_code == 0) window_ = found.out.substr(0, found.out.find('\n'));
    return found.exit_code == 0;
  }
  // Nothing waits between events: the editor must not lose what is shorter than a frame.
  void point(const std::string& item, int dx = 0, int dy = 0) {
    const std::string& place = places_.at(item);
    const std::size_t comma = place.find(',');
    display_.xdotool({"mousemove", "--window", window_, std::to_string(std::stoi(place.substr(0, comma)) + dx), std::to_string(std::stoi(place.substr(comma + 1)) + dy)});
  }
  void drag(const std::string& item, int dx, int dy = 0) {
    point(item);
    display_.xdotool({"mousedown", "1"});
    for (int i = 1; i <= 4; ++i) point(item, dx * i / 4, dy * i / 4);
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
  std::map<std::string, std::string> state() {
    EXPECT_TRUE(ended_.wait_for(60s) == std::future_status::ready) << "the window is still open";
    const auto result = ended_.get();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::map<std::string, std::string> out;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);)
      if (const std::size_t at = line.find('='); at != std::string::npos) out[line.substr(0, at)] = line.substr(at + 1);
    return out;
  }

  test::TemporaryFolder folder_;
  std::string file_;
  test::VirtualDisplay display_;
  std::map<std::string, std::string> places_;
  std::future<test::ProcessResult> ended_;
  std::string window_;
};

class PresetWindow : public EditorWindow {
 protected:
  void SetUp() override {
    file_ = folder_ / "work.npsee.json";
    std::filesystem::copy_file(std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json", file_);
    open("work", "0.8");
  }
};

class MissionWindow : public EditorWindow {
 protected:
  void SetUp() override {
    file_ = folder_ / "small.mission.json";
    ASSERT_TRUE(saveScenario(test::smallMission(), file_).has_value());
    open("small", "5");
  }
};

double number(const std::map<std::string, std::string>& state, const std::string& name) { return std::strtod(state.at(name).c_str(), nullptr); }

TEST_F(PresetWindow, IsDrivenByMouseAndKeyboardSavesAndCloses) {
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
  EXPECT_EQ(number(end, "undo"), 0.0);
  EXPECT_EQ(number(end, "window.width"), 1000.0);
  EXPECT_EQ(number(end, "window.height"), 640.0);
  EXPECT_EQ(loadPreset(file_)->layers[0], Layer(loadPreset(std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json")->layers[0]));
}

TEST_F(PresetWindow, ClosingItAsksAboutUnsavedWork) {
  drag("thumb:fragments.ejection_angle", -30);
  EXPECT_TRUE(eventually([this] { return window("work \\* - npsee"); }));
  display_.askToClose(window_);
  EXPECT_NE(ended_.wait_for(500ms), std::future_status::ready) << "unsaved work is asked about";
  key("Control_L+s");
  EXPECT_TRUE(eventually([this] { return window("work - npsee"); }));
  display_.askToClose(window_);
  EXPECT_EQ(number(state(), "undo"), 1.0);
}

TEST_F(PresetWindow, ItsCrossSpeaksAfterWhatWasTypedBefore) {
  drag("thumb:fragments.ejection_angle", -30);
  key("Control_L+s");
  for (int i = 0; i < 20; ++i) key("Home");
  display_.askToClose(window_);
  const auto end = state();
  EXPECT_EQ(number(end, "undo"), 1.0);
  EXPECT_EQ(end.at("dirty"), "no");
  EXPECT_LT(loadPreset(file_)->layers[0].ejection_angle_rad, 0.85) << "saved before it closed";
}

TEST_F(PresetWindow, CopiesACommandLineToTheClipboard) {
  key("Control_L+space");  // nothing: keys with other modifiers are others
  display_.xdotool({"keydown", "Control_L", "keydown", "Shift_L"});
  display_.xdotool({"key", "e"});
  display_.xdotool({"keyup", "Shift_L", "keyup", "Control_L"});
  key("Control_L+q");
  const auto end = state();
  EXPECT_NE(end.at("clipboard").find("npsee render " + file_), std::string::npos) << end.at("clipboard") << end.at("error");
}

TEST_F(PresetWindow, AFileDroppedOnItIsOpened) {
  const std::string other = folder_ / "dropped one.npsee.json";
  std::filesystem::copy_file(std::string(NPSEE_SOURCE_DIR) + "/presets/mortar.npsee.json", other);
  const auto dropped = display_.client({"drop", window_, other});
  ASSERT_EQ(dropped.exit_code, 0) << dropped.err;
  EXPECT_TRUE(eventually([this] { return window("dropped one - npsee"); }));
  key("Control_L+q");
  const auto end = state();
  EXPECT_EQ(end.at("file"), other);
  EXPECT_EQ(end.at("error"), "");
}

TEST_F(PresetWindow, WhatIsNoPresetIsRefusedWhenItIsDropped) {
  test::spill(folder_ / "notes.txt", "nothing");
  const auto dropped = display_.client({"drop", window_, folder_ / "notes.txt", file_});
  ASSERT_EQ(dropped.exit_code, 0) << dropped.err;
  key("Control_L+q");
  const auto end = state();
  EXPECT_NE(end.at("error").find("notes.txt is neither a preset nor a mission"), std::string::npos) << end.at("error");
  EXPECT_EQ(end.at("file"), file_);
}

TEST_F(PresetWindow, LayersGoThroughTheClipboardToOtherProgramsAndBack) {
  key("Control_L+c");
  std::string text;
  EXPECT_TRUE(eventually([&] {
    const auto held = display_.client({"clipboard"});
    text = held.out;
    return held.exit_code == 0 && !text.empty();
  }));
  EXPECT_NE(text.find("\"fragments\""), std::string::npos) << text;
  // Another program changes it and holds it now.
  text.replace(text.find("fragments"), 9, "from_afar");
  auto other = std::async(std::launch::async, [&] { return display_.client({"offer", text}); });
  EXPECT_TRUE(eventually([&] {
    key("Control_L+v");
    return other.wait_for(300ms) == std::future_status::ready;
  }));
  const auto given = other.get();
  EXPECT_EQ(given.exit_code, 0) << given.err;
  EXPECT_TRUE(eventually([this] { return window("work \\* - npsee"); }));
  key("Control_L+s");
  EXPECT_TRUE(eventually([this] { return window("work - npsee"); }));
  key("Control_L+q");
  state();
  const auto saved = loadPreset(file_);
  ASSERT_TRUE(saved.has_value());
  EXPECT_GE(findLayer(*saved, "from_afar"), 0) << presetText(*saved);
}

TEST_F(PresetWindow, AClickCountsThoughThePointerHasLeftBeforeTheNextFrame) {
  constexpr int kClicks = 5;
  for (int i = 0; i < kClicks; ++i) {
    point("button:step on");
    // All in one call: the window hears of it at once.
    display_.xdotool({"mousedown", "1", "mouseup", "1", "mousemove", "1279", "799"});
  }
  key("Control_L+q");
  EXPECT_NEAR(number(state(), "time"), 0.8 + kClicks / 60.0, 1e-6) << "a step each";
}

TEST_F(PresetWindow, AShortcutCountsThoughItsModifierIsReleasedFirst) {
  // All in one call, and parted by a click, so that the key and what follows it come in a frame of their own.
  display_.xdotool({"mousedown", "2", "keydown", "--delay", "0", "Control_L", "mouseup", "2", "keydown", "--delay", "0", "q", "keyup", "--delay", "0", "Control_L", "keyup", "--delay", "0", "q"});
  EXPECT_EQ(state().at("dirty"), "no");
}

TEST_F(PresetWindow, TextIsTakenInTheOrderItIsTyped) {
  display_.xdotool({"key", "--delay", "0", "ctrl+p", "q", "u", "x", "BackSpace", "i", "t", "Return"});
  EXPECT_EQ(state().at("dirty"), "no");
}

TEST_F(PresetWindow, RemembersItsSize) {
  display_.xdotool({"windowsize", "--sync", window_, "1010", "650"});
  key("Control_L+q");
  state();
  const std::string settings = test::slurp(folder_ / "XDG_CONFIG_HOME/npsee/settings.json");
  EXPECT_NE(settings.find("\"window_width\": 1010"), std::string::npos) << settings;
}

TEST_F(PresetWindow, ThesisKeysMoveTheCamera) {
  test::spill(folder_ / "camera.txt", "print all\n");
  const auto before = test::npseeRun({"edit", file_, "--headless", "--time", "0.8", "--size", "1200x760", "--script", folder_ / "camera.txt"}).out;
  const auto value = [&](const std::string& name) { return std::strtod(before.c_str() + before.find('\n' + name + '=') + name.size() + 2, nullptr); };
  key("Home");
  key("KP_8");
  key("Left");
  click("button:step on");
  key("Control_L+q");
  const auto end = state();
  EXPECT_GT(number(end, "eye.y"), value("eye.y"));
  EXPECT_GT(number(end, "target.y"), value("target.y"));
  EXPECT_GT(number(end, "eye.x"), std::strtod(before.c_str() + before.find("eye.x=") + 6, nullptr));
  EXPECT_EQ(number(end, "eye.z"), value("eye.z"));
  EXPECT_GT(number(end, "time"), 0.8);
}

TEST_F(MissionWindow, PlaysIsScrubbedAndDraggedInSavesAndCloses) {
  click("button:play");
  std::this_thread::sleep_for(300ms);
  key("space");
  // The plan shows the tank as soon as the simulation has begun.
  int drags = 0;
  EXPECT_TRUE(eventually([&] {
    drag("plan:t72-1", -20, 10);
    ++drags;
    return window("small \\* - npsee");
  }));
  key("Control_L+s");
  EXPECT_TRUE(eventually([this] { return window("small - npsee"); }));
  const auto saved = loadScenario(file_);
  ASSERT_TRUE(saved.has_value()) << saved.error().text();
  EXPECT_LT(saved->vehicles[0].at.x_m, 7000.0);
  EXPECT_GT(saved->vehicles[0].at.z_m, 5000.0);
  click("observer:fo1");
  key("5");
  drag("thumb:time", 200);
  key("Control_L+q");
  const auto end = state();
  EXPECT_EQ(end.at("mode"), "mission");
  EXPECT_EQ(end.at("selected"), "fo1");
  EXPECT_EQ(end.at("camera"), "observer");
  EXPECT_EQ(end.at("playing"), "no");
  EXPECT_EQ(end.at("error"), "");
  // On a busy machine the title may follow a drag after the next one has begun.
  EXPECT_GE(number(end, "undo"), 1.0);
  EXPECT_LE(number(end, "undo"), drags);
  EXPECT_GT(number(end, "time"), 5.0 + 10.0) << "200 of about 700 pixels of two minutes";
}

TEST_F(MissionWindow, TimePassesWhileItPlays) {
  key("space");
  // Long enough for some frames between the two keys on a busy machine too.
  std::this_thread::sleep_for(2s);
  key("Control_L+q");
  const auto end = state();
  EXPECT_GT(number(end, "time"), 5.0);
  EXPECT_EQ(end.at("playing"), "yes");
}

}  // namespace
}  // namespace npsee
