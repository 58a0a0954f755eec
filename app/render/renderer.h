#pragma once

#include "app/gl/context.h"
#include "app/render/camera.h"
#include "app/render/float_image.h"
#include "app/render/image.h"
#include "app/render/quality.h"
#include "app/render/template_geometry.h"

#include <npsee/explosion.h>
#include <npsee/preset.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

namespace npsee {
struct Recording;
}

namespace npsee::render {

class MissionScene;
struct MissionView;

/// What lies behind the particles.
struct Background {
  enum class Kind { sky, colour, transparent } kind = Kind::sky;
  Colour colour;
  friend bool operator==(const Background&, const Background&) = default;
};

/// What a frame has to hold to be drawn.
inline constexpr unsigned kSceneFields = kVelocity | kLook | kOrientation | kAge;

/// Everything one picture of an explosion shows. Plain data; the renderer keeps no state from picture to picture.
struct Scene {
  const Frame* frame = nullptr;       ///< state at the wanted time with kSceneFields; may be null: an empty range
  std::span<const LayerSpan> layers;  ///< the frame's layers, `Explosion::layers()`
  double ground_height_m = 0.0;
  Colour ground_colour;
  Sky sky = Sky::day;                 ///< hour: light on everything, and the backdrop
  Background background;
  bool grid = true;
  bool bloom = true;                  ///< light that is too bright spreads; never in drafts
  Quality quality = Quality::normal;
  double exposure_stops = 0.0;        ///< the camera's: light times 2^stops before highlights roll off; plain backgrounds stay as they are
};
/// Largest exposure in either direction, stops.
inline constexpr double kMostExposure_stops = 4.0;

/// The three views of the thesis's template.
enum class TemplateView { splines, polygons, surface };

struct TemplateScene {
  const Preset* preset = nullptr;
  int layer = 0;
  TemplateView view = TemplateView::surface;
  double yaw_rad = 0.6, pitch_rad = 0.35;  ///< viewing direction around the shape
  Background background;                   ///< sky means the template's own quiet dark
  bool handles = false;                    ///< dots to drag; see TemplateCamera for where they lie in the picture
  TemplateHandle active = TemplateHandle::none;  ///< drawn in the accent colour
  double scale = 1.0;                      ///< factor on the widths of lines and dots, for pictures with finer pixels
};

/// Textures that a renderer keeps apart.
inline constexpr int kPictureSlots = 16;

/// Takes rows of a picture in single precision, which may be moved away: `band` is as wide as the picture and holds its rows from `first`, counted
/// from the top, as many as it is high. Bands come from the top down, each a multiple of 16 rows but the last.
using TakeRows = std::function<Expected<void>(int first, FloatImage& band)>;

/// Pixels up to which a picture in single precision is worth being held whole.
inline constexpr std::int64_t kMostWholeFloats = 2'500'000;

/// Draws scenes into framebuffer objects of its own, with GL 3.3 core only. One instance per context; all calls on the
/// context's thread with the context current. The same code serves windows and headless rendering.
class Renderer {
 public:
  /// Error kind graphics with the shader log when a shader does not compile.
  static Expected<std::unique_ptr<Renderer>> create();
  ~Renderer();

  /// Draws into an internal texture of the given size (pixels) and returns its GL name, RGBA8 sRGB-coded, origin at the
  /// lower left, valid until the next call with the same `slot` (below kPictureSlots). Error kind graphics for a size over the limit.
  Expected<unsigned> drawToTexture(const Scene& scene, const Camera& camera, int width, int height, int slot = 0);
  Expected<unsigned> drawToTexture(const TemplateScene& scene, int width, int height, int slot = 1);

  /// Draws and reads back.
  Expected<Image> drawToImage(const Scene& scene, const Camera& camera, int width, int height);
  /// The same into `image`, whose memory is used again.
  Expected<void> drawToImage(const Scene& scene, const Camera& camera, int width, int height, Image& image);
  Expected<Image> drawToImage(const TemplateScene& scene, int width, int height);

  /// Draws in single precision, with the passes requested; the memory of `image` is used again.
  Expected<void> drawToFloats(const Scene& scene, const Camera& camera, int width, int height, const FloatRequest& request, FloatImage& image);

  /// The same in bands of so many rows (0 = as many as make about a million pixels), so that memory does not grow by what single precision
  /// takes. Bands show the same as the whole, depth and motion but for rounding.
  Expected<void> drawToRows(const Scene& scene, const Camera& camera, int width, int height, const FloatRequest& request, const TakeRows& take, int rows = 0);

  /// Calls back after each pass of a scene's picture, with the driver's work done: for measuring. Empty = no longer.
  void watchPasses(std::function<void(std::string_view pass)> watch);

  /// A mission at a moment; see mission_scene.h for the contract.
  Expected<unsigned> drawToTexture(MissionScene& scene, const Recording& recording, double time_s, const MissionView& view, int width, int height, int slot = 2);
  Expected<void> drawToImage(MissionScene& scene, const Recording& recording, double time_s, const MissionView& view, int width, int height, Image& image);

 private:
  struct Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Largest width or height of a picture, pixels.
inline constexpr int kMaxPictureSize = 8192;

}  // namespace npsee::render
