#include "app/render/image.h"
#include "app/render/png_encoder.h"
#include "app/render/png_text.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

namespace npsee::render {
namespace {

Image gradient(int width, int height, bool with_alpha) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int v : {x * 7 + y, y * 3, x ^ y, with_alpha ? x + y : 255}) image.rgba.push_back(static_cast<std::uint8_t>(v & 255));
  return image;
}

TEST(Png, PicturesSurviveWithAndWithoutAlpha) {
  const test::TemporaryFolder folder;
  for (const bool with_alpha : {false, true}) {
    const Image image = gradient(37, 19, with_alpha);
    ASSERT_TRUE(writePng(image, folder / "a.png"));
    const auto back = readPng(folder / "a.png");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->width, 37);
    EXPECT_EQ(back->height, 19);
    EXPECT_EQ(back->rgba, image.rgba);
    // Colour type in the header: 2 is RGB, 6 RGB with alpha.
    EXPECT_EQ(test::slurp(folder / "a.png").at(25), with_alpha ? 6 : 2);
  }
}

TEST(Png, EqualPicturesGiveEqualBytes) { EXPECT_EQ(*encodePng(gradient(64, 48, true)), *encodePng(gradient(64, 48, true))); }

Image noise(int width, int height) {
  std::mt19937 random(7);
  Image image{width, height, {}};
  image.rgba.resize(4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::uint8_t& value : image.rgba) value = static_cast<std::uint8_t>(random() & 255u);
  return image;
}

TEST(Png, PicturesOfAnyShapeAndContentSurvive) {
  const test::TemporaryFolder folder;
  // One pixel; bands of one row, of some rows with a remainder, of all rows; nothing that could be compressed.
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(16384, 3), std::pair(1280, 50), std::pair(3, 9000), std::pair(700, 700)}) {
    const Image image = noise(width, height);
    ASSERT_TRUE(writePng(image, folder / "a.png"));
    const auto back = readPng(folder / "a.png");
    ASSERT_TRUE(back) << width << " x " << height << ": " << back.error().text();
    EXPECT_EQ(back->rgba, image.rgba) << width << " x " << height;
  }
}

TEST(Png, AnEncoderGivesThePicturesOwnBytesWhateverCameBefore) {
  PngEncoder encoder;
  Image image = gradient(1280, 100, false);
  std::mt19937 random(11);
  for (int turn = 0; turn < 30; ++turn) {
    // Other pixels here and there, sometimes an alpha below 255 that makes it another kind of picture, sometimes another size.
    for (int change = turn % 4; change > 0; --change) image.rgba[random() % image.rgba.size()] ^= static_cast<std::uint8_t>(1u << (random() % 8u));
    if (turn == 10) image = gradient(1280, 100, true);
    if (turn == 17) image = gradient(640, 200, true);
    if (turn == 23) image = gradient(640, 200, false);
    const auto in_sequence = encoder.encode(image), alone = encodePng(image);
    ASSERT_TRUE(in_sequence && alone);
    EXPECT_EQ(*in_sequence, *alone) << turn;
  }
}

TEST(Png, AnEmptyPictureIsRefused) {
  EXPECT_FALSE(encodePng(Image{}));
  EXPECT_FALSE(encodePng(Image{4, 4, {}}));
}

TEST(Png, DamagedAndForeignFilesAreRefusedWithTheirName) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writePng(gradient(64, 64, true), folder / "good.png"));
  const std::string good = test::slurp(folder / "good.png");
  test::spill(folder / "short.png", good.substr(0, good.size() / 2));
  test::spill(folder / "text.png", "not a picture");
  test::spill(folder / "empty.png", "");
  std::string broken = good;
  broken[good.size() / 2] = static_cast<char>(broken[good.size() / 2] ^ 0x55);
  test::spill(folder / "broken.png", broken);
  // A header that claims 2^31 - 1 pixels a side must not make us ask for that memory.
  std::string huge = good;
  for (const std::size_t at : {16u, 20u}) huge.replace(at, 4, std::string("\x7f\xff\xff\xff", 4));
  test::spill(folder / "huge.png", huge);
  for (const char* name : {"short.png", "text.png", "empty.png", "broken.png", "huge.png", "missing.png"}) {
    const auto image = readPng(folder / name);
    ASSERT_FALSE(image) << name;
    EXPECT_EQ(image.error().kind, ErrorKind::input);
    EXPECT_NE(image.error().text().find(name), std::string::npos) << image.error().text();
  }
}

TEST(Png, AnUnwritablePlaceIsAnOutputErrorAndLeavesNothing) {
  const test::TemporaryFolder folder;
  const auto written = writePng(gradient(8, 8, false), folder / "no/such/a.png");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::output);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Png, ATextIsFoundInWholeFilesOnlyAndLeavesThePixelsAlone) {
  const test::TemporaryFolder folder;
  std::vector<std::uint8_t> bytes = *encodePng(gradient(20, 10, true));
  const std::string plain(bytes.begin(), bytes.end());
  insertPngText(bytes, "a key", "a text");
  const std::string with(bytes.begin(), bytes.end());
  EXPECT_EQ(textOfWholePng(with, "a key"), "a text");
  EXPECT_EQ(textOfWholePng(with, "a ke"), std::nullopt);
  EXPECT_EQ(textOfWholePng(plain, "a key"), std::nullopt);
  test::spill(folder / "a.png", with);
  EXPECT_EQ(readPng(folder / "a.png")->rgba, gradient(20, 10, true).rgba);
  for (std::size_t size = 0; size < with.size(); ++size) EXPECT_EQ(textOfWholePng(with.substr(0, size), "a key"), std::nullopt) << size;
  for (std::size_t at = 0; at < with.size(); ++at) {
    std::string bad = with;
    bad[at] = static_cast<char>(bad[at] ^ 4);
    EXPECT_EQ(textOfWholePng(bad, "a key"), std::nullopt) << at;
  }
  EXPECT_EQ(textOfWholePng(with + "x", "a key"), std::nullopt);
}

}  // namespace
}  // namespace npsee::render
