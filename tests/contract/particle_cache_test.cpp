// `npsee particles` as a cache for other tools: sequences of files, and PLY.
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// A binary PLY read by its own header.
struct Ply {
  std::vector<std::string> comments;
  std::vector<std::map<std::string, double>> vertices;
};

Ply readPly(const std::string& bytes) {
  Ply out;
  std::vector<std::pair<std::string, std::string>> properties;
  std::size_t count = 0, at = 0;
  for (std::string line; line != "end_header";) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos) throw std::runtime_error("no end_header");
    line = bytes.substr(at, end - at);
    at = end + 1;
    std::istringstream words(line);
    std::string word, type, name;
    words >> word >> type >> name;
    if (word == "comment") out.comments.push_back(line.substr(8));
    if (word == "element") count = std::stoul(name);
    if (word == "property") properties.emplace_back(type, name);
  }
  const auto take = [&](auto value) {
    if (at + sizeof value > bytes.size()) throw std::runtime_error("too short");
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return static_cast<double>(value);
  };
  for (std::size_t i = 0; i < count; ++i) {
    auto& vertex = out.vertices.emplace_back();
    for (const auto& [type, name] : properties) vertex[name] = type == "float" ? take(float{}) : type == "uchar" ? take(std::uint8_t{}) : type == "ushort" ? take(std::uint16_t{}) : take(std::int32_t{});
  }
  EXPECT_EQ(at, bytes.size()) << "nothing follows the vertices";
  return out;
}

class ParticleCache : public ::testing::Test {
 protected:
  void SetUp() override {
    test::spill(preset(), R"({"npsee": 1, "title": "A cache", "layers": [
      {"name": "fragments", "count": 40, "speed_mean": 12, "size_mean": 1, "lifetime_mean": 1, "lifetime_deviation": 0.4},
      {"name": "sparks", "count": 30, "speed_mean": 9, "form": "streak", "start": 0.3}]})");
  }
  std::string preset() const { return inputs_ / "cache.npsee.json"; }
  test::ProcessResult particles(Words words) const {
    words.insert(words.begin(), {"particles", preset()});
    return test::npseeRun(words);
  }
  void expectRefused(int code, const Words& words, const Words& named) const {
    const auto result = particles(words);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(result.out, "");
    for (const std::string& word : named) EXPECT_NE(result.err.find(word), std::string::npos) << word << " in: " << result.err;
    EXPECT_TRUE(fs::is_empty(folder_.path()));
  }
  test::TemporaryFolder folder_, inputs_;
};

