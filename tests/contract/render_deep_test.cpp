// 16-bit PNG and OpenEXR with its passes, measured in their pixels.
#include "app/render/camera.h"
#include "app/render/deep_image.h"
#include "app/render/exr.h"
#include "app/render/image_compare.h"
#include "tests/support/render_command.h"

#include <npsee/vec3.h>

#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace npsee {
namespace {

namespace fs = std::filesystem;
using test::Words;

constexpr int kWidth = 160, kHeight = 90;
constexpr double kPi = 3.14159265358979323846;

/// The camera formula by itself: a point's place in the picture (from the left and the top) and its depth.
struct Projection {
  Vec3 eye, right, up, forward;
  double scale;  ///< pixels per metre at one metre

  Projection(const Vec3& from, const Vec3& to, double fov_y_deg) : eye(from), scale(0.5 * kHeight / std::tan(0.5 * fov_y_deg * kPi / 180.0)) {
    const Vec3 way = to - from;
    forward = (1.0 / length(way)) * way;
    const Vec3 across = cross(forward, {0.0, 1.0, 0.0});
    right = (1.0 / length(across)) * across;
    up = cross(right, forward);
  }
  double depth(const Vec3& p) const { return dot(forward, p - eye); }
  double x(const Vec3& p) const { return 0.5 * kWidth + scale * dot(right, p - eye) / depth(p); }
  double y(const Vec3& p) const { return 0.5 * kHeight - scale * dot(up, p - eye) / depth(p); }
  /// The ray through a pixel's centre, as long as one metre of depth.
  Vec3 ray(int px, int py) const { return forward + ((px + 0.5 - 0.5 * kWidth) / scale) * right + ((0.5 * kHeight - py - 0.5) / scale) * up; }
};

class RenderDeep : public test::RenderFixture {
 protected:
  /// One particle, `more` being the rest of its layer.
  void oneParticle(const std::string& burst, const std::string& more) const {
    test::spill(preset("dot"), R"({"npsee": 1, "gravity": 0, )" + burst + R"("layers": [{"name": "dot", "count": 1, "region": {"shape": "point"}, "speed_deviation": 0, "size_deviation": 0, "ejection_angle": 0, "trajectory": "linear",
      "lifetime_mean": 60, "lifetime_deviation": 0, )" + more + "}]}");
  }
  static Words sized(const std::string& file, Words words) {
    words.insert(words.begin(), {file, "--size", std::to_string(kWidth) + 'x' + std::to_string(kHeight)});
    return words;
  }
  std::string bytes(const std::string& file, Words words, const std::string& name) const {
    words.insert(words.end(), {"-o", folder_ / name});
    const auto result = render(sized(file, words));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return test::slurp(folder_ / name);
  }
  render::FloatImage exr(const std::string& file, const Words& words) const {
    auto picture = render::parseExr(bytes(file, words, "a.exr"), "a.exr");
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().text());
    return picture ? picture->image : render::FloatImage{};
  }
  render::DeepImage png(const std::string& file, const Words& words) const {
    auto picture = render::parseDeepPng(bytes(file, words, "a.png"), "a.png");
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().text());
    return picture ? *picture : render::DeepImage{};
  }
  static std::size_t at(int x, int y) { return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x); }
};

// IEC 61966-2-1.
double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

TEST_F(RenderDeep, SixteenBitsAreTheEightBitPictureMoreFinely) {
  for (const char* background : {"sky", "transparent", "white", "#306090", "draft"}) {
    Words words{"--time", "0.4", "--background", background};
    if (std::string_view(background) == "draft") words = {"--time", "0.4", "--quality", "draft"};
    const auto plain = png(preset("small"), words);
    words.insert(words.end(), {"--bits", "16"});
    const auto deep = png(preset("small"), words);
    EXPECT_EQ(deep.bits, 16);
    EXPECT_EQ(deep.alpha, plain.alpha) << background;
    ASSERT_EQ(deep.rgba.size(), plain.rgba.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < deep.rgba.size(); ++i) worst = std::max(worst, std::abs(deep.rgba[i] - plain.rgba[i]) / 257.0);
    if (std::string_view(background) == "draft") {
      EXPECT_GT(render::compareImages(plain, deep).ssim, 0.95) << "enlarged before it is finished, and after";
    } else {
      EXPECT_LE(worst, 0.52) << background << ": half a level, and the rounding of the deeper picture";
    }
  }
}

