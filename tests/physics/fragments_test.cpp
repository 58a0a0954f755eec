// Models that are cut to pieces, and how a burst flings them.

#include "tests/support/explosions.h"
#include "tests/support/models.h"
#include "tests/support/process.h"

#include <npsee/explosion.h>
#include <npsee/fragments.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace npsee {
namespace {

using test::boxObj;
using test::cut;
using test::modelOf;

/// Times each directed edge is used, less those the other way.
bool closed(const Solid& solid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> net;
  for (const Facet& facet : solid.facets)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = facet.corners[k], b = facet.corners[(k + 1) % 3];
      net[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  for (const auto& [edge, count] : net)
    if (count != 0) return false;
  return !solid.facets.empty();
}

double volumeOf(const SolidModel& model) {
  double sum = 0.0;
  for (const Solid& shell : model.shells) sum += massOf(shell, 1.0).volume_m3;
  return sum;
}

SolidModel shipped(const std::string& name) {
  auto model = findSolidModel(name, {});
  EXPECT_TRUE(model) << (model ? "" : model.error().text());
  return model ? *model : SolidModel{};
}

TEST(Fragments, ABoxHasTheMassCentreAndInertiaOfTheBook) {
  const SolidModel model = modelOf(boxObj({1.0, 2.0, 3.0}, {3.0, 3.0, 7.0}));
  ASSERT_EQ(model.shells.size(), 1u);
  const MassProperties mass = massOf(model.shells[0], 500.0);
  const double a = 2.0, b = 1.0, c = 4.0;
  EXPECT_NEAR(mass.volume_m3, a * b * c, 1e-12);
  EXPECT_NEAR(mass.mass_kg, 4000.0, 1e-9);
  EXPECT_NEAR(length(mass.centre_m - Vec3{2.0, 2.5, 5.0}), 0.0, 1e-12);
  EXPECT_NEAR(mass.inertia_kgm2[0], 4000.0 / 12.0 * (b * b + c * c), 1e-8);
  EXPECT_NEAR(mass.inertia_kgm2[1], 4000.0 / 12.0 * (c * c + a * a), 1e-8);
  EXPECT_NEAR(mass.inertia_kgm2[2], 4000.0 / 12.0 * (a * a + b * b), 1e-8);
  for (int i = 3; i < 6; ++i) EXPECT_NEAR(mass.inertia_kgm2[static_cast<std::size_t>(i)], 0.0, 1e-8);
}

TEST(Fragments, PiecesOfEveryShippedModelAreClosedAndTheirVolumesSumToItsVolume) {
  for (const std::string_view name : shippedModelNames()) {
    const SolidModel model = shipped(std::string(name));
    for (const Solid& shell : model.shells) EXPECT_TRUE(closed(shell)) << name;
    const double whole = volumeOf(model);
    ASSERT_GT(whole, 0.0) << name;
    for (const std::int64_t count : {1, 7, 60, 200}) {
      const auto pieces = cut(model, count, 7800.0);
      ASSERT_EQ(pieces->pieces.size(), static_cast<std::size_t>(count)) << name;
      double volume = 0.0, mass = 0.0;
      for (const Piece& piece : pieces->pieces) {
        EXPECT_TRUE(closed(piece.solid)) << name << " in " << count;
        EXPECT_GT(piece.mass.volume_m3, 0.0);
        EXPECT_NEAR(piece.mass.mass_kg, 7800.0 * piece.mass.volume_m3, 1e-9 * piece.mass.mass_kg);
        volume += piece.mass.volume_m3;
        mass += piece.mass.mass_kg;
      }
      EXPECT_NEAR(volume, whole, 1e-9 * whole) << name << " in " << count;
      EXPECT_NEAR(mass, 7800.0 * whole, 1e-9 * 7800.0 * whole) << name << " in " << count;
    }
  }
}

TEST(Fragments, APresetFromTextFindsItsModelInTheFolderThatIsNamed) {
  const test::TemporaryFolder folder;
  test::spill(folder / "crate.obj", boxObj({-1, 0, -1}, {1, 2, 1}));
  const std::string text = R"({"npsee": 1, "layers": [{"name": "a", "form": "pieces", "count": 20, "pieces": {"model": "crate.obj"}}]})";
  const auto beside = parsePreset(text, "text", folder.path());
  ASSERT_TRUE(beside) << beside.error().text();
  EXPECT_TRUE(Explosion::compile(*beside));
  const auto nowhere = parsePreset(text, "text");
  ASSERT_TRUE(nowhere) << nowhere.error().text();
  const auto compiled = Explosion::compile(*nowhere);
  ASSERT_FALSE(compiled);
  EXPECT_NE(compiled.error().text().find("crate.obj"), std::string::npos) << compiled.error().text();
}

TEST(Fragments, EachPieceIsGivenAroundItsCentreOfMassWithinItsRadius) {
  const auto pieces = cut(shipped("tank"), 80, 1000.0);
  for (const Piece& piece : pieces->pieces) {
    EXPECT_NEAR(length(massOf(piece.solid, 1.0).centre_m), 0.0, 1e-9 * (1.0 + piece.radius_m));
    double farthest = 0.0;
    for (const Vec3& point : piece.solid.points) farthest = std::max(farthest, length(point));
    EXPECT_EQ(farthest, piece.radius_m);
  }
}

TEST(Fragments, MomentsOfThePiecesSumToThoseOfTheWhole) {
  const SolidModel model = modelOf(boxObj({0.0, 0.0, 0.0}, {4.0, 2.0, 1.0}));
  const MassProperties whole = massOf(model.shells[0], 1.0);
  Vec3 moment;
  double inertia = 0.0;
  const auto pieces = cut(model, 40, 1.0);
  for (const Piece& piece : pieces->pieces) {
    moment = moment + piece.mass.mass_kg * piece.mass.centre_m;
    const Vec3 d = piece.mass.centre_m - whole.centre_m;
    inertia += piece.mass.inertia_kgm2[1] + piece.mass.mass_kg * (d.x * d.x + d.z * d.z);
  }
  EXPECT_NEAR(length((1.0 / whole.mass_kg) * moment - whole.centre_m), 0.0, 1e-12);
  EXPECT_NEAR(inertia, whole.inertia_kgm2[1], 1e-10);
}

/// A block with a hole through it: caps have holes in them, and one half falls into two parts.
std::string frameObj() {
  std::string out;
  const double outer = 2.0, inner = 1.0;
  for (const double z : {-0.5, 0.5})
    for (const double r : {outer, inner})
      for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
        out += "v " + std::to_string(r * x) + ' ' + std::to_string(r * y) + ' ' + std::to_string(z) + '\n';
  const auto quad = [&](int a, int b, int c, int d) { out += "f " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + ' ' + std::to_string(d) + '\n'; };
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    quad(1 + i, 5 + i, 5 + j, 1 + j);
    quad(9 + i, 9 + j, 13 + j, 13 + i);
    quad(1 + i, 1 + j, 9 + j, 9 + i);
    quad(5 + i, 13 + i, 13 + j, 5 + j);
  }
  return out;
}

TEST(Fragments, AFrameWithAHoleInItIsCutIntoClosedPiecesAllTheSame) {
  const SolidModel model = modelOf(frameObj());
  ASSERT_EQ(model.shells.size(), 1u);
  EXPECT_NEAR(volumeOf(model), 12.0, 1e-12);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    double volume = 0.0;
    const auto pieces = cut(model, 12, 1.0, seed);
    for (const Piece& piece : pieces->pieces) {
      EXPECT_TRUE(closed(piece.solid)) << seed;
      volume += piece.mass.volume_m3;
    }
    EXPECT_NEAR(volume, 12.0, 12e-9) << seed;
  }
}