TEST_F(ParticleCache, APlyHoldsTheLivingParticlesAsTheCsvHasThem) {
  const auto result = particles({"--time", "0.9", "--format", "ply"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.out.starts_with("ply\nformat binary_little_endian 1.0\n"));
  const Ply ply = readPly(result.out);
  std::istringstream csv(particles({"--time", "0.9"}).out);
  std::size_t vertex = 0;
  std::string line;
  std::getline(csv, line);
  for (int id = 0; std::getline(csv, line); ++id) {
    std::vector<std::string> cells;
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    if (cells[2] == "0") continue;
    ASSERT_LT(vertex, ply.vertices.size());
    auto v = ply.vertices[vertex++];
    EXPECT_EQ(v["id"], id);
    EXPECT_EQ(v["layer"], cells[0] == "fragments" ? 0 : 1);
    const char* names[] = {"age", "x", "y", "z", "vx", "vy", "vz", "size"};
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(v[names[k]], static_cast<double>(static_cast<float>(std::stod(cells[3 + k])))) << names[k];
    EXPECT_NEAR(v["red"], 255.0 * std::stod(cells[11]), 0.5);
    EXPECT_NEAR(v["alpha"], 255.0 * std::stod(cells[14]), 0.5);
    EXPECT_EQ(v["bounces"], std::stod(cells[15]));
    EXPECT_NEAR(v["qx"] * v["qx"] + v["qy"] * v["qy"] + v["qz"] * v["qz"] + v["qw"] * v["qw"], 1.0, 1e-5);
  }
  EXPECT_EQ(vertex, ply.vertices.size());
  EXPECT_GT(vertex, 10u);
  EXPECT_LT(vertex, 70u) << "the dead are left out";
  const std::set<std::string> comments(ply.comments.begin(), ply.comments.end());
  for (const char* comment : {"title A cache", "seed 1993", "time_s 0.9", "layer 0 fragments", "layer 1 sparks"}) EXPECT_TRUE(comments.contains(comment)) << comment;
}

TEST_F(ParticleCache, ASequenceIsAFileForEachFrame) {
  const auto result = particles({"--frames", "0:0.5", "--fps", "8", "-o", folder_ / "c_%03d.ply"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, (folder_ / "c_000.ply\n") + (folder_ / "c_001.ply\n") + (folder_ / "c_002.ply\n") + (folder_ / "c_003.ply\n"));
  EXPECT_EQ(test::slurp(folder_ / "c_002.ply"), particles({"--time", "0.25", "--format", "ply"}).out) << "frame k shows the time k / fps";
  EXPECT_EQ(particles({"--frames", "0:0.2", "--fps", "10", "--format", "csv", "-o", folder_.path()}).out, (folder_ / "cache_0000.csv\n") + (folder_ / "cache_0001.csv\n"));
  EXPECT_EQ(test::slurp(folder_ / "cache_0001.csv"), particles({"--time", "0.1"}).out);
}

TEST_F(ParticleCache, IdsStayTheSameThroughASequence) {
  particles({"--frames", "0:2", "--fps", "10", "-o", folder_ / "c_%03d.ply"});
  std::map<double, double> last;
  for (const char* name : {"c_003.ply", "c_004.ply"})
    for (auto& vertex : readPly(test::slurp(folder_ / name)).vertices) {
      const double id = vertex["id"];
      if (last.contains(id)) {
        EXPECT_NEAR(vertex["x"], last[id], 0.1 * 40.0);
      }
      last[id] = vertex["x"] + 0.1 * vertex["vx"];
    }
  EXPECT_GT(last.size(), 30u);
}

TEST_F(ParticleCache, OneMomentGoesToAFileToo) {
  const auto result = particles({"--time", "0.5", "-o", folder_ / "a.json"});
  EXPECT_EQ(result.out, folder_ / "a.json\n");
  EXPECT_EQ(test::slurp(folder_ / "a.json"), particles({"--time", "0.5", "--format", "json"}).out) << "the ending chooses the format";
}

TEST_F(ParticleCache, WhatCannotBeMeantExitsTwo) {
  expectRefused(2, {}, {"--time", "--frames 0:2"});
  expectRefused(2, {"--time", "1", "--frames", "0:1"}, {"--time", "--frames"});
  expectRefused(2, {"--time", "1", "--fps", "10"}, {"--frames FROM:TO"});
  expectRefused(2, {"--frames", "0:1"}, {"-o cache_%04d.ply"});
  expectRefused(2, {"--frames", "1:0", "-o", folder_ / "a.ply"}, {"ends before it begins"});
  expectRefused(2, {"--frames", "0:1", "--fps", "x", "-o", folder_ / "a.ply"}, {"--fps x"});
  expectRefused(2, {"--frames", "0:1", "-o", folder_ / "a_%s.ply"}, {"%04d"});
  expectRefused(2, {"--time", "1", "--format", "abc"}, {"--format abc", "csv, json or ply"});
  expectRefused(2, {"--time", "1", "--format", "csv", "-o", folder_ / "a.ply"}, {"contradict each other"});
}

TEST_F(ParticleCache, PlacesThatCannotBeWrittenExitFive) {
  expectRefused(5, {"--time", "1", "-o", folder_ / "no/a.ply"}, {"no/a.ply", "does not exist"});
  expectRefused(5, {"--frames", "0:1", "-o", folder_ / "no/no/"}, {"does not exist"});
  expectRefused(5, {"--time", "1", "-o", "/dev/full", "--format", "ply"}, {"/dev/full"});
}

TEST_F(ParticleCache, HelpShowsEveryOption) {
  const auto help = particles({"--help"});
  for (const char* word : {"--time", "--frames", "--fps", "--format", "--output", "--seed", "--set", "ply", "Examples:"}) EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace npsee
