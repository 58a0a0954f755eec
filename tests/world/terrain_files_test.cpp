#include "tests/support/process.h"
#include "tests/world/terrain_support.h"

#include <png.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace npsee {
namespace {

using test::spill;
using test::TemporaryFolder;
using test::terrain;

std::string hgtBytes(const std::vector<int>& heights) {
  std::string out;
  for (const int h : heights) {
    out += static_cast<char>((h >> 8) & 255);
    out += static_cast<char>(h & 255);
  }
  return out;
}

void writeGrey16(const std::string& path, int width, int height, const std::vector<std::uint16_t>& greys, bool eight_bits = false) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_LINEAR_Y;
  ASSERT_NE(png_image_write_to_file(&image, path.c_str(), eight_bits ? 1 : 0, greys.data(), 0, nullptr), 0) << image.message;
}

TerrainSource file(TerrainKind kind, const std::string& path) {
  TerrainSource source;
  source.kind = kind;
  source.file = path;
  return source;
}

/// What `make` says about a terrain that must be refused as a faulty input.
std::string refusal(const TerrainSource& source, double size_x = 1000.0, double size_z = 1000.0, double sea = 0.0) {
  const auto made = Terrain::make(source, size_x, size_z, sea);
  if (made) {
    ADD_FAILURE() << "was not refused";
    return {};
  }
  EXPECT_EQ(made.error().kind, ErrorKind::input);
  for (const Fault& fault : made.error().faults) EXPECT_FALSE(fault.what.empty() || fault.remedy.empty()) << fault.text();
  return made.error().text();
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Hgt, SamplesAreReadNorthRowFirst) {
  const TemporaryFolder folder;
  std::vector<int> heights;
  for (int i = 0; i < 25; ++i) heights.push_back(i * 17 - 60);
  spill(folder / "a.hgt", hgtBytes(heights));
  const Terrain ground = terrain(file(TerrainKind::hgt, folder / "a.hgt"), 0.0, 0.0);
  EXPECT_EQ(ground.columns(), 5);
  EXPECT_EQ(ground.sizeX(), 360.0);
  for (int r = 0; r < 5; ++r)
    for (int c = 0; c < 5; ++c) EXPECT_EQ(ground.height(90.0 * c, 90.0 * r), heights[static_cast<std::size_t>(5 * r + c)]);
}

TEST(Hgt, AWorldSmallerThanTheTileIsItsNorthWestCorner) {
  const TemporaryFolder folder;
  std::vector<int> heights;
  for (int i = 0; i < 25; ++i) heights.push_back(i * i);
  spill(folder / "a.hgt", hgtBytes(heights));
  TerrainSource source = file(TerrainKind::hgt, folder / "a.hgt");
  source.cell_m = 100.0;
  const Terrain ground = terrain(source, 200.0, 300.0);
  EXPECT_EQ(ground.columns(), 3);
  EXPECT_EQ(ground.rows(), 4);
  EXPECT_EQ(ground.height(200.0, 300.0), 17.0 * 17.0);
  // No whole number of cells: the same surface, on lines of its own.
  const Terrain odd = terrain(source, 250.0, 250.0);
  EXPECT_NEAR(odd.height(0.0, 250.0), 0.5 * (100.0 + 225.0), 1e-3);
}

TEST(Hgt, VoidsAreFilledFromTheirNeighboursRingByRing) {
  const TemporaryFolder folder;
  std::vector<int> heights(49, 100);
  for (int r = 2; r < 5; ++r)
    for (int c = 2; c < 5; ++c) heights[static_cast<std::size_t>(7 * r + c)] = -32768;
  for (int r = 0; r < 7; ++r) heights[static_cast<std::size_t>(7 * r)] = 40;
  spill(folder / "a.hgt", hgtBytes(heights));
  const Terrain ground = terrain(file(TerrainKind::hgt, folder / "a.hgt"), 0.0, 0.0);
  EXPECT_EQ(ground.lowest(), 40.0);
  EXPECT_EQ(ground.highest(), 100.0);
  EXPECT_EQ(ground.height(270.0, 270.0), 100.0);
  // A void beside known samples takes their mean: one corner of five known ones.
  spill(folder / "b.hgt", hgtBytes({-32768, 10, 20, 30, 40, 50, 60, 70, 80}));
  EXPECT_NEAR(terrain(file(TerrainKind::hgt, folder / "b.hgt"), 0.0, 0.0).height(0.0, 0.0), (10 + 30 + 40) / 3.0, 1e-5);
}

