#include <npsee/explosion.h>
#include <npsee/parameters.h>

#include "sim/core/text.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace npsee {
namespace {

std::string faultsOf(const std::string& text) {
  const auto preset = parsePreset(text, "f.json");
  return preset ? "" : preset.error().text();
}

TEST(Presets, ATreeOfLayersSurvives) {
  Preset preset;
  preset.layers.resize(3);
  preset.layers[0].name = "a";
  preset.layers[1].name = "b";
  preset.layers[1].parent = "a";
  preset.layers[1].trigger = Trigger::bounce;
  preset.layers[2].name = "c";
  preset.layers[2].parent = "b";
  preset.layers[2].trigger = Trigger::death;
  for (Layer& layer : preset.layers) layer.count = 10;
  const auto read = parsePreset(presetText(preset), "f");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(*read, preset);
}

/// The shipped presets' files, sorted.
std::vector<std::filesystem::path> shippedFiles() {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(NPSEE_SOURCE_DIR) + "/presets"))
    if (entry.is_regular_file()) out.push_back(entry.path());
  std::ranges::sort(out);
  return out;
}

TEST(Presets, EveryShippedPresetIsValidAndInTheFormTheProgramWrites) {
  for (const auto& file : shippedFiles()) {
    const auto preset = loadPreset(file);
    ASSERT_TRUE(preset) << preset.error().text();
    EXPECT_EQ(presetText(*preset), test::slurp(file.string())) << file;
  }
}

TEST(Presets, TheLibraryHasSixteenOrMoreEachWithATitleOfItsOwnADescriptionAndTags) {
  std::set<std::string> titles;
  for (const auto& file : shippedFiles()) {
    const auto preset = loadPreset(file);
    ASSERT_TRUE(preset) << preset.error().text();
    EXPECT_FALSE(preset->title.empty()) << file;
    EXPECT_TRUE(titles.insert(preset->title).second) << file << ": another preset is called \"" << preset->title << "\" too";
    EXPECT_GT(preset->description.size(), 60u) << file;
    EXPECT_GE(splitAt(preset->tags, ',').size(), 3u) << file << ": " << preset->tags;
  }
  EXPECT_GE(titles.size(), 16u);
}

TEST(Presets, EveryShippedPresetHasASmallThumbnailAndThereAreNoOthers) {
  std::set<std::string> names;
  for (const auto& file : shippedFiles()) {
    const std::string name = file.filename().string().substr(0, file.filename().string().find('.'));
    names.insert(name + ".png");
    const std::string png = test::slurp((file.parent_path() / "thumbnails" / (name + ".png")).string());
    ASSERT_GT(png.size(), 24u) << name << " has no thumbnail: run scripts/make_gallery.py";
    // Signature, and the header's width and height: 256 x 160.
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n") << name;
    EXPECT_EQ(png.substr(16, 8), std::string("\0\0\1\0\0\0\0\xa0", 8)) << name;
    EXPECT_LT(png.size(), 80000u) << name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(std::string(NPSEE_SOURCE_DIR) + "/presets/thumbnails"))
    EXPECT_TRUE(names.contains(entry.path().filename().string())) << entry.path();
}

// Nothing is on the ground at time 0 that is not there to be seen: a viewer who opens a preset sees something at once.
TEST(Presets, EveryShippedPresetShowsSomethingAtItsFirstMoment) {
  for (const auto& file : shippedFiles()) {
    const auto preset = loadPreset(file);
    ASSERT_TRUE(preset) << preset.error().text();
    const auto explosion = Explosion::compile(*preset);
    ASSERT_TRUE(explosion) << explosion.error().text();
    Frame frame;
    (*explosion)->at(0.0, frame, kLook);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < frame.count; ++i) seen += frame.size[i] > 0.0f && frame.a[i] > 0.0f ? 1 : 0;
    EXPECT_GT(seen, 0u) << file;
  }
}

TEST(Presets, EveryFaultIsReportedWithFileLineAndPointer) {
  const std::string text = faultsOf("{\n\"npsee\": 1,\n\"gravty\": 3,\n\"layers\": [\n{\"speed_mean\": 5000,\n\"size_mean\": \"big\"}]}");
  EXPECT_NE(text.find("f.json:3: /gravty: there is no such parameter.\n  Did you mean gravity?"), std::string::npos) << text;
  EXPECT_NE(text.find("f.json:5: /layers/0/speed_mean: speed_mean is 5000 m/s, above the limit of 3000 m/s."), std::string::npos) << text;
  EXPECT_NE(text.find("f.json:6: /layers/0/size_mean: size_mean is \"big\", but must be a number."), std::string::npos) << text;
}

TEST(Presets, UnknownKeysInsideGroupsAreNamedWithTheNearest) {
  const std::string text = faultsOf(R"({"npsee":1,"layers":[{"region":{"radus":3}}]})");
  EXPECT_NE(text.find("/layers/0/region/radus: there is no such parameter.\n  Did you mean region.radius?"), std::string::npos) << text;
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"region":3}]})").find("must be an object"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"region.radius":3}]})").find("no such parameter"), std::string::npos);
}