TEST_F(RenderDeep, SixteenBitsShowStepsThatEightBitsCannot) {
  const auto image = png(preset("small"), {"--time", "9", "--bits", "16"});
  std::set<std::uint16_t> blues;
  for (std::size_t i = 2; i < image.rgba.size(); i += 4) blues.insert(image.rgba[i]);
  const auto plain = png(preset("small"), {"--time", "9"});
  std::set<std::uint16_t> plain_blues;
  for (std::size_t i = 2; i < plain.rgba.size(); i += 4) plain_blues.insert(plain.rgba[i]);
  EXPECT_GT(blues.size(), 4 * plain_blues.size());
}

TEST_F(RenderDeep, SixteenBitsKeepAlpha) {
  const auto image = png(preset("small"), {"--time", "0.4", "--bits", "16", "--background", "transparent"});
  EXPECT_TRUE(image.alpha);
  EXPECT_EQ(image.pixel(0, 0)[3], 0);
  std::set<std::uint16_t> alphas;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) alphas.insert(image.rgba[i]);
  EXPECT_TRUE(alphas.contains(65535));
  EXPECT_GE(alphas.size(), 3u) << "edges are partly covered";
}

TEST_F(RenderDeep, AnExrHoldsLinearLight) {
  const auto image = exr(preset("small"), {"--time", "0.4", "--background", "#306090"});
  ASSERT_EQ(image.rgba.size(), 4u * kWidth * kHeight);
  EXPECT_TRUE(image.depth.empty());
  EXPECT_TRUE(image.motion.empty());
  // Half floats have 11 bits.
  const double behind[] = {linear(48.0 / 255.0), linear(96.0 / 255.0), linear(144.0 / 255.0)};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(image.rgba[c], behind[c], behind[c] / 1000.0) << c;
  EXPECT_EQ(image.rgba[3], 1.0f);
}

TEST_F(RenderDeep, TheSkyOfAnExrBecomesThatOfThePngWhenItIsFinishedAlike) {
  const auto light = exr(preset("small"), {"--time", "9"});
  const auto plain = png(preset("small"), {"--time", "9"});
  double worst = 0.0;
  for (std::size_t i = 0; i < light.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    // shaders/srgb.glsl: rolled off above the knee, coded by IEC 61966-2-1.
    double c = static_cast<double>(light.rgba[i]);
    const double over = std::max(c - 0.8, 0.0) / 0.2;
    c = std::min(c, 0.8) + 0.2 * over / (1.0 + over);
    c = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
    worst = std::max(worst, std::abs(255.0 * c - plain.rgba[i] / 257.0));
  }
  EXPECT_LE(worst, 0.6);
}

TEST_F(RenderDeep, LightBrighterThanAScreenIsKept) {
  oneParticle("", R"("speed_mean": 0, "size_mean": 3, "form": "flash", "colour": "#ffffff")");
  const auto image = exr(preset("dot"), {"--time", "0.1", "--background", "transparent"});
  EXPECT_GT(*std::ranges::max_element(image.rgba), 2.0f);
  float most_cover = 0.0f;
  bool halo = false;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    most_cover = std::max(most_cover, image.rgba[i + 3]);
    halo = halo || (image.rgba[i] > 0.01f && image.rgba[i + 3] == 0.0f);
  }
  EXPECT_LE(most_cover, 1.0f);
  EXPECT_TRUE(halo) << "light without cover, as premultiplied pictures can hold it";
}

