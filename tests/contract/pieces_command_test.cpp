// Layers of pieces through the real command line: models from files, hostile ones among them, and what comes out.

#include "tests/support/models.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <sstream>

namespace npsee {
namespace {

using test::npseeRun;
using test::ProcessResult;
using test::slurp;
using test::spill;
using test::TemporaryFolder;

std::string presetWith(const std::string& model, int count = 12, const std::string& more = {}) {
  return R"({"npsee": 1, "layers": [{"name": "whole", "count": )" + std::to_string(count) +
         R"(, "lifetime_mean": 20, "lifetime_deviation": 0, "form": "pieces", "pieces": {"model": ")" + model + "\"}" + more + "}]}\n";
}

/// A preset beside a model with this text.
struct ModelFiles {
  explicit ModelFiles(const std::string& obj, const std::string& name = "model.obj") : preset(folder / "a.npsee.json") {
    spill(folder / "model.obj", obj);
    spill(preset, presetWith(name));
  }
  TemporaryFolder folder;
  std::string preset;
};

TEST(PiecesCommand, AModelBesideThePresetComesApartIntoParticles) {
  const ModelFiles files(test::boxObj({-1, 0, -1}, {1, 2, 1}));
  const ProcessResult check = npseeRun({"check", files.preset});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  const ProcessResult states = npseeRun({"particles", files.preset, "--time", "1", "--format", "json"});
  ASSERT_EQ(states.exit_code, 0) << states.err;
  const auto json = nlohmann::json::parse(states.out);
  EXPECT_EQ(json.size(), 12u);
  for (const auto& particle : json) EXPECT_EQ(particle["alive"], 1);
}

struct BadModel {
  const char* obj;
  const char* says;
};

TEST(PiecesCommand, BadModelsAreRefusedWithTheirFileAndLine) {
  const BadModel cases[] = {
      {"v 0 0 0\nv 1 0 nan\n", "model.obj:2: a point needs three finite numbers."},
      {"v 0 0\n", "model.obj:1: a point needs three finite numbers."},
      {"v 0 0 1e9\n", "model.obj:1: a point lies further out than 100000."},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "model.obj:4: the face uses point 4, but there are 3 points so far, counted from 1."},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "model.obj:4: the face uses point 0"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "model.obj:4: the face uses point -4"},
      {"v 0 0 0\nv 1 0 0\nf 1 2\n", "model.obj:3: a face has 2 corners, but needs at least 3."},
      {"v 0 0 0\nf 1 x 1\n", "model.obj:2: the corner \"x\" is not the number of a point."},
      {"v 0 0 0\nf 99999999999999999999 1 1\n", "model.obj:2: the corner"},
      {"# nothing\n", "model.obj: the model has no faces."},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "model.obj: the model encloses no volume"},
      {"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\nf 2 3 4\n", "model.obj: the model encloses no volume"},
  };
  for (const BadModel& bad : cases) {
    const ModelFiles files(bad.obj);
    const ProcessResult check = npseeRun({"check", files.preset});
    EXPECT_EQ(check.exit_code, 1) << bad.obj;
    EXPECT_NE(check.out.find(bad.says), std::string::npos) << bad.obj << "\n" << check.out;
    const ProcessResult states = npseeRun({"particles", files.preset, "--time", "1"});
    EXPECT_EQ(states.exit_code, 3) << bad.obj;
    EXPECT_NE(states.err.find(bad.says), std::string::npos) << bad.obj << "\n" << states.err;
  }
}

TEST(PiecesCommand, RenderRefusesABadModelAndWritesNothing) {
  const ModelFiles files("v 0 0 0\nv 1 0 nan\n");
  const std::string picture = files.folder / "out.png";
  const ProcessResult result = npseeRun({"render", files.preset, "-o", picture});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_NE(result.err.find("model.obj:2: a point needs three finite numbers."), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(PiecesCommand, PathsOutsideThePresetsFolderAreRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"../model.obj", ".. is refused"},
      {"sub/../../model.obj", ".. is refused"},
      {"/etc/passwd", "an absolute path is refused"},
      {"a\\\\b.obj", "which is not a path with / between folders"},
      {"", "there is nothing to come apart"},
      {"tonk", "there is no such shipped model; did you mean tank?"},
      {"missing.obj", "there is no model file"},
      {"./", "is not a regular file"},
  };
  for (const auto& [name, says] : cases) {
    const ModelFiles files(test::boxObj({0, 0, 0}, {1, 1, 1}), name);
    const ProcessResult check = npseeRun({"check", files.preset});
    EXPECT_EQ(check.exit_code, 1) << name;
    EXPECT_NE(check.out.find(says), std::string::npos) << name << "\n" << check.out;
    EXPECT_NE(check.out.find("a.npsee.json"), std::string::npos) << check.out;
  }
}

TEST(PiecesCommand, ADeviceIsNoModel) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/zero", folder / "zero.obj");
  spill(folder / "a.npsee.json", presetWith("zero.obj"));
  const ProcessResult check = npseeRun({"check", folder / "a.npsee.json"});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_NE(check.out.find("is not a regular file"), std::string::npos) << check.out;
}