TEST(Presets, AMissingOrNewerVersionIsRefusedByName) {
  EXPECT_NE(faultsOf(R"({"layers":[]})").find("Add \"npsee\": 1"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":7,"layers":[],"future":1})").find("the file has version 7, newer than 1"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":"x","layers":[]})").find("must be a whole number"), std::string::npos);
  EXPECT_NE(faultsOf("[]").find("a preset is an object"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1})").find("the list of layers is missing"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[3]})").find("a layer is a number"), std::string::npos);
}

TEST(Presets, ABillionParticlesAreRefusedWithTheLimitNamed) {
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"count":1000000000}]})").find("above the limit of 4000000 particles"), std::string::npos);
  const std::string dense = faultsOf(R"({"npsee":1,"layers":[{"density":1000000,"region":{"radius":1000}}]})");
  EXPECT_NE(dense.find("above the limit of 4000000"), std::string::npos) << dense;
  const std::string children = faultsOf(R"({"npsee":1,"layers":[{"name":"a","count":100000},{"name":"b","parent":"a","trigger":"bounce","count":10}]})");
  EXPECT_NE(children.find("the layers start 9100000 particles"), std::string::npos) << children;
}

TEST(Presets, MoreMemoryThanThereMayBeIsRefusedBeforeItIsTaken) {
  const std::string text = faultsOf(R"({"npsee":1,"layers":[{"count":4000000,"bounce_limit":64}]})");
  EXPECT_NE(text.find("MiB with all their bounces, above the limit of 4096 MiB.\n  Lower a bounce_limit"), std::string::npos) << text;
  EXPECT_EQ(faultsOf(R"({"npsee":1,"layers":[{"count":4000000}]})"), "");
}

TEST(Presets, NamesParentsCyclesAndDirectionsAreChecked) {
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{},{}]})").find("the name \"fragments\" is taken by layer 0"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"name":"a/b"}]})").find("does not fit"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"parent":"fragment","trigger":"death"}]})").find("no layer \"fragment\""), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"name":"a","parent":"b","trigger":"death"},{"name":"b","parent":"a","trigger":"death"}]})").find("hangs on itself"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"trigger":"death"}]})").find("without a parent"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"direction":[0,0,0]}]})").find("has no length"), std::string::npos);
}

TEST(Presets, CurvesMustBeInOrderAndShort) {
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"size_over_life":[[0.5,1],[0.2,1]]}]})").find("points go in order"), std::string::npos);
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"size_over_life":[[1.5,1]]}]})").find("outside the life"), std::string::npos);
  std::string many = "[0,1]";
  for (int i = 0; i < 40; ++i) many += ",[1,1]";
  EXPECT_NE(faultsOf(R"({"npsee":1,"layers":[{"size_over_life":[)" + many + "]}]}").find("41 points, above the limit of 32"), std::string::npos);
}

TEST(Presets, RenamingALayerKeepsItsChildrenAndIsRefusedWhereTheNameIsTaken) {
  Preset preset;
  preset.layers.resize(2);
  preset.layers[1].name = "sparks";
  preset.layers[1].parent = "fragments";
  preset.layers[1].trigger = Trigger::birth;
  ASSERT_TRUE(renameLayer(preset, 0, "steel"));
  EXPECT_EQ(preset.layers[0].name, "steel");
  EXPECT_EQ(preset.layers[1].parent, "steel");
  EXPECT_TRUE(validate(preset).empty());
  EXPECT_FALSE(renameLayer(preset, 0, "sparks"));
  EXPECT_FALSE(renameLayer(preset, 0, ""));
  EXPECT_EQ(preset.layers[0].name, "steel");
}

TEST(Presets, SettingsNameTheNearestParameterAndChangeNothingWhenRefused) {
  Preset preset;
  preset.layers.emplace_back();
  preset.layers[0].name = "debris";
  const Preset before = preset;
  for (const char* bad : {"debris.radus=4", "gravity", "=3", "gravity=", "gravity=-1", "burst=underwater", "debris.count=1e9", "nolayer.count=3"}) EXPECT_FALSE(applySetting(preset, bad)) << bad;
  EXPECT_EQ(preset, before);
  EXPECT_NE(applySetting(preset, "debris.region.radus=4").error().text().find("Did you mean debris.region.radius?"), std::string::npos);
  ASSERT_TRUE(applySetting(preset, "debris.ejection_angle=0.9rad"));
  EXPECT_DOUBLE_EQ(preset.layers[0].ejection_angle_rad, 0.9);
}

TEST(Presets, SavingReplacesTheFileWholeAndKeepsItsMode) {
  const test::TemporaryFolder folder;
  Preset preset;
  preset.layers.emplace_back();
  const std::string path = folder / "p.npsee.json";
  ASSERT_TRUE(savePreset(preset, path));
  ::chmod(path.c_str(), 0640);
  preset.title = "second";
  ASSERT_TRUE(savePreset(preset, path));
  struct stat status {};
  ::stat(path.c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
  EXPECT_EQ(*loadPreset(path), preset);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Presets, SavingWhereItCannotSaysSoAndLeavesTheOldFile) {
  Preset preset;
  preset.layers.emplace_back();
  const auto missing = savePreset(preset, "/nonexistent/folder/p.npsee.json");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::output);
  EXPECT_NE(missing.error().text().find("the folder does not exist"), std::string::npos);
  EXPECT_FALSE(savePreset(preset, "/dev/full"));
}

}  // namespace
}  // namespace npsee