TEST(Hgt, ATileOfOneHeightInASeaOfVoidsIsFilledQuickly) {
  const TemporaryFolder folder;
  std::vector<int> heights(401 * 401, -32768);
  heights[0] = 7;
  spill(folder / "a.hgt", hgtBytes(heights));
  const Terrain ground = terrain(file(TerrainKind::hgt, folder / "a.hgt"), 0.0, 0.0);
  EXPECT_EQ(ground.lowest(), 7.0);
  EXPECT_TRUE(ground.flat());
}

TEST(Hgt, BrokenFilesAreRefused) {
  const TemporaryFolder folder;
  spill(folder / "a.hgt", std::string(7, 'x'));
  EXPECT_SAYS(refusal(file(TerrainKind::hgt, folder / "a.hgt")), "is no .hgt terrain: 7 bytes are not n x n 16-bit heights");
  spill(folder / "b.hgt", "");
  EXPECT_SAYS(refusal(file(TerrainKind::hgt, folder / "b.hgt")), "0 bytes");
  spill(folder / "c.hgt", hgtBytes(std::vector<int>(9, -32768)));
  EXPECT_SAYS(refusal(file(TerrainKind::hgt, folder / "c.hgt")), "every sample is a void");
  EXPECT_SAYS(refusal(file(TerrainKind::hgt, folder / "missing.hgt")), "there is no such file");
  spill(folder / "d.hgt", hgtBytes(std::vector<int>(9, 5)));
  EXPECT_SAYS(refusal(file(TerrainKind::hgt, folder / "d.hgt")), "covers 180 x 180 m with samples 90 m apart, less than the world of 1000 x 1000 m");
}

TEST(HeightPng, SixteenBitGreysBecomeHeightsBySidecar) {
  const TemporaryFolder folder;
  const std::vector<std::uint16_t> greys{0, 65535, 32768, 1000, 2000, 3000};
  writeGrey16(folder / "a.png", 3, 2, greys);
  spill(folder / "a.png.json", R"({"cell_m": 50, "height_min_m": -100, "height_max_m": 555.35})");
  const Terrain ends = terrain(file(TerrainKind::png, folder / "a.png"), 0.0, 0.0);
  EXPECT_EQ(ends.sizeX(), 100.0);
  EXPECT_EQ(ends.sizeZ(), 50.0);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(ends.height(50.0 * (i % 3), 50.0 * (i / 3)), -100.0 + 0.01 * greys[static_cast<std::size_t>(i)], 1e-4);
  spill(folder / "a.png.json", R"({"cell_m": 20, "scale_m": 0.1, "offset_m": -20})");
  EXPECT_NEAR(terrain(file(TerrainKind::png, folder / "a.png"), 40.0, 20.0).height(20.0, 20.0), 180.0, 1e-4);
}

TEST(HeightPng, BrokenPicturesAreRefused) {
  const TemporaryFolder folder;
  spill(folder / "a.png", "no picture at all");
  EXPECT_SAYS(refusal(file(TerrainKind::png, folder / "a.png")), "it is not a PNG file");
  writeGrey16(folder / "b.png", 2, 2, {1, 2, 3, 4}, true);
  EXPECT_SAYS(refusal(file(TerrainKind::png, folder / "b.png")), "it is not a 16-bit grey picture");
  writeGrey16(folder / "c.png", 40, 40, std::vector<std::uint16_t>(1600, 500));
  const std::string whole = test::slurp(folder / "c.png");
  spill(folder / "c.png.json", R"({"cell_m": 50, "height_min_m": 0, "height_max_m": 100})");
  for (std::size_t length = 8; length + 12 < whole.size(); length += 5) {
    spill(folder / "c.png", whole.substr(0, length));
    EXPECT_SAYS(refusal(file(TerrainKind::png, folder / "c.png")), "is no terrain that can be read");
  }
  writeGrey16(folder / "d.png", 1, 2, {1, 2});
  EXPECT_SAYS(refusal(file(TerrainKind::png, folder / "d.png")), "less than 2 x 2 samples");
}