TEST(Fragments, CutsThatRunAlongEdgesAndThroughCornersLeaveNoCracks) {
  // A lattice of points invites planes through them; many cuts of one seed hit snapped corners.
  const SolidModel model = modelOf(boxObj({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}) + boxObj({1.0, -1.0, -1.0}, {3.0, 1.0, 1.0}, 8));
  ASSERT_EQ(model.shells.size(), 2u) << "boxes that share a face and its points are two shells";
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto pieces = cut(model, 150, 1.0, seed);
    for (const Piece& piece : pieces->pieces) EXPECT_TRUE(closed(piece.solid)) << seed;
  }
}

TEST(Fragments, TheSameSeedCutsTheSameAndAnotherOneOtherwise) {
  const SolidModel model = shipped("truck");
  const auto a = cut(model, 60, 1.0, 5), b = cut(model, 60, 1.0, 5), c = cut(model, 60, 1.0, 6);
  bool differs = false;
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_EQ(a->pieces[i].solid, b->pieces[i].solid);
    differs = differs || a->pieces[i].solid != c->pieces[i].solid;
  }
  EXPECT_TRUE(differs);
}

TEST(Fragments, InnerFacesAreTornAndOuterOnesKeepTheirMaterial) {
  const SolidModel model = modelOf("usemtl brick\n" + boxObj({0.0, 0.0, 0.0}, {2.0, 1.0, 1.0}));
  const auto pieces = cut(model, 2, 1.0);
  double torn = 0.0, outer = 0.0;
  for (const Piece& piece : pieces->pieces)
    for (const Facet& facet : piece.solid.facets) {
      const Vec3 a = piece.solid.points[facet.corners[0]];
      const double area = 0.5 * length(cross(piece.solid.points[facet.corners[1]] - a, piece.solid.points[facet.corners[2]] - a));
      (facet.material == kTorn ? torn : outer) += area;
    }
  EXPECT_NEAR(outer, 10.0, 1e-9);
  EXPECT_GT(torn, 1.99) << "both sides of a cut across a section of 1 m2";
  EXPECT_EQ(pieces->materials[0].name, "brick");
}

