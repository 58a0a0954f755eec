// Reading pictures of any depth safely, and judging how two differ.
#include "app/render/image_compare.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace npsee::render {
namespace {

using Values = std::array<int, 4>;

Image drawn(int width, int height, const std::function<Values(int x, int y)>& at) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int v : at(x, y)) image.rgba.push_back(static_cast<std::uint8_t>(v & 255));
  return image;
}

Image pattern(int width, int height) {
  return drawn(width, height, [](int x, int y) { return Values{x * 7 + y, 255 - y * 3, (x * y) ^ x, 255}; });
}

ImageDifference between(const Image& a, const Image& b, double over = 2.0) { return compareImages(deepened(a), deepened(b), over); }

std::string text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

TEST(ImageCompare, EqualPicturesDoNotDifferAtAll) {
  const auto d = between(pattern(40, 30), pattern(40, 30));
  EXPECT_TRUE(d.same());
  EXPECT_EQ(d.max, 0.0);
  EXPECT_EQ(d.mean, 0.0);
  EXPECT_EQ(d.ssim, 1.0);
  EXPECT_TRUE(d.worst.empty());
}

TEST(ImageCompare, CountsWhatWasChanged) {
  const Image a = pattern(50, 40);
  Image b = a;
  b.pixel(33, 21)[1] ^= 0x10;  // 16 levels
  b.pixel(2, 3)[0] ^= 0x01;    // 1 level
  const auto d = between(a, b);
  EXPECT_EQ(d.max, 16.0);
  EXPECT_DOUBLE_EQ(d.mean, 17.0 / (50 * 40 * 3));
  EXPECT_EQ(d.differing, 2u);
  EXPECT_EQ(d.over, 1u);
  EXPECT_EQ(between(a, b, 0.5).over, 2u);
  EXPECT_EQ(between(a, b, 16.0).over, 0u) << "over means above, not at";
  EXPECT_LT(d.ssim, 1.0);
  ASSERT_EQ(d.worst.size(), 2u);
  EXPECT_EQ(d.worst[0].x, 33);
  EXPECT_EQ(d.worst[0].y, 21);
  EXPECT_EQ(d.worst[0].difference, 16.0);
  EXPECT_EQ(d.worst[0].before[1], a.pixel(33, 21)[1]);
  EXPECT_EQ(d.worst[0].after[1], b.pixel(33, 21)[1]);
  EXPECT_EQ(d.worst[1].x, 2);
}

TEST(ImageCompare, NamesOnePlaceForEachOfTheWorstSquares) {
  const Image a = pattern(160, 160);
  Image b = a;
  for (auto& value : b.rgba) value = static_cast<std::uint8_t>(value ^ 1);
  for (int y = 100; y < 104; ++y)
    for (int x = 100; x < 104; ++x) b.pixel(x, y)[2] ^= 0x80;
  const auto d = between(a, b);
  ASSERT_EQ(d.worst.size(), kWorstPlaces);
  EXPECT_GE(d.worst[0].difference, 127.0);
  EXPECT_LT(d.worst[1].difference, 3.0) << "the neighbours of the worst pixel are not places of their own";
}

TEST(ImageCompare, AColourThatCannotBeSeenDoesNotCount) {
  const Image a = drawn(8, 8, [](int, int) { return Values{200, 10, 10, 0}; }), b = drawn(8, 8, [](int, int) { return Values{0, 0, 90, 0}; });
  EXPECT_TRUE(between(a, b).same());
  const Image half = drawn(8, 8, [](int, int) { return Values{200, 10, 10, 51}; });
  const auto d = between(a, half);
  EXPECT_NEAR(d.max, 51.0, 1e-9) << "alpha itself";
  EXPECT_NEAR(d.mean, (200 * 0.2 + 10 * 0.2 + 10 * 0.2 + 51) / 4.0, 1e-9);
}

