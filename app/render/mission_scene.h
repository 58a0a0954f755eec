#pragma once

#include "app/render/mission_camera.h"
#include "app/render/mission_light.h"
#include "app/render/quality.h"

#include <npsee/preset.h>
#include <npsee/recording.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace npsee::render {

class EffectPasses;
class TileMask;

/// What is drawn over a mission. Lines on the ground follow it; what a hill hides is drawn faintly.
struct MissionOverlays {
  bool trails = true;         ///< path of each shell in the air so far
  bool drop_lines = true;     ///< from the trail straight down to the ground
  bool trajectories = false;  ///< the whole flight of every shell in the air
  bool fire_lines = true;     ///< from each gun with a shell in the air to where that will burst
  bool range_rings = false;   ///< of the guns: reach of their weapon in weapons.dat, and halfway
  bool sight_fan = false;     ///< of one observer, coloured by how far sight clears the ground
  bool beliefs = true;        ///< where observers believe their targets to be, joined with where they are
  bool icons = true;          ///< a mark over every vehicle, gun and observer: friendly frame, hostile diamond, neutral square
  bool scorch = true;         ///< burnt ground where shells burst
  bool contours = true;       ///< height lines and the kilometre grid
  int observer = -1;          ///< whose fan is drawn; -1 = the first
  friend bool operator==(const MissionOverlays&, const MissionOverlays&) = default;
};

/// How a mission is shown. Plain data; drawing the same view of the same recording at the same time gives the same bytes.
struct MissionView {
  MissionCamera camera;
  MissionOverlays overlays;
  /// Vehicles, guns and shells are drawn at least this long, pixels; 0 = true sizes. An observer's eye always sees true sizes.
  double least_px = 20.0;
  /// Explosion presets by shell number (`ShellRecord::number`), instead of the recording's; number 0 stands for all others.
  std::map<int, std::shared_ptr<const Preset>> presets;
  bool smooth = true;         ///< several samples per pixel; costs about a third of the time
  Quality quality = Quality::normal;
  int threads = 1;            ///< for compiling explosions; the picture does not depend on it
  double exposure_stops = 0.0;  ///< as in Scene
  double scale = 1.0;         ///< factor on the widths of lines and on all that is drawn at least so large, for pictures with finer pixels
  friend bool operator==(const MissionView&, const MissionView&) = default;
};

/// How a picture of a mission, or one of those that it is made of, lies in what it is drawn into.
struct MissionLook {
  int width = 0, height = 0;            ///< of what is drawn into, pixels; those of a draft are fewer than the picture's
  double aside_x = 0.0, aside_y = 0.0;  ///< as those of Lens
};

/// Something of the mission at a place of the picture: for labels, for picking with the mouse, for lists.
struct MissionMark {
  enum class Kind { vehicle, gun, observer, shell, burst, belief } kind = Kind::vehicle;
  int index = -1;             ///< in the recording; belief: the observer
  int target = -1;            ///< belief: the vehicle
  double x = 0.0, y = 0.0;    ///< of the point to label, pixels from the upper left
  double depth_m = 0.0;
  double size_px = 0.0;       ///< of what is drawn, for picking
  bool hidden = false;        ///< behind the ground
};

/// Draws a recording. The contract:
///
///   auto scene = MissionScene::make(recording);                       // once per mission: terrain tree and surface map, about 0.2 s
///   renderer.drawToTexture(*scene, recording, t, view, w, h, slot);   // any t, any order; with the context current
///   renderer.drawToImage(*scene, recording, t, view, w, h, image);
///
/// The recording may grow between calls (a mission that is still being simulated), and may be another one over another terrain: then
/// the terrain is prepared anew with that call. Explosions are compiled when a burst is first drawn and kept within a bounded memory.
/// GL objects are made with the first picture; destroy the scene with the context current.
/// The picture is a pure function of (recording, t, view, size): nothing depends on what was drawn before.
class MissionScene {
 public:
  /// Prepares the terrain; needs no GL context. Error kind input: the mission's weapons.dat cannot be read.
  static Expected<std::unique_ptr<MissionScene>> make(const Recording& recording);
  ~MissionScene();

  /// Where things are in a picture; needs no GL. In order of kind and index.
  std::vector<MissionMark> marks(const Recording& recording, double time_s, const MissionView& view, int width, int height) const;

  /// Presets that could not be found or read, once each, as sentences for people; drawn with a shipped one instead.
  const std::vector<std::string>& warnings() const;

  /// Figures of the picture drawn last, for benchmarks and tests.
  struct Counts {
    std::size_t tiles = 0, models = 0, bursts = 0, particles = 0, compiled = 0;
  };
  const Counts& counts() const;

 private:
  friend class Renderer;
  /// Draws a picture of that size into the bound framebuffer (linear light, with depth), over whatever it holds. Marks in `bright` what may dazzle.
  Expected<void> draw(EffectPasses& effects, const Recording& recording, double time_s, const MissionView& view, int width, int height, const MissionLook& look, TileMask& bright);

  struct Impl;
  explicit MissionScene(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace npsee::render
