// What is drawn of the editor's window, how finely, and how little of it anew.

#include "app/render/image_compare.h"
#include "editor/document/quality_chooser.h"
#include "editor/ui/damage.h"
#include "tests/editor/desk_script.h"
#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <functional>
#include <map>
#include <sstream>

namespace npsee {
namespace {

using editor::DrawnQuality;
using editor::QualityChooser;
using render::Quality;
using test::DeskScript;
using test::EditorScript;

constexpr DrawnQuality kNormal{Quality::normal, 1.0}, kDraft{Quality::draft, 1.0};

/// Plays for so long; a frame takes what `cost_s` says of its quality and of the time. Returns how often the quality changed.
int play(QualityChooser& chooser, double seconds, const std::function<double(const DrawnQuality&, double)>& cost_s, double* slowest_s = nullptr) {
  int changes = 0;
  double last_s = 0.02;
  for (double t = 0.0; t < seconds; t += last_s) {
    const DrawnQuality before = chooser.drawn();
    if (chooser.choose("automatic", true, last_s) != before) ++changes;
    last_s = std::max(cost_s(chooser.drawn(), t), 1.0 / 60.0);
    if (slowest_s != nullptr && t > 0.5 * seconds) *slowest_s = std::max(*slowest_s, last_s);
  }
  return changes;
}

/// A machine on which a whole picture takes so long, and coarser ones in proportion to their work.
std::function<double(const DrawnQuality&, double)> machine(double normal_s) {
  return [normal_s](const DrawnQuality& drawn, double) { return normal_s * drawn.share * drawn.share * (drawn.quality == Quality::draft ? 0.35 : 1.0); };
}

TEST(QualityChooser, KeepsTheFinestQualityThatIsQuickEnough) {
  for (const auto& [normal_s, level] : {std::pair(0.010, 0), std::pair(0.045, 0), std::pair(0.090, 1), std::pair(0.200, 2)}) {
    QualityChooser chooser;
    double slowest_s = 0.0;
    const int changes = play(chooser, 60.0, machine(normal_s), &slowest_s);
    EXPECT_EQ(chooser.drawn(), QualityChooser::kLevels.at(static_cast<std::size_t>(level))) << normal_s;
    EXPECT_EQ(changes, level) << "straight there, and no flicker, at " << normal_s;
    EXPECT_LE(slowest_s, 0.050);
  }
}

TEST(QualityChooser, ALoopThatIsHeavyAtItsStartDoesNotFlickerForEver) {
  QualityChooser chooser;
  const auto loop = [](const DrawnQuality& drawn, double t) { return machine(std::fmod(t, 4.0) < 1.5 ? 0.150 : 0.015)(drawn, t); };
  play(chooser, 120.0, loop);
  EXPECT_LE(play(chooser, 60.0, loop), 4) << "fifteen loops";
}

TEST(QualityChooser, BecomesFinerAgainWhenTheLoadIsGone) {
  QualityChooser chooser;
  play(chooser, 10.0, machine(0.5));
  EXPECT_EQ(chooser.drawn(), QualityChooser::kLevels.back());
  play(chooser, 10.0, machine(0.012));
  EXPECT_EQ(chooser.drawn(), kNormal);
}

TEST(QualityChooser, WhatStandsStillIsWholeAndWhatMovesAgainIsAsQuickAsBefore) {
  QualityChooser chooser;
  play(chooser, 5.0, machine(0.090));
  EXPECT_EQ(chooser.drawn(), kDraft);
  EXPECT_EQ(chooser.choose("automatic", false, 0.02), kDraft) << "held between two movements";
  for (int i = 0; i < 20; ++i) chooser.choose("automatic", false, 0.05);
  EXPECT_EQ(chooser.drawn(), kNormal);
  EXPECT_EQ(chooser.choose("automatic", true, 0.02), kDraft);
}

TEST(QualityChooser, KeepsToWhatIsWished) {
  QualityChooser chooser;
  EXPECT_EQ(chooser.choose("draft", false, 1.0), kDraft);
  EXPECT_EQ(chooser.choose("normal", true, 1.0), kNormal);
  for (int i = 0; i < 20; ++i) chooser.choose("fine", false, 0.05);
  EXPECT_EQ(chooser.drawn().quality, Quality::fine);
  EXPECT_EQ(chooser.choose("fine", true, 0.05).quality, Quality::normal) << "sixteen pictures a frame could not be worked with";
}

/// Lists drawn by hand in an ImGui context of our own.
class Damages : public testing::Test {
 protected:
  void SetUp() override {
    ImGui::CreateContext();
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  void TearDown() override { ImGui::DestroyContext(); }
  std::vector<editor::PixelBox> find(const std::function<void(ImDrawList&, ImDrawList&)>& draw, std::vector<ImTextureID> redrawn = {}) {
    ImDrawList below(ImGui::GetDrawListSharedData()), above(ImGui::GetDrawListSharedData());
    for (ImDrawList* list : {&below, &above}) {
      list->_ResetForNewFrame();
      list->PushTextureID(kFont);
      list->PushClipRect({0, 0}, {800, 600});
    }
    draw(below, above);
    ImDrawList* lists[] = {&below, &above};
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = lists;
    data.CmdListsCount = 2;
    data.DisplaySize = {800, 600};
    data.FramebufferScale = {1, 1};
    return damage_.find(data, redrawn);
  }
  const ImTextureID kFont = reinterpret_cast<ImTextureID>(7), kPicture = reinterpret_cast<ImTextureID>(9);
  editor::Damage damage_;
};

bool covers(const std::vector<editor::PixelBox>& boxes, int x, int y) {
  return std::ranges::any_of(boxes, [&](const editor::PixelBox& box) { return x >= box.left && x < box.right && y >= box.top && y < box.bottom; });
}

TEST_F(Damages, TheFirstFrameIsAllAndTheSameAgainIsNothing) {
  const auto draw = [](ImDrawList& below, ImDrawList& above) {
    below.AddRectFilled({0, 0}, {800, 600}, IM_COL32_WHITE);
    above.AddRectFilled({10, 10}, {30, 30}, IM_COL32_BLACK);
  };
  EXPECT_EQ(find(draw), (std::vector<editor::PixelBox>{{0, 0, 800, 600}}));
  EXPECT_TRUE(find(draw).empty());
}

TEST_F(Damages, OnlyWhatDiffersIsFound) {
  const auto draw = [](float x) {
    return [x](ImDrawList& below, ImDrawList& above) {
      below.AddRectFilled({0, 0}, {800, 600}, IM_COL32_WHITE);
      for (int i = 0; i < 20; ++i) above.AddRectFilled({5.0f + 30.0f * static_cast<float>(i), 10}, {25.0f + 30.0f * static_cast<float>(i), 30}, IM_COL32_BLACK);
      above.AddRectFilled({x, 300}, {x + 10, 310}, IM_COL32_BLACK);
      above.AddRectFilled({700, 500}, {720, 520}, IM_COL32_BLACK);
    };
  };
  find(draw(100));
  const auto boxes = find(draw(140));
  EXPECT_TRUE(covers(boxes, 105, 305)) << "where it was";
  EXPECT_TRUE(covers(boxes, 145, 305)) << "where it is";
  EXPECT_FALSE(covers(boxes, 105, 20));
  EXPECT_FALSE(covers(boxes, 710, 510));
}

TEST_F(Damages, APictureDrawnAnewDamagesItsPlaceAlone) {
  const auto draw = [this](ImDrawList& below, ImDrawList&) {
    below.AddRectFilled({0, 0}, {800, 600}, IM_COL32_WHITE);
    below.AddImage(kPicture, {200, 100}, {400, 300});
  };
  find(draw);
  const auto boxes = find(draw, {kPicture});
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_TRUE(covers(boxes, 300, 200));
  EXPECT_FALSE(covers(boxes, 190, 200));
  EXPECT_TRUE(find(draw).empty());
}

TEST_F(Damages, BoxesDoNotOverlapAndClippedThingsDamageOnlyWhatShows) {
  int step = 0;
  const auto draw = [&](ImDrawList& below, ImDrawList& above) {
    for (int i = 0; i < 60; ++i) {
      const float x = 10.0f + static_cast<float>((i * 137 + step * 31) % 700), y = 10.0f + static_cast<float>((i * 71 + step * 17) % 500);
      (i % 2 == 0 ? below : above).AddRectFilled({x, y}, {x + 20, y + 20}, IM_COL32_BLACK);
    }
    above.PushClipRect({0, 560}, {100, 580});
    above.AddRectFilled({0, 540.0f + static_cast<float>(step % 3)}, {800, 600}, IM_COL32_WHITE);
    above.PopClipRect();
  };
  find(draw);
  for (step = 1; step < 20; ++step) {
    const auto boxes = find(draw);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j) EXPECT_TRUE(editor::intersection(boxes[i], boxes[j]).empty()) << step;
    EXPECT_LE(boxes.size(), 8u);
  }
  find([](ImDrawList&, ImDrawList&) {});
  const auto clipped = find([](ImDrawList&, ImDrawList& above) {
    above.PushClipRect({0, 560}, {100, 580});
    above.AddRectFilled({0, 500}, {800, 600}, IM_COL32_WHITE);
    above.PopClipRect();
  });
  EXPECT_TRUE(covers(clipped, 50, 570));
  EXPECT_FALSE(covers(clipped, 50, 520));
  EXPECT_FALSE(covers(clipped, 300, 570));
}

/// The script with its pictures in a folder.
std::string savedIn(const std::string& folder, const std::string& script) {
  std::string out;
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);) out += (line.starts_with("save ") ? "save " + folder + line.substr(5) : line) + '\n';
  return out;
}

