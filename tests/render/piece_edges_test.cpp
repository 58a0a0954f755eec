// Pieces with several samples among clouds with one: every pixel they cover in part shows what four samples of everything would.
#include "app/render/image_compare.h"
#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

constexpr int kWidth = 320, kHeight = 180;

class PieceEdges : public test::Rendering {
 protected:
  static Image draw(const test::HandMade& made, Quality quality = Quality::normal) {
    Scene scene;
    scene.frame = &made.frame;
    scene.layers = made.layers;
    scene.background.kind = Background::Kind::transparent;
    scene.quality = quality;
    Camera camera;
    camera.eye = {0.0, 10.0, 60.0};
    camera.target = {0.0, 10.0, 0.0};
    return picture(scene, camera, kWidth, kHeight);
  }
  /// A wall of thick smoke, twenty puffs deep from z = -10 to 10 m.
  static void addWall(test::HandMade& made) {
    for (int i = 0; i < 60; ++i) made.add(Form::smoke, {4.0 * ((i % 3) - 1), 10.0, -10.0 + 20.0 * i / 59.0}, 26.0, {0.7, 0.7, 0.7}, 0.7);
  }
  static test::HandMade behind(double z_m, double opacity = 1.0) {
    test::HandMade made;
    addWall(made);
    for (int i = 0; i < 40; ++i) made.add(Form::tetrahedron, {-6.0 + 0.3 * i, 7.0 + 0.15 * i, z_m}, 0.5, {0.1, 0.05, 0.02}, opacity);
    return made;
  }
  static int largestDifference(const Image& a, const Image& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i])));
    return most;
  }
};

TEST_F(PieceEdges, NothingOfAPieceBehindThickSmokeShinesThroughAtItsEdges) {
  test::HandMade wall;
  addWall(wall);
  const Image without = draw(wall);
  EXPECT_LE(largestDifference(draw(behind(-12.0)), without), 2);
  EXPECT_GT(largestDifference(draw(behind(12.0)), without), 60) << "in front it is seen";
}

TEST_F(PieceEdges, AmongSmokePiecesLookAsSixteenPicturesInOneDo) {
  for (const double z_m : {-8.0, 0.0, 6.0, 9.0, 12.0})
    for (const double opacity : {1.0, 0.5}) {
      const auto made = behind(z_m, opacity);
      const auto d = compareImages(deepened(draw(made)), deepened(draw(made, Quality::fine)));
      EXPECT_GT(d.ssim, 0.99) << z_m << " m, opacity " << opacity;
      EXPECT_LT(d.mean, 0.3) << z_m << " m, opacity " << opacity;
    }
}

TEST_F(PieceEdges, ThePixelsOfAnEdgeInFrontOfSmokeAreMixedByTheirCover) {
  // A white disc over black smoke: quarters of the pixel.
  test::HandMade made;
  for (int i = 0; i < 30; ++i) made.add(Form::smoke, {0.0, 10.0, -10.0 - 0.1 * i}, 50.0, {0.0, 0.0, 0.0}, 0.95);
  const Image smoke = draw(made);
  made.add(Form::sphere, {0.0, 10.0, 8.0}, 8.0, {1.0, 1.0, 1.0});
  const Image image = draw(made);
  int between = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 1; x + 1 < kWidth; ++x) {
      const auto brightness = [&](const Image& picture, int column) { return static_cast<int>(picture.pixel(column, y)[1]); };
      EXPECT_GE(brightness(image, x) + 2, brightness(smoke, x)) << "no darker rim at " << x << "," << y;
      EXPECT_GE(image.pixel(x, y)[3] + 2, smoke.pixel(x, y)[3]) << "no hole at " << x << "," << y;
      between += brightness(image, x) > brightness(smoke, x) + 15 && brightness(image, x) + 15 < std::max(brightness(image, x - 1), brightness(image, x + 1));
    }
  EXPECT_GT(between, 20) << "smooth edges";
}

TEST_F(PieceEdges, OfTwoPiecesInAPixelSmokeBetweenThemCoversTheOneBehind) {
  // Seen past the edge of a near piece, the far one is as dim as beside it.
  const auto scene = [](bool near) {
    test::HandMade made;
    made.add(Form::sphere, {0.0, 10.0, -12.0}, 16.0, {1.0, 0.1, 0.1});
    addWall(made);
    if (near) made.add(Form::sphere, {0.0, 10.0, 12.0}, 3.0, {0.1, 0.1, 1.0});
    return made;
  };
  const Image far_alone = draw(scene(false)), both = draw(scene(true));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) EXPECT_LE(both.pixel(x, y)[0], far_alone.pixel(x, y)[0] + 3) << "red shines at " << x << "," << y;
}

TEST_F(PieceEdges, APictureDoesNotDependOnTheEdgesOfTheOneBefore) {
  const auto made = behind(6.0);
  const Image first = draw(made);
  draw(behind(12.0));
  draw(behind(0.0, 0.4));
  EXPECT_EQ(draw(made).rgba, first.rgba);
}

}  // namespace
}  // namespace npsee::render