TEST_F(RenderDeep, AnotherProgramReadsTheSameValues) {
  const auto image = exr(preset("small"), {"--time", "0.4"});
  const auto result = test::run("/usr/bin/ffmpeg", {"-v", "error", "-i", folder_ / "a.exr", "-f", "rawvideo", "-pix_fmt", "gbrapf32le", "-y", folder_ / "planes"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string planes = test::slurp(folder_ / "planes");
  const std::size_t pixels = kWidth * kHeight;
  ASSERT_EQ(planes.size(), 4 * sizeof(float) * pixels);
  const std::size_t plane_of[] = {2, 0, 1, 3};  // green, blue, red, alpha
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t i = 0; i < pixels; ++i) {
      float value = 0.0f;
      std::memcpy(&value, planes.data() + sizeof value * (plane_of[c] * pixels + i), sizeof value);
      ASSERT_EQ(value, image.rgba[4 * i + c]) << "channel " << c << ", pixel " << i;
    }
}

TEST_F(RenderDeep, TheDepthOfTheGroundFollowsFromTheCamera) {
  const auto image = exr(preset("small"), {"--time", "9", "--set", "ground.height=2", "--camera", "eye=3,12,40 target=-1,4,0 fov=50deg", "--pass", "depth"});
  EXPECT_TRUE(image.rgba.empty()) << "only what is asked for";
  ASSERT_EQ(image.depth.size(), static_cast<std::size_t>(kWidth * kHeight));
  const Projection camera({3.0, 12.0, 40.0}, {-1.0, 4.0, 0.0}, 50.0);
  int ground = 0, sky = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double down = camera.ray(x, y).y, depth = static_cast<double>(image.depth[at(x, y)]);
      if (down > 1e-4) {
        EXPECT_TRUE(std::isinf(depth)) << x << ' ' << y;
        ++sky;
      } else if (down < -1e-3) {
        const double expected = (2.0 - 12.0) / down;
        // Near the horizon the angle is a small difference of single-precision numbers.
        EXPECT_NEAR(depth, expected, 1e-6 * expected / -down) << x << ' ' << y;
        ++ground;
      }
    }
  EXPECT_GT(ground, 4000);
  EXPECT_GT(sky, 500);
}

TEST_F(RenderDeep, TheDepthOfAPieceIsItsDistanceAndTheNearestCounts) {
  const Words view{"--time", "1", "--camera", "eye=0,20,30 target=0,20,0", "--pass", "depth", "--background", "transparent"};
  oneParticle(R"("burst": "air", "burst_height": 20, )", R"("speed_mean": 0, "size_mean": 4, "form": "sphere")");
  const auto one = exr(preset("dot"), view);
  // A ball of 4 m about (0, 20, 0); its facets lie within the round ball.
  EXPECT_GE(one.depth[at(kWidth / 2, kHeight / 2)], 28.0f - 1e-3f);
  EXPECT_LT(one.depth[at(kWidth / 2, kHeight / 2)], 28.15f);
  EXPECT_TRUE(std::isinf(one.depth[0])) << "nothing is behind";
  // A larger one behind it changes nothing where the first is, and is seen beside it.
  const std::string ball = R"("count": 1, "speed_mean": 0, "speed_deviation": 0, "size_deviation": 0, "lifetime_mean": 60, "lifetime_deviation": 0, "form": "sphere", "trajectory": "linear", )";
  test::spill(preset("dot"), R"({"npsee": 1, "gravity": 0, "burst": "air", "burst_height": 20, "layers": [
    {"name": "near", "size_mean": 4, "region": {"shape": "point"}, )" + ball + R"("enabled": true},
    {"name": "far", "size_mean": 16, "region": {"shape": "point", "offset": [0, 0, -20]}, )" + ball + R"("enabled": true}]})");
  const auto two = exr(preset("dot"), view);
  EXPECT_NEAR(two.depth[at(kWidth / 2, kHeight / 2)], one.depth[at(kWidth / 2, kHeight / 2)], 0.15) << "it is turned otherwise";
  const int beside = kHeight / 2 - 14;
  const Vec3 ray = Projection({0.0, 20.0, 30.0}, {0.0, 20.0, 0.0}, 40.0).ray(kWidth / 2, beside);
  // |t ray - 50 forward| = 8
  const double a = dot(ray, ray), expected = (50.0 - std::sqrt(2500.0 - a * (2500.0 - 64.0))) / a;
  // Its facets lie within the round ball, by up to a twentieth of its radius; the ray is oblique.
  EXPECT_GE(two.depth[at(kWidth / 2, beside)], expected - 1e-3);
  EXPECT_LT(two.depth[at(kWidth / 2, beside)], expected + 0.8);
  EXPECT_TRUE(std::isinf(one.depth[at(kWidth / 2, beside)]));
}