// Menus, hovering, folding, scrolling, typing, sheets, another theme, and an effect that plays in between.
constexpr const char* kBusyScript = R"(wait 3
save 0.png
hover slider:fragments.ejection_angle
save 1.png
click menu:Design
save 2.png
key Escape
set fragments.speed_mean 70
save 3.png
click "section:Launch"
save 4.png
key ctrl+P
type mag
save 5.png
key Escape
click button:play
wait 7
save 6.png
wait 1
save 7.png
click button:play
click menu:View
click "item:Light theme"
key Escape
save 8.png
)";

TEST_F(EditorScript, AWindowDrawnInPartsIsTheWindowDrawnWhole) {
  // One run draws each picture from the one before; the others draw theirs alone.
  const std::string script = savedIn(in(""), kBusyScript);
  passes(script, {"--time", "0.5"});
  for (int wanted = 8; wanted >= 1; --wanted) {
    const std::string name = std::to_string(wanted) + ".png";
    const auto in_parts = picture(name);
    std::string alone;
    std::istringstream lines(script);
    for (std::string line; std::getline(lines, line) && line != "save " + in(name);) alone += (line.starts_with("save ") ? "wait 1" : line) + '\n';
    passes(alone + "save " + in("alone.png") + "\n", {"--time", "0.5"});
    EXPECT_TRUE(picture("alone.png").rgba == in_parts.rgba) << name;
    if (wanted % 3 == 0) --wanted;
  }
}