TEST(Fragments, FewerPiecesThanShellsAreGroupsOfShells) {
  const SolidModel tank = shipped("tank");
  ASSERT_GT(tank.shells.size(), 8u);
  const auto pieces = cut(tank, 3, 1.0);
  EXPECT_EQ(pieces->pieces.size(), 3u);
}

TEST(Fragments, APieceLeavesAlongTheLineFromTheBurstWithImpulseTimesAreaOverMass) {
  // A cube far off, face on: it shows one side of 1 m2, and the impulse is the same all over it.
  const SolidModel model = modelOf(boxObj({99.5, -0.5, -0.5}, {100.5, 0.5, 0.5}));
  const auto pieces = cut(model, 1, 500.0);
  const Fling fling = flingOf(pieces->pieces[0], {2000.0, 50.0, {}});
  const double impulse = 2000.0 / (1.0 + 99.5 * 99.5 / 2500.0);
  EXPECT_NEAR(fling.velocity_mps.x, impulse * 1.0 / 500.0, 2e-4 * impulse / 500.0);
  EXPECT_NEAR(fling.velocity_mps.y, 0.0, 1e-12);
  EXPECT_NEAR(fling.velocity_mps.z, 0.0, 1e-12);
  EXPECT_NEAR(length(fling.spin_radps), 0.0, 1e-9) << "what is struck in its middle does not turn";
}

