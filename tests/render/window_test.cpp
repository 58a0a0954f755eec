#include "app/render/renderer.h"
#include "tests/support/display.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace npsee::render {
namespace {

/// A scene with every form, shadows, grid and sky.
Image drawEverything() {
  test::HandMade made;
  int place = 0;
  for (const Form form : {Form::tetrahedron, Form::disc, Form::sphere, Form::shard, Form::streak, Form::smoke, Form::fire, Form::flash}) {
    const double x = -14.0 + 4.0 * place++;
    made.add(form, {x, 2.5, 0.0}, 3.0, {0.9, 0.6, 0.3}, 1.0, {3.0, 40.0, 0.0});
    made.add(form, {x, 0.0, 4.0}, 1.5);
    made.add(form, {x, 2.5, 8.0}, 2.0, {0.4, 0.6, 0.9}, 0.5, {3.0, 20.0, 0.0});
  }
  made.addDome(Form::tetrahedron, 200, 12.0, 0.6);
  Scene scene;
  scene.frame = &made.frame;
  scene.layers = made.layers;
  scene.ground_colour = {0.36, 0.34, 0.29};
  auto renderer = Renderer::create();
  EXPECT_TRUE(renderer) << (renderer ? "" : renderer.error().text());
  if (!renderer) return {};
  auto image = (*renderer)->drawToImage(scene, framing({{-16.0, 0.0, -10.0}, {16.0, 10.0, 10.0}}, 16.0 / 9.0), 640, 360);
  EXPECT_TRUE(image) << (image ? "" : image.error().text());
  return image ? *image : Image{};
}

TEST(Window, ShowsTheSameBytesAsTheOffscreenContext) {
  const test::VirtualDisplay display;
  for (const auto& [key, value] : display.environment()) {
    if (value.empty()) ::unsetenv(key.c_str());
    else ::setenv(key.c_str(), value.c_str(), 1);
  }
  Image in_window, offscreen;
  std::string window_driver, offscreen_driver;
  {
    const auto context = gl::makeWindowContext({});
    ASSERT_TRUE(context) << context.error().text();
    window_driver = (*context)->description();
    in_window = drawEverything();
  }
  {
    const auto context = gl::makeOffscreenContext();
    ASSERT_TRUE(context) << context.error().text();
    offscreen_driver = (*context)->description();
    offscreen = drawEverything();
  }
  ASSERT_EQ(in_window.rgba.size(), offscreen.rgba.size());
  std::size_t different = 0;
  int worst = 0;
  for (std::size_t i = 0; i < offscreen.rgba.size(); ++i) {
    different += in_window.rgba[i] != offscreen.rgba[i];
    worst = std::max(worst, std::abs(in_window.rgba[i] - offscreen.rgba[i]));
  }
  EXPECT_EQ(different, 0u) << "worst " << worst << "; " << window_driver << " against " << offscreen_driver;
}

}  // namespace
}  // namespace npsee::render