TEST_F(RenderDeep, SmokeIsASurfaceWhereItCoversHalf) {
  const Words view{"--time", "1", "--camera", "eye=0,5,30 target=0,5,0", "--pass", "depth"};
  const std::string air = R"("burst": "air", "burst_height": 5, )", layer = R"("speed_mean": 0, "size_mean": 4, "form": "smoke", "opacity": )";
  const std::size_t place = at(kWidth / 2, kHeight / 2 - 4);  // against the sky
  oneParticle(air, layer + "1");
  EXPECT_NEAR(exr(preset("dot"), view).depth[place], 30.0, 1e-3);
  oneParticle(air, layer + "0.3");
  EXPECT_TRUE(std::isinf(exr(preset("dot"), view).depth[place])) << "the sky behind thin smoke";
}

// Neither alone would be a surface; together they cover 0.64.
TEST_F(RenderDeep, ThinPuffsAddUpAndTheNearerOneCountsForMore) {
  const std::string puff = R"("count": 1, "speed_mean": 0, "speed_deviation": 0, "size_mean": 6, "size_deviation": 0, "lifetime_mean": 60, "lifetime_deviation": 0, "form": "smoke", "opacity": 0.4, "trajectory": "linear", )";
  test::spill(preset("dot"), R"({"npsee": 1, "gravity": 0, "burst": "air", "burst_height": 20, "layers": [
    {"name": "near", )" + puff + R"("region": {"shape": "point"}},
    {"name": "far", )" + puff + R"("region": {"shape": "point", "offset": [0, 0, -10]}}]})");
  const Words view{"--time", "1", "--camera", "eye=0,20,30 target=0,20,0", "--background", "transparent", "--pass", "colour,depth"};
  const auto image = exr(preset("dot"), view);
  int seen = 0;
  for (std::size_t i = 0; i < image.depth.size(); ++i) {
    const double cover = static_cast<double>(image.rgba[4 * i + 3]), depth = static_cast<double>(image.depth[i]);
    if (cover < 0.499) {
      EXPECT_TRUE(std::isinf(depth)) << i;
    } else if (cover > 0.501) {
      // Both puffs are in their own plane: w at 30 m and (1 - w) of the cover at 40 m.
      EXPECT_GT(depth, 30.0) << i;
      EXPECT_LT(depth, 40.0) << i;
      ++seen;
    }
    if (cover > 0.63) {
      EXPECT_NEAR(depth, (0.4 * 30.0 + 0.6 * 0.4 * 40.0) / 0.64, 0.15) << "in the full middle of both";
    }
  }
  EXPECT_GT(seen, 10);
}

