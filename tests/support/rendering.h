#pragma once

#include "app/gl/context.h"
#include "app/gl/objects.h"
#include "app/render/renderer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <utility>

namespace npsee::test {

/// One context and renderer for all tests of a suite: making them costs more than drawing. No test may leave a GL error behind.
class Rendering : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gl::makeOffscreenContext();
    ASSERT_TRUE(made) << made.error().text();
    context_ = std::move(*made);
    auto renderer = render::Renderer::create();
    ASSERT_TRUE(renderer) << renderer.error().text();
    renderer_ = std::move(*renderer);
  }
  static void TearDownTestSuite() {
    renderer_.reset();
    context_.reset();
  }
  void SetUp() override { ASSERT_NE(renderer_, nullptr); }
  void TearDown() override { EXPECT_EQ(gl::pendingError(), nullptr); }

  /// What the renderer draws of a scene; empty, and the test failed, where it cannot.
  template <class... Arguments>
  static render::Image picture(const Arguments&... arguments) {
    auto image = renderer_->drawToImage(arguments...);
    EXPECT_TRUE(image) << (image ? "" : image.error().text());
    return image ? std::move(*image) : render::Image{};
  }

  static inline std::unique_ptr<gl::Context> context_;
  static inline std::unique_ptr<render::Renderer> renderer_;
};

/// Perceived brightness of a pixel, 0..255.
inline double brightness(const std::uint8_t* p) { return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]; }

}  // namespace npsee::test