/// The formula as it stands in the paper, with the whole window at once.
double plainSimilarity(const Image& a, const Image& b) {
  const auto luma = [](const Image& image, int x, int y) {
    const std::uint8_t* p = image.pixel(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
  };
  double total = 0.0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      double weight = 0, ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
      const auto each = [&](const auto& what) {
        for (int v = -5; v <= 5; ++v)
          for (int u = -5; u <= 5; ++u) what(std::exp(-(u * u + v * v) / 4.5), luma(a, x + u, y + v), luma(b, x + u, y + v));
      };
      each([&](double w, double p, double q) { weight += w, ma += w * p, mb += w * q; });
      ma /= weight, mb /= weight;
      each([&](double w, double p, double q) { va += w / weight * (p - ma) * (p - ma), vb += w / weight * (q - mb) * (q - mb), cov += w / weight * (p - ma) * (q - mb); });
      total += (2 * ma * mb + 6.5025) * (2 * cov + 58.5225) / ((ma * ma + mb * mb + 6.5025) * (va + vb + 58.5225));
    }
  return total / (a.width * a.height);
}

TEST(ImageCompare, StructuralSimilarityFollowsThePapersFormula) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 20), std::pair(31, 23)}) {
    const Image a = pattern(width, height);
    Image b = a;
    for (std::size_t i = 0; i < b.rgba.size(); i += 3) b.rgba[i] = static_cast<std::uint8_t>(b.rgba[i] * 3 / 4);
    for (std::size_t i = 3; i < b.rgba.size(); i += 4) b.rgba[i] = 255;
    EXPECT_NEAR(structuralSimilarity(deepened(a), deepened(b)), plainSimilarity(a, b), 1e-9) << width;
  }
}

TEST(ImageCompare, StructuralSimilarityTellsAShiftOfLightFromLostStructure) {
  const Image a = pattern(64, 64);
  Image brighter = a, smeared = a;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 3; ++c) {
        brighter.pixel(x, y)[c] = static_cast<std::uint8_t>(std::min(a.pixel(x, y)[c] + 8, 255));
        smeared.pixel(x, y)[c] = static_cast<std::uint8_t>((a.pixel(x, y)[c] + 128) / 2);
      }
  EXPECT_GT(structuralSimilarity(deepened(a), deepened(brighter)), structuralSimilarity(deepened(a), deepened(smeared)));
}

TEST(ImageCompare, TheDifferencePictureColoursExactlyWhatDiffers) {
  const Image a = pattern(20, 20);
  Image b = a;
  b.pixel(4, 5)[0] ^= 1;
  b.pixel(6, 7)[0] ^= 0x80;
  const Image picture = differencePicture(deepened(a), deepened(b));
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      const std::uint8_t* p = picture.pixel(x, y);
      const bool grey = p[0] == p[1] && p[1] == p[2];
      EXPECT_EQ(grey, !((x == 4 && y == 5) || (x == 6 && y == 7))) << x << ' ' << y;
      EXPECT_EQ(p[3], 255);
    }
  EXPECT_GT(picture.pixel(4, 5)[2], 200) << "one level is blue";
  EXPECT_GT(picture.pixel(6, 7)[0], 200) << "many are red";
}

TEST(ImageCompare, EachLimitOfAToleranceIsNamedWhenItIsExceeded) {
  ImageDifference d;
  d.width = d.height = 100;
  d.max = 7, d.mean = 0.5, d.ssim = 0.9, d.differing = 50, d.over = 20;
  EXPECT_EQ(exceeded(d, {}).size(), 1u) << "without limits nothing may differ";
  EXPECT_EQ(exceeded(ImageDifference{}, {}).size(), 0u);
  Tolerance tolerance;
  tolerance.max = 7, tolerance.mean = 0.5, tolerance.ssim = 0.9, tolerance.pixels = {0.002, 2.0};
  EXPECT_TRUE(exceeded(d, tolerance).empty()) << "each limit is still met";
  tolerance.max = 6.9, tolerance.mean = 0.49, tolerance.ssim = 0.901, tolerance.pixels = {0.0019, 2.0};
  EXPECT_EQ(exceeded(d, tolerance).size(), 4u);
  tolerance = {};
  tolerance.pixels = {0.01, 2.0};
  EXPECT_TRUE(exceeded(d, tolerance).empty()) << "a limit on pixels alone leaves the largest difference open";
}