std::map<std::string, std::string> measured(const test::ProcessResult& result) {
  std::map<std::string, std::string> out;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t at = line.find('='); at != std::string::npos) out[line.substr(0, at)] = line.substr(at + 1);
  return out;
}

TEST_F(EditorScript, NothingIsDrawnAnewWhileNothingChanges) {
  for (const char* state : {"set time 0.5\n", "set time 0.5\nclick menu:Edit\n", "set time 0.5\nkey shift+V\n", "set time 0.5\nkey C\n", "set time 0.5\nclick mode:Mission\n"}) {
    const auto result = run(std::string(state) + "mouse 3 300\nwait 40\n", {"--measure", "0.2"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    auto figures = measured(result);
    EXPECT_NE(figures["frames"], "0") << state;
    EXPECT_EQ(figures["unchanged"], figures["frames"]) << state << result.out;
    EXPECT_EQ(figures["pictures"], "0") << state;
  }
}

TEST_F(EditorScript, OnlyThePictureOfTheExplosionIsDrawnWhileItPlays) {
  const auto result = run("wait 3\n", {"--measure", "0.3"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  auto figures = measured(result);
  EXPECT_GE(std::stoi(figures["frames"]), 1);
  EXPECT_LE(std::stoi(figures["pictures"]), std::stoi(figures["frames"])) << "the template stands still";
  EXPECT_GT(std::stod(figures["explosion_ms"]), 0.0);
  EXPECT_EQ(figures["template_ms"], "0.0");
  EXPECT_GT(std::stod(figures["fps"]), 0.0);
  EXPECT_FALSE(figures["quality"].empty());
}

TEST_F(EditorScript, MeasuringNeedsATimeAndNoWindow) {
  for (const auto& [arguments, message] : {std::pair(std::vector<std::string>{"edit", "--headless", "--measure", "long"}, "--measure long is not a time to measure for."),
                                           std::pair(std::vector<std::string>{"edit", "--headless", "--measure", "5000"}, "Write seconds up to 600"),
                                           std::pair(std::vector<std::string>{"edit", "--measure", "1"}, "Add --headless.")}) {
    const auto result = test::npseeRun(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  }
}

TEST_F(DeskScript, QualityIsChosenByCommandAndRemembered) {
  remembers("click \"button:tour skip\"\nexpect quality = automatic\nexpect drawn = normal\nclick menu:View\nclick \"item:Draft quality\"\nkey Escape\nwait 2\nexpect quality = draft\nexpect drawn = draft\nwait 70\n");
  remembers("expect quality = draft\nclick toggle:view\nclick \"item:Normal quality\"\nkey Escape\nwait 2\nexpect drawn = normal\nkey ctrl+P\ntype fine quality\nkey Enter\nset time 0.5\nwait 30\nexpect drawn = fine\nclick button:play\nwait 3\nexpect drawn = normal\n");
}

TEST_F(EditorScript, QualitiesShowTheSameEffectWithMoreOrLessDetail) {
  passes(savedIn(in(""), "click menu:View\nclick \"item:Draft quality\"\nkey Escape\nwait 2\nsave draft.png\nclick menu:View\nclick \"item:Normal quality\"\nkey Escape\nwait 2\nsave normal.png\n"
         "click menu:View\nclick \"item:Fine quality when still\"\nkey Escape\nwait 30\nsave fine.png\n"),
         {"--time", "0.8"});
  const auto draft = render::deepened(picture("draft.png")), normal = render::deepened(picture("normal.png")), fine = render::deepened(picture("fine.png"));
  for (const auto* other : {&draft, &fine}) {
    const auto difference = render::compareImages(normal, *other);
    EXPECT_GT(difference.max, 8.0) << "another picture";
    EXPECT_LT(difference.mean, 3.0) << "of the same";
  }
}

/// The mean brightness of the viewport's middle.
double brightness(const render::Image& image) {
  double sum = 0.0;
  int count = 0;
  for (int y = image.height / 3; y < image.height / 2; ++y)
    for (int x = 2 * image.width / 5; x < image.width / 2; ++x, ++count) sum += test::brightness(image.pixel(x, y));
  return sum / count;
}

TEST_F(DeskScript, ExposureIsDraggedTypedStruckAndRemembered) {
  remembers(savedIn(in(""), "click \"button:tour skip\"\nset time 0.5\nsave usual.png\nkey E\nkey E\nkey E\nexpect exposure = 1\nsave longer.png\nkey shift+E\nkey shift+E\nkey shift+E\nkey shift+E\nexpect exposure < -0.3\nsave shorter.png\n"
            "key alt+E\nexpect exposure = 0\ndrag number:exposure 30\nexpect exposure > 0\ndoubleclick number:exposure\ntype 9\nkey Enter\nexpect error contains \"-4 to 4 stops\"\nkey ctrl+A\ntype -1.5\nkey Enter\nexpect exposure = -1.5\nwait 70\n"));
  EXPECT_GT(brightness(picture("longer.png")), brightness(picture("usual.png")) + 10.0);
  EXPECT_LT(brightness(picture("shorter.png")), brightness(picture("usual.png")) - 2.0);
  remembers("expect exposure = -1.5\nexpect undo = 0\n");
}

TEST_F(DeskScript, TheCopiedCommandLineMakesThePictureWithTheViewsExposure) {
  const std::string script = "set time 0.5\nkey E\nkey E\nkey E\nkey ctrl+shift+E\nexpect clipboard contains \"--exposure 1\"\nprint clipboard\nkey ctrl+E\nclick \"field:export size\"\nkey ctrl+A\ntype 320x180\nclick \"field:export folder\"\nkey ctrl+A\ntype " +
                             std::string(folder_ / "out") + "\nclick button:export\nsettle\nexpect error =\nclick \"button:copy command line\"\nprint clipboard\n";
  std::filesystem::create_directories(folder_ / "out");
  const auto result = run(script);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string exported = folder_ / "out/work.png", bytes = test::slurp(exported);
  ASSERT_FALSE(bytes.empty());
  const std::size_t line = result.out.rfind("clipboard=npsee ") + std::string("clipboard=npsee ").size();
  std::filesystem::remove(exported);
  const auto again = test::run("/bin/sh", {"-c", test::npseePath() + ' ' + result.out.substr(line, result.out.find('\n', line) - line)});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(test::slurp(exported) == bytes);
}

class Exposures : public test::Rendering {
 protected:
  static render::Scene sceneOf(const test::HandMade& made, double stops, render::Background::Kind background = render::Background::Kind::sky) {
    render::Scene scene;
    scene.frame = &made.frame;
    scene.layers = made.layers;
    scene.ground_colour = {0.3, 0.3, 0.3};
    scene.background = {background, {0.5, 0.5, 0.5}};
    scene.bloom = false;
    scene.exposure_stops = stops;
    return scene;
  }
  static render::Camera camera() { return {{0.0, 12.0, 60.0}, {0.0, 8.0, 0.0}}; }
  static test::HandMade dome() {
    test::HandMade made;
    made.addDome(Form::tetrahedron, 60, 14.0, 1.0);
    return made;
  }
};

TEST_F(Exposures, AStopDoublesTheLinearLightOfEffectGroundAndSky) {
  const auto made = dome();
  for (const auto background : {render::Background::Kind::transparent, render::Background::Kind::sky}) {
    render::FloatImage usual, longer;
    ASSERT_TRUE(renderer_->drawToFloats(sceneOf(made, 0.0, background), camera(), 160, 90, {}, usual));
    ASSERT_TRUE(renderer_->drawToFloats(sceneOf(made, 1.0, background), camera(), 160, 90, {}, longer));
    double light = 0.0;
    for (std::size_t i = 0; i < usual.rgba.size(); i += 4) {
      EXPECT_EQ(longer.rgba[i + 3], usual.rgba[i + 3]) << "cover is no light";
      for (std::size_t k = 0; k < 3; ++k) {
        const double was = static_cast<double>(usual.rgba[i + k]), is = static_cast<double>(longer.rgba[i + k]);
        light += was;
        // The backdrop is kept as it is displayed, where what is very bright can be told apart no more.
        if (was < 0.4) {
          EXPECT_NEAR(is, 2.0 * was, 2e-3 + 2e-2 * was) << i;
        }
      }
    }
    EXPECT_GT(light, 1.0);
  }
}

TEST_F(Exposures, APlainBackgroundKeepsItsColour) {
  const auto made = dome();
  for (const double stops : {-4.0, 4.0}) {
    const auto image = renderer_->drawToImage(sceneOf(made, stops, render::Background::Kind::colour), camera(), 160, 90);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->pixel(2, 2)[0], 128);
  }
}

TEST_F(Exposures, NoExposureIsTheUsualPictureAndMoreIsNeverDarker) {
  const auto made = dome();
  std::vector<render::Image> images;
  for (const double stops : {-2.0, 0.0, 2.0}) {
    const auto image = renderer_->drawToImage(sceneOf(made, stops), camera(), 160, 90);
    ASSERT_TRUE(image);
    images.push_back(*image);
  }
  for (std::size_t i = 0; i < images[0].rgba.size(); ++i) {
    EXPECT_LE(images[0].rgba[i], images[1].rgba[i]);
    EXPECT_LE(images[1].rgba[i], images[2].rgba[i]);
  }
}

TEST(RenderCommand, ExposureIsAnOptionOfThePictureAndItsRecipe) {
  const test::TemporaryFolder folder;
  const std::string preset = std::string(NPSEE_SOURCE_DIR) + "/presets/classic_1993.npsee.json", out = folder / "a.png";
  const auto render = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"render", preset, "-o", out, "--size", "160x90", "--time", "0.5"};
    words.insert(words.end(), more.begin(), more.end());
    return test::npseeRun(words);
  };
  EXPECT_EQ(render({}).exit_code, 0);
  const std::string usual = test::slurp(out);
  EXPECT_EQ(render({"--exposure", "0"}).exit_code, 0);
  EXPECT_TRUE(test::slurp(out) == usual);
  EXPECT_EQ(render({"--exposure", "1.5", "--resume"}).out, out + '\n') << "not taken for the picture that is there";
  EXPECT_FALSE(test::slurp(out) == usual);
  EXPECT_NE(render({"--exposure", "1.5", "--summary", "json"}).out.find("\"exposure\": 1.5"), std::string::npos);
  for (const char* bad : {"9", "-4.1", "bright", "nan", "inf"}) {
    const auto refused = render({"--exposure", bad});
    EXPECT_EQ(refused.exit_code, 2) << bad;
    EXPECT_NE(refused.err.find("--exposure " + std::string(bad) + ": exposures go from -4 to 4 stops."), std::string::npos) << refused.err;
  }
}

}  // namespace
}  // namespace npsee