TEST(PiecesCommand, TooManyPiecesAndTooManyTrianglesAreRefused) {
  const ModelFiles files(test::boxObj({0, 0, 0}, {1, 1, 1}));
  const ProcessResult many = npseeRun({"particles", files.preset, "--time", "0", "--set", "whole.count=2001"});
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_NE(many.err.find("the model would come apart into 2001 pieces, above the limit of 2000."), std::string::npos) << many.err;
  std::string obj;
  for (int i = 0; i < 3000; ++i) obj += test::boxObj({2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}, 8 * i);
  spill(files.folder / "model.obj", obj);
  const ProcessResult large = npseeRun({"particles", files.preset, "--time", "0"});
  EXPECT_EQ(large.exit_code, 3);
  EXPECT_NE(large.err.find("there are more than 20000 triangles."), std::string::npos) << large.err;
}

TEST(PiecesCommand, AnOpenModelIsClosedAndOneOfTurnedFacesIsRight) {
  // A box without its lid, and with one face the wrong way round.
  std::string obj = test::boxObj({-1, 0, -1}, {1, 2, 1});
  obj = obj.substr(0, obj.rfind("f "));
  obj.replace(obj.find("f 5 6 7 8"), 9, "f 8 7 6 5");
  const ModelFiles files(obj);
  const ProcessResult check = npseeRun({"check", files.preset});
  EXPECT_EQ(check.exit_code, 0) << check.out;
  const SolidModel model = test::modelOf(obj);
  ASSERT_EQ(model.shells.size(), 1u);
  EXPECT_NEAR(massOf(model.shells[0], 1.0).volume_m3, 8.0, 1e-12);
}

TEST(PiecesCommand, BeforeItsStartTheModelStandsWholeAndStill) {
  const ModelFiles files(test::boxObj({-1, 0, -1}, {1, 2, 1}));
  const std::vector<std::string> late{"--set", "whole.start=2"};
  const auto at = [&](const std::string& time, const std::string& stands) {
    const ProcessResult result = npseeRun({"particles", files.preset, "--time", time, "--format", "json", "--set", "whole.start=2", "--set", "whole.pieces.stand=" + stands});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(result.out);
  };
  const auto begin = at("0", "true"), before = at("1.9", "true"), hidden = at("1.9", "false"), after = at("2.5", "true");
  for (std::size_t i = 0; i < begin.size(); ++i) {
    EXPECT_EQ(begin[i]["alive"], 1);
    EXPECT_EQ(hidden[i]["alive"], 0);
    for (const char* key : {"x_m", "y_m", "z_m", "vx_mps", "vy_mps", "vz_mps", "size_m"}) EXPECT_EQ(begin[i][key], before[i][key]) << key;
    EXPECT_EQ(before[i]["vx_mps"], 0.0);
    EXPECT_NE(after[i]["x_m"], before[i]["x_m"]);
  }
}

TEST(PiecesCommand, CachesHoldOneRowPerPiece) {
  const ModelFiles files(test::boxObj({-1, 0, -1}, {1, 2, 1}));
  const ProcessResult csv = npseeRun({"particles", files.preset, "--time", "0.5"});
  ASSERT_EQ(csv.exit_code, 0) << csv.err;
  std::istringstream lines(csv.out);
  int rows = -1;
  for (std::string line; std::getline(lines, line);) rows += line.starts_with("whole,") || rows < 0;
  EXPECT_EQ(rows, 12);
  const ProcessResult ply = npseeRun({"particles", files.preset, "--time", "0.5", "--format", "ply", "-o", files.folder / "a.ply"});
  ASSERT_EQ(ply.exit_code, 0) << ply.err;
  EXPECT_NE(slurp(files.folder / "a.ply").find("element vertex 12\n"), std::string::npos);
}

TEST(PiecesCommand, AnotherModelUnderTheSameNameIsDrawnAnewByResume) {
  const ModelFiles files(test::boxObj({-1, 0, -1}, {1, 2, 1}));
  const std::vector<std::string> draw{"render", files.preset, "-o", files.folder / "a.png", "--time", "0", "--size", "160x100", "--camera", "eye=8,4,9 target=0,1,0", "--resume"};
  ASSERT_EQ(npseeRun(draw).exit_code, 0);
  const std::string first = slurp(files.folder / "a.png");
  ASSERT_FALSE(first.empty());
  ASSERT_EQ(npseeRun(draw).exit_code, 0);
  EXPECT_EQ(slurp(files.folder / "a.png"), first);
  spill(files.folder / "model.obj", test::boxObj({-2, 0, -2}, {2, 1, 2}));
  ASSERT_EQ(npseeRun(draw).exit_code, 0);
  EXPECT_NE(slurp(files.folder / "a.png"), first);
}

TEST(PiecesCommand, TheMaterialsBesideAModelColourIt) {
  const std::string box = "mtllib m.mtl\nusemtl paint\n" + test::boxObj({-1, 0, -1}, {1, 2, 1});
  const ModelFiles files(box);
  const std::vector<std::string> draw{"render", files.preset, "-o", files.folder / "a.png", "--time", "0", "--size", "80x50"};
  ASSERT_EQ(npseeRun(draw).exit_code, 0) << "a missing library is no fault";
  const std::string plain = slurp(files.folder / "a.png");
  spill(files.folder / "m.mtl", "newmtl paint\nKd 0.1 0.2 0.9\n");
  ASSERT_EQ(npseeRun(draw).exit_code, 0);
  EXPECT_NE(slurp(files.folder / "a.png"), plain);
}

}  // namespace
}  // namespace npsee