TEST_F(RenderDeep, MotionIsTheVelocityOnThePicture) {
  // 12 m/s straight up, seen from the side, from below and off the axis.
  oneParticle("", R"("speed_mean": 12, "size_mean": 2, "form": "sphere")");
  for (const auto& [text, camera] : {std::pair<std::string, Projection>{"eye=0,6,30 target=0,6,0 fov=40deg", {{0, 6, 30}, {0, 6, 0}, 40.0}}, {"eye=-8,1,12 target=1,7,-1 fov=60deg", {{-8, 1, 12}, {1, 7, -1}, 60.0}}}) {
    const auto image = exr(preset("dot"), {"--time", "0.5", "--fps", "25", "--camera", text, "--pass", "motion,depth"});
    ASSERT_EQ(image.motion.size(), 2u * kWidth * kHeight);
    int pieces = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float right = image.motion[2 * at(x, y)], up = image.motion[2 * at(x, y) + 1];
        const Vec3 place = camera.eye + static_cast<double>(image.depth[at(x, y)]) * camera.ray(x, y);
        if (!(length(place - Vec3{0.0, 6.0, 0.0}) < 1.01)) {
          EXPECT_EQ(right, 0.0f) << x << ' ' << y << ": ground and sky stand still";
          EXPECT_EQ(up, 0.0f);
          continue;
        }
        const Vec3 next = place + Vec3{0.0, 12.0 / 25.0, 0.0};
        EXPECT_NEAR(right, camera.x(next) - camera.x(place), 2e-3) << x << ' ' << y;
        EXPECT_NEAR(up, camera.y(place) - camera.y(next), 2e-3) << x << ' ' << y;
        ++pieces;
      }
    EXPECT_GT(pieces, 25);
  }
}