TEST(HeightPng, FaultySidecarsAreRefusedWithTheirPlace) {
  const TemporaryFolder folder;
  writeGrey16(folder / "a.png", 2, 2, {1, 2, 3, 4});
  const auto with = [&](const std::string& sidecar) {
    spill(folder / "a.png.json", sidecar);
    return refusal(file(TerrainKind::png, folder / "a.png"), 10.0, 10.0);
  };
  EXPECT_SAYS(refusal(file(TerrainKind::png, folder / "a.png")), "A terrain picture needs this file beside it");
  EXPECT_SAYS(with("{"), "a.png.json:1");
  EXPECT_SAYS(with("[1]"), "is not an object of settings");
  EXPECT_SAYS(with(R"({"cell": 3})"), "Did you mean cell_m?");
  EXPECT_SAYS(with(R"({"cell_m": "wide"})"), "must be a number");
  EXPECT_SAYS(with(R"({"height_min_m": 0, "height_max_m": 1})"), "lacks cell_m");
  EXPECT_SAYS(with(R"({"cell_m": 0, "height_min_m": 0, "height_max_m": 1})"), "/cell_m: is 0 m; it must be above 0");
  EXPECT_SAYS(with(R"({"cell_m": 30})"), "must give either height_min_m and height_max_m, or scale_m and offset_m");
  EXPECT_SAYS(with(R"({"cell_m": 30, "height_min_m": 0, "height_max_m": 1, "scale_m": 1})"), "must give either");
  EXPECT_SAYS(with(R"({"cell_m": 30, "scale_m": 10, "offset_m": 0})"), "beyond the limit of 20000 m");
}

TEST(Terrain, FaultyRequestsAreRefusedWithARemedy) {
  TerrainSource flat;
  EXPECT_SAYS(refusal(flat, 0.0), "The world's size is 0 m");
  EXPECT_SAYS(refusal(flat, NAN), "The world's size is nan m");
  EXPECT_SAYS(refusal(flat, 1000.0, 2e6), "at most 1000000 m");
  EXPECT_SAYS(refusal(flat, 1000.0, 1000.0, INFINITY), "The sea level is inf m");
  flat.height_m = 1e6;
  EXPECT_SAYS(refusal(flat), "The terrain's height is 1000000 m");
  TerrainSource hills = test::hills(1);
  hills.cell_m = -1.0;
  EXPECT_SAYS(refusal(hills), "cell_m is -1 m");
  hills.cell_m = 0.001;
  EXPECT_SAYS(refusal(hills, 50000.0, 50000.0), "above the limit of 67108864");
  hills = test::hills(1);
  hills.relief_m = -1.0;
  hills.valley = 2.0;
  hills.scale_m = 1.0;
  hills.sea_fraction = NAN;
  const std::string all = refusal(hills);
  for (const char* name : {"relief_m is -1", "valley is 2", "scale_m is 1", "sea_fraction is nan"}) EXPECT_SAYS(all, name);
}

TEST(Terrain, FaultyFunctionsAreRefusedWithARemedy) {
  EXPECT_SAYS(refusal(test::function("rigde", {})), "Did you mean ridge?");
  EXPECT_SAYS(refusal(test::function("", {})), "Use ridge, slope, step, plane and cone.");
  EXPECT_SAYS(refusal(test::function("plane", {}, "y")), "The terrain's axis is y; it must be x or z.");
  EXPECT_SAYS(refusal(test::function("ridge", {{"crest_x", 5}, {"crest_hight", 5}, {"foot_before", 1}, {"foot_after", 1}})), "Did you mean crest_height?");
  EXPECT_SAYS(refusal(test::function("ridge", {{"crest_x", 5}})), "lacks the parameter foot_before");
  EXPECT_SAYS(refusal(test::function("ridge", {{"crest_x", 5}, {"crest_height", 5}, {"foot_before", 0}, {"foot_after", 1}})), "foot_before is 0 m; it must be above 0");
  EXPECT_SAYS(refusal(test::function("ridge", {{"crest_x", NAN}, {"crest_height", 5}, {"foot_before", 1}, {"foot_after", 1}})), "crest_x is nan");
  EXPECT_SAYS(refusal(test::function("slope", {{"from", 10}, {"to", 10}, {"high", 1}})), "not beyond its start");
  EXPECT_SAYS(refusal(test::function("step", {{"at", 10}, {"width", -1}, {"high", 1}})), "width is -1 m");
  EXPECT_SAYS(refusal(test::function("cone", {{"top_x", 1}, {"top_z", 1}, {"top_height", 1}, {"radius", 0}})), "radius is 0 m");
  EXPECT_SAYS(refusal(test::function("plane", {{"slope_x", 1000}})), "beyond the limit of 20000 m");
}

}  // namespace
}  // namespace npsee