TEST(Fragments, EveryPieceMovesAwayFromTheBurst) {
  const Impulse impulse{10'000.0, 3.0, {0.4, 0.2, -0.3}};
  const auto pieces = cut(shipped("tank"), 90, 900.0);
  for (const Piece& piece : pieces->pieces) {
    const Vec3 away = piece.mass.centre_m - impulse.burst_m, velocity = flingOf(piece, impulse).velocity_mps;
    EXPECT_GT(dot(away, velocity), 0.0);
    EXPECT_NEAR(length(cross(away, velocity)), 0.0, 1e-9 * length(away) * length(velocity));
  }
}

TEST(Fragments, TwiceTheImpulseOrHalfTheDensityIsTwiceTheSpeed) {
  const SolidModel model = shipped("car");
  const auto heavy = cut(model, 20, 1000.0), light = cut(model, 20, 500.0);
  for (std::size_t i = 0; i < 20; ++i) {
    const Vec3 once = flingOf(heavy->pieces[i], {1000.0, 2.0, {}}).velocity_mps;
    EXPECT_NEAR(length(flingOf(heavy->pieces[i], {2000.0, 2.0, {}}).velocity_mps - 2.0 * once), 0.0, 1e-9);
    EXPECT_NEAR(length(flingOf(light->pieces[i], {1000.0, 2.0, {}}).velocity_mps - 2.0 * once), 0.0, 1e-9);
  }
}

TEST(Fragments, APlateStruckNearItsEndTurnsThatEndAwayFromTheBurst) {
  // A plate across z, 4 m wide; the burst stands before its right end, so that this end gets more and goes away (-z) first.
  const SolidModel model = modelOf(boxObj({-2.0, 0.0, -0.1}, {2.0, 1.0, 0.1}));
  const auto pieces = cut(model, 1, 1000.0);
  const Fling fling = flingOf(pieces->pieces[0], {5000.0, 1.0, {1.5, 0.5, 2.0}});
  EXPECT_LT(fling.velocity_mps.z, 0.0);
  EXPECT_GT(fling.spin_radps.y, 0.0) << "about +y: +x goes to -z";
}

TEST(Fragments, AirSlowsAThinPaneAtOnceAndHardlyABlock) {
  const auto speed = [](const SolidModel& model, double drag_ps) {
    Preset preset;
    Layer& layer = preset.layers.emplace_back();
    layer.form = Form::pieces;
    layer.count = 1;
    layer.drag_ps = drag_ps;
    layer.region_offset_m = {0.0, 20.0, 0.0};
    layer.pieces_density_kgpm3 = 2500.0;
    layer.pieces_impulse_Pas = 5000.0;
    layer.pieces_burst_m = {0.0, 0.0, 3.0};
    layer.pieces_reach_m = 3.0;
    CompileOptions options;
    options.model = std::make_shared<const SolidModel>(model);
    const auto explosion = test::compiled(preset, nullptr, options);
    if (!explosion) return 0.0;
    const ExactFrame frame = test::exactAt(*explosion, 0.0);
    return length({frame.vx[0], frame.vy[0], frame.vz[0]});
  };
  // Surface and mass of a pane of 4 mm and of a cube of 1 m: an eighth of the surface times rho C over the mass is 1 / L.
  const struct {
    Vec3 half;
    double surface_m2, mass_kg;
  } boxes[] = {{{0.5, 0.5, 0.002}, 2.016, 10.0}, {{0.5, 0.5, 0.5}, 6.0, 2500.0}};
  double kept[2] = {};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [half, surface, mass] = boxes[i];
    const SolidModel model = modelOf(boxObj(-1.0 * half, half));
    const double vacuum = speed(model, 0.0), air = speed(model, 1e-6);
    ASSERT_GT(vacuum, 0.0);
    EXPECT_NEAR(air, vacuum / (1.0 + vacuum * 0.3 * 1.225 * 1.1 * surface / 8.0 / mass), 1e-3 * vacuum);
    kept[i] = air / vacuum;
  }
  EXPECT_LT(kept[0], 0.5);
  EXPECT_GT(kept[1], 0.99);
}

TEST(Fragments, ABurstInTheMiddleOfAPieceThrowsItUpAndNothingIsNotANumber) {
  const SolidModel model = modelOf(boxObj({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}));
  const auto whole = cut(model, 1, 1000.0);
  const Fling fling = flingOf(whole->pieces[0], {5000.0, 1.0, {}});
  EXPECT_GT(fling.velocity_mps.y, 0.0);
  EXPECT_TRUE(std::isfinite(length(fling.velocity_mps)) && std::isfinite(length(fling.spin_radps)));
}

}  // namespace
}  // namespace npsee