TEST_F(RenderDeep, MotionLeadsToWhereTheNextFrameShowsThePiece) {
  oneParticle("", R"("speed_mean": 12, "size_mean": 2, "form": "sphere")");
  const auto result = render(sized(preset("dot"), {"--frames", "0.4:0.6", "--fps", "20", "--camera", "eye=0,6,30 target=0,6,0", "--background", "transparent", "--pass", "colour,motion", "-o", folder_ / "m_%02d.exr"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto centre = [&](const std::string& name) {
    const auto image = render::parseExr(test::slurp(folder_ / name), name)->image;
    double x = 0.0, y = 0.0, u = 0.0, v = 0.0, sum = 0.0, moving = 0.0;
    for (int py = 0; py < kHeight; ++py)
      for (int px = 0; px < kWidth; ++px) {
        const double a = static_cast<double>(image.rgba[4 * at(px, py) + 3]);
        x += a * px, y -= a * py, sum += a;
        if (image.motion[2 * at(px, py) + 1] == 0.0f) continue;
        u += static_cast<double>(image.motion[2 * at(px, py)]), v += static_cast<double>(image.motion[2 * at(px, py) + 1]), moving += 1.0;
      }
    return std::array<double, 4>{x / sum, y / sum, u / moving, v / moving};
  };
  const auto first = centre("m_08.exr"), second = centre("m_09.exr");
  EXPECT_GT(first[3], 2.0);
  // The face of the ball is nearer than its middle, which the outline follows: some hundredths.
  EXPECT_NEAR(second[0] - first[0], first[2], 0.1);
  EXPECT_NEAR(second[1] - first[1], first[3], 0.1);
}

TEST_F(RenderDeep, MotionIsMeasuredOverAFrame) {
  oneParticle("", R"("speed_mean": 12, "size_mean": 2, "form": "sphere")");
  const auto most = [&](const Words& more) {
    Words words{"--time", "0.5", "--camera", "eye=0,6,300 target=0,6,0 fov=5deg", "--pass", "motion"};
    words.insert(words.end(), more.begin(), more.end());
    const auto image = exr(preset("dot"), words);
    return *std::ranges::max_element(image.motion);
  };
  const float usual = most({});
  EXPECT_GT(usual, 1.0f);
  EXPECT_EQ(most({"--fps", "30"}), usual);
  EXPECT_NEAR(most({"--fps", "60"}), 0.5f * usual, 0.01f);
}

TEST_F(RenderDeep, EveryFormHasDepthAndMotion) {
  for (const char* form : {"tetrahedron", "disc", "sphere", "shard", "streak", "smoke", "fire", "flash"}) {
    oneParticle("", std::string(R"("speed_mean": 12, "size_mean": 3, "form": ")") + form + '"');
    const auto image = exr(preset("dot"), {"--time", "0.5", "--camera", "eye=0,6,30 target=0,6,0", "--pass", "depth,motion", "--background", "transparent"});
    int seen = 0;
    for (std::size_t i = 0; i < image.depth.size(); ++i) {
      EXPECT_FALSE(std::isnan(image.depth[i]));
      if (std::isinf(image.depth[i])) continue;
      ++seen;
      EXPECT_GT(image.motion[2 * i + 1], 0.5f) << form;
    }
    EXPECT_GE(seen, 3) << form;
  }
}

TEST_F(RenderDeep, BytesDoNotDependOnThreadsShardsOrOrder) {
  for (const Words& kind : std::vector<Words>{{"--format", "exr", "--pass", "colour,depth,motion"}, {"--bits", "16"}}) {
    const auto frames = [&](const std::string& name, Words more) {
      more.insert(more.begin(), kind.begin(), kind.end());
      more.insert(more.end(), {"--frames", "0:0.6", "--fps", "10", "-o", folder(name)});
      EXPECT_EQ(render(sized(preset("small"), more)).exit_code, 0);
    };
    frames("whole", {"-j", "1"});
    for (const char* shard : {"3/3", "1/3", "2/3"}) frames("parts", {"--shard", shard, "-j", "5"});
    EXPECT_EQ(files("whole").size(), 6u);
    EXPECT_EQ(files("parts"), files("whole"));
    for (const std::string& name : files("whole")) EXPECT_EQ(test::slurp(folder_ / ("whole/" + name)), test::slurp(folder_ / ("parts/" + name))) << name;
    fs::remove_all(folder_ / "whole");
    fs::remove_all(folder_ / "parts");
  }
}

TEST_F(RenderDeep, ResumeAndVerifyKnowWholeFilesFromDamagedAndForeignOnes) {
  for (const Words& kind : std::vector<Words>{{"-o", folder_ / "a.exr", "--pass", "colour,depth"}, {"-o", folder_ / "a.png", "--bits", "16"}}) {
    const auto run = [&](const Words& more) {
      Words words = kind;
      words.insert(words.end(), more.begin(), more.end());
      return render(sized(preset("small"), words));
    };
    expect(run({"--resume"}), 0, {kind[1]});
    EXPECT_EQ(run({"--resume"}).out, "");
    EXPECT_EQ(run({"--verify"}).exit_code, 0);
    const std::string whole = test::slurp(kind[1]);
    std::string flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 4);
    for (const std::string& damaged : {whole.substr(0, whole.size() / 2), whole.substr(0, 300), flipped, std::string("no picture")}) {
      test::spill(kind[1], damaged);
      expect(run({"--verify"}), 1, {kind[1]});
    }
    expect(run({"--resume"}), 0, {kind[1]});
    EXPECT_EQ(test::slurp(kind[1]), whole);
    expect(run({"--verify", "--seed", "3"}), 1, {kind[1]});
    if (kind[2] == "--pass") {
      expect(run({"--verify", "--pass", "depth"}), 2, {}, {"--pass"});
    }
  }
}

TEST_F(RenderDeep, LargePicturesAreWrittenInBandsAndAreTheSameAsSmallOnes) {
  // Just above what is held whole.
  const Words words{preset("small"), "--time", "0.4", "--size", "1601x1565", "--background", "transparent"};
  const auto run = [&](const std::string& name, Words more) {
    more.insert(more.begin(), words.begin(), words.end());
    more.insert(more.end(), {"-o", folder_ / name});
    return render(more);
  };
  EXPECT_EQ(run("plain.png", {}).exit_code, 0);
  EXPECT_EQ(run("deep.png", {"--bits", "16"}).exit_code, 0);
  EXPECT_EQ(run("all.exr", {"--pass", "colour,depth,motion"}).exit_code, 0);
  const auto plain = render::readDeepPng(folder_ / "plain.png"), deep = render::readDeepPng(folder_ / "deep.png");
  ASSERT_TRUE(plain && deep);
  EXPECT_EQ(deep->bits, 16);
  ASSERT_EQ(deep->rgba.size(), plain->rgba.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < deep->rgba.size(); ++i) worst = std::max(worst, std::abs(deep->rgba[i] - plain->rgba[i]) / 257.0);
  EXPECT_LE(worst, 0.52);
  const auto picture = render::parseExr(test::slurp(folder_ / "all.exr"), "all.exr");
  ASSERT_TRUE(picture) << picture.error().text();
  EXPECT_EQ(picture->image.height, 1565);
  // Depth is where cover is, in every band.
  std::size_t covered = 0, deep_enough = 0;
  for (std::size_t i = 0; i < picture->image.depth.size(); ++i) {
    if (picture->image.rgba[4 * i + 3] < 0.99f) continue;
    ++covered;
    deep_enough += std::isfinite(picture->image.depth[i]);
  }
  EXPECT_GT(covered, 1000u);
  EXPECT_GT(static_cast<double>(deep_enough), 0.99 * static_cast<double>(covered));
  // Whole files are known again, cut ones are not, and a device is no place for what is put together.
  EXPECT_EQ(run("all.exr", {"--pass", "colour,depth,motion", "--verify"}).exit_code, 0);
  EXPECT_EQ(run("deep.png", {"--bits", "16", "--verify"}).exit_code, 0);
  const std::string whole = test::slurp(folder_ / "all.exr");
  test::spill(folder_ / "all.exr", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(run("all.exr", {"--pass", "colour,depth,motion", "--verify"}).exit_code, 1);
  const auto device = render({preset("small"), "--size", "1601x1565", "--bits", "16", "-o", "/dev/full"});
  EXPECT_EQ(device.exit_code, 5);
  EXPECT_NE(device.err.find("regular file"), std::string::npos) << device.err;
}

TEST_F(RenderDeep, WhatCannotBeMeantExitsTwo) {
  const std::string out = folder_ / "a.png", exr = folder_ / "a.exr";
  expect(small({"-o", out, "--bits", "12"}), 2, {}, {"--bits 12", "8 or 16"});
  expect(small({"-o", exr, "--bits", "16"}), 2, {}, {"--bits 16", "PNG"});
  expect(small({"-o", folder_ / "a.mp4", "--bits", "16"}), 2, {}, {"--bits 16"});
  expect(small({"-o", out, "--pass", "depth"}), 2, {}, {"--pass depth", "OpenEXR", ".exr"});
  expect(small({"-o", exr, "--pass", "dept"}), 2, {}, {"no pass \"dept\"", "colour, depth, motion"});
  expect(small({"-o", exr, "--pass", "depth,"}), 2, {}, {"no pass \"\""});
  expect(small({"-o", exr, "--sheet", "2x2"}), 2, {}, {"8-bit PNG"});
  expect(small({"-o", exr, "--template"}), 2, {}, {"8-bit PNG"});
  expect(small({"-o", out, "--template", "--bits", "16"}), 2, {}, {"--bits 16", "8-bit PNG"});
  expect(small({"-o", exr, "--fps", "25"}), 2, {}, {"no sequence is asked for"});
  expect(small({"-o", exr, "--fps", "25", "--pass", "depth"}), 2, {}, {"no sequence is asked for"});
  expect(small({"-o", exr, "--golden", folder("g")}), 2, {}, {"goldens are PNG pictures of 8 bits"});
  expect(small({"-o", out, "--bits", "16", "--golden", folder("g")}), 2, {}, {"goldens are PNG pictures of 8 bits"});
  fs::remove(folder_ / "g");
  EXPECT_TRUE(files().empty());
}

TEST_F(RenderDeep, PlacesThatCannotBeWrittenExitFive) {
  expect(small({"-o", folder_ / "no/a.exr"}), 5, {}, {"no/a.exr", "does not exist"});
  expect(small({"-o", "/dev/full", "--format", "exr"}), 5, {}, {"/dev/full"});
}

}  // namespace
}  // namespace npsee
