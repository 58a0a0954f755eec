// Pictures that are drawn while others are simulated and written, when something throws.

#include "app/commands/render_pipeline.h"
#include "tests/support/explosions.h"
#include "tests/support/no_threads.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace npsee::commands {
namespace {

class Pipeline : public test::Rendering {
 protected:
  void SetUp() override {
    test::Rendering::SetUp();
    Preset preset;
    preset.layers.emplace_back();
    explosion_ = test::compiled(preset);
    ASSERT_TRUE(explosion_);
    job_.explosion = explosion_.get();
    job_.scene.layers = explosion_->layers();
    job_.width = 32;
    job_.height = 18;
    for (std::int64_t i = 0; i < 40; ++i) shots_.push_back({0.02 * static_cast<double>(i), i});
  }

  std::shared_ptr<const Explosion> explosion_;
  PictureJob job_;
  std::vector<Shot> shots_;
};

TEST_F(Pipeline, WhatThrowsWhileDrawingEndsTheSimulationAndIsHeard) {
  int taken = 0;
  EXPECT_THROW((void)drawPictures(*renderer_, job_, shots_, [&](const Shot&, Picture&) -> Expected<void> {
    if (++taken == 3) throw std::bad_alloc();
    return {};
  }), std::bad_alloc);
  EXPECT_EQ(taken, 3);
}

TEST_F(Pipeline, WhatThrowsWhileWritingEndsTheRunAndIsHeard) {
  for (const int threads : {1, 4}) {
    job_.threads = threads;
    std::vector<char> saved;
    EXPECT_THROW((void)savePictures(*renderer_, job_, shots_, [](std::size_t index, const Picture&, render::PngEncoder&) -> Expected<void> {
      if (index == 5) throw std::runtime_error("full");
      return {};
    }, [](std::size_t) {}, saved), std::runtime_error);
  }
}

TEST_F(Pipeline, AllIsSavedInAnyNumberOfThreads) {
  for (const int threads : {1, 3}) {
    job_.threads = threads;
    std::vector<char> saved;
    const auto done = savePictures(*renderer_, job_, shots_, [](std::size_t, const Picture& picture, render::PngEncoder&) -> Expected<void> {
      return picture.image.width == 32 ? Expected<void>() : fail(ErrorKind::output, "empty");
    }, [](std::size_t) {}, saved);
    EXPECT_TRUE(done);
    EXPECT_EQ(saved, std::vector<char>(shots_.size(), 1));
  }
}

TEST_F(Pipeline, WhereNoThreadIsGivenTheSameIsDrawnAndSaved) {
  job_.threads = 3;
  const auto pictures = [&](std::size_t broken) {
    std::vector<render::Image> out(shots_.size());
    std::vector<char> saved;
    const auto done = savePictures(*renderer_, job_, shots_, [&](std::size_t i, const Picture& picture, render::PngEncoder&) -> Expected<void> {
      if (i == broken) return fail(ErrorKind::output, "full");
      out[i] = picture.image;
      return {};
    }, [](std::size_t) {}, saved);
    EXPECT_EQ(done.has_value(), broken >= shots_.size());
    return out;
  };
  const auto together = pictures(shots_.size());
  const test::NoThreads none;
  const auto alone = pictures(shots_.size());
  for (std::size_t i = 0; i < shots_.size(); ++i) EXPECT_EQ(alone[i].rgba, together[i].rgba) << i;
  EXPECT_TRUE(pictures(5)[6].rgba.empty()) << "an error ends the run";
}

}  // namespace
}  // namespace npsee::commands