TEST(DeepPng, SixteenBitsSurviveWithAndWithoutAlpha) {
  for (const bool alpha : {false, true}) {
    DeepImage image{23, 11, 16, alpha, {}};
    for (std::uint32_t i = 0; i < 23 * 11 * 4; ++i) image.rgba.push_back(i % 4 == 3 && !alpha ? 65535 : static_cast<std::uint16_t>(i * 40503));
    const auto bytes = encodeDeepPng(image);
    ASSERT_TRUE(bytes);
    EXPECT_EQ((*bytes)[24], 16) << "bit depth in the header";
    EXPECT_EQ((*bytes)[25], alpha ? 6 : 2) << "colour type";
    const auto back = parseDeepPng(text(*bytes), "a.png");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->bits, 16);
    EXPECT_EQ(back->alpha, alpha);
    EXPECT_EQ(back->rgba, image.rgba);
    EXPECT_EQ(*encodeDeepPng(*back), *bytes);
  }
  EXPECT_FALSE(encodeDeepPng(DeepImage{}));
}

TEST(DeepPng, EightBitPicturesAreReadOnTheSameScale) {
  const Image image = pattern(31, 17);
  const auto read = parseDeepPng(text(*encodePng(image)), "a.png");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->bits, 8);
  EXPECT_FALSE(read->alpha);
  EXPECT_EQ(read->rgba, deepened(image).rgba);
  EXPECT_EQ(read->rgba[0], 257 * image.rgba[0]);
}

std::uint32_t crcOf(const std::string& data) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : data) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}
std::string bigEndian(std::uint32_t value) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 255u);
  return out;
}
std::string chunk(const std::string& name, const std::string& data) { return bigEndian(static_cast<std::uint32_t>(data.size())) + name + data + bigEndian(crcOf(name + data)); }
const std::string kSignature = "\x89PNG\r\n\x1a\n";
std::string header(std::uint32_t width, std::uint32_t height, char depth, char type, char interlace = 0) {
  return kSignature + chunk("IHDR", bigEndian(width) + bigEndian(height) + std::string{depth, type, 0, 0, interlace});
}

// Each of these would take gigabytes, or forever, if it were believed.
TEST(DeepPng, ClaimsOfHugePicturesAreRefusedBeforeMemoryIsTaken) {
  const std::string data = chunk("IDAT", "\x78\x9c\x63\x60"), end = chunk("IEND", "");
  for (const auto& [file, why] : {std::pair(header(0x7fffffff, 0x7fffffff, 16, 6), "width"), std::pair(header(60000, 60000, 8, 2), "36 million"), std::pair(header(5000, 7000, 16, 6), "more pixels than it can hold"),
                                  std::pair(header(6000, 6000, 16, 6, 1), "more pixels than it can hold"), std::pair(header(0, 5, 8, 2), "width"), std::pair(header(65537, 1, 8, 2), "width")}) {
    const auto read = parseDeepPng(file + data + end, "bomb.png");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::input);
    EXPECT_NE(read.error().text().find("bomb.png"), std::string::npos);
    EXPECT_TRUE(read.error().text().find(why) != std::string::npos || why == std::string("width")) << read.error().text();
  }
}

TEST(DeepPng, TextsAndProfilesOfAFileCannotGrowWithoutBound) {
  // A good picture with a thousand texts that no reader needs.
  std::string file = text(*encodePng(pattern(4, 4)));
  const std::size_t after_header = 33;
  std::string texts;
  for (int i = 0; i < 1000; ++i) texts += chunk("tEXt", "Comment" + std::string(1, '\0') + std::string(1000, 'x'));
  file.insert(after_header, texts);
  const auto read = parseDeepPng(file, "a.png");
  EXPECT_TRUE(read) << "the pixels are what counts";
}

TEST(DeepPng, NoDamageCrashesAndEveryRefusalNamesTheFile) {
  DeepImage image{19, 13, 16, true, {}};
  for (std::uint32_t i = 0; i < 19 * 13 * 4; ++i) image.rgba.push_back(static_cast<std::uint16_t>(i * 977));
  for (const std::string& good : {text(*encodeDeepPng(image)), text(*encodePng(pattern(19, 13)))}) {
    for (std::size_t size = 0; size < good.size(); ++size) {
      const auto read = parseDeepPng(good.substr(0, size), "cut.png");
      // Without its last chunk a picture may still be whole.
      if (size + 12 < good.size()) {
        ASSERT_FALSE(read) << size;
        EXPECT_NE(read.error().text().find("cut.png"), std::string::npos);
      }
    }
    for (std::size_t at = 0; at < good.size(); ++at)
      for (const int flip : {0x01, 0x80, 0xff}) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ flip);
        (void)parseDeepPng(bad, "bad.png");
      }
  }
}

}  // namespace
}  // namespace npsee::render
