#pragma once

#include <npsee/error.h>
#include <npsee/vec3.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// Colour as designers write it: sRGB-coded components, each 0 to 1.
struct Colour {
  double r = 0.0, g = 0.0, b = 0.0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// A quantity over a particle's life: piecewise linear between points, constant outside; empty = constant 1.
struct CurvePoint {
  double at = 0.0;     ///< fraction of the lifetime, 0 to 1
  double value = 1.0;  ///< factor on the quantity
  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};
using Curve = std::vector<CurvePoint>;

/// Colour over a particle's life: piecewise linear in sRGB; empty = the layer's own colour throughout.
struct GradientStop {
  double at = 0.0;
  Colour colour;
  friend bool operator==(const GradientStop&, const GradientStop&) = default;
};
using Gradient = std::vector<GradientStop>;

enum class BurstKind { ground, air };
enum class RegionShape { point, disc, ring, square, line, sphere, hemisphere, box, cylinder };
enum class RegionFill { filled, surface };
enum class Directionality { burst, cone, neutral };
enum class AngleDistribution { normal, uniform, place };
enum class Distribution { normal, uniform };
enum class Trajectory { linear, parabolic };
enum class Form { tetrahedron, disc, sphere, shard, streak, smoke, fire, flash, shock, scorch, pieces };
enum class Trigger { none, birth, path, bounce, death };
enum class PathSpacing { time, distance };
enum class Sky { day, dusk, night };

/// One particle system of a preset. The meaning, unit, range and default of every member stand in the parameter table
/// (sim/preset/table_layer.cpp, `npsee params`); a new Layer holds the table's defaults.
struct Layer {
  Layer();

  std::string name;
  bool enabled;
  std::int64_t variation;

  std::string parent;  ///< name of the layer whose particles this one hangs on; empty = the burst itself
  Trigger trigger;
  PathSpacing path_spacing;
  double inherit_velocity;

  RegionShape region_shape;
  RegionFill region_fill;
  double region_radius_m;
  double region_inner_radius_m;
  double region_length_m;
  double region_width_m;
  double region_height_m;
  Vec3 region_offset_m;
  double density;
  std::int64_t count;

  Vec3 direction;
  Directionality directionality;
  double ejection_angle_rad;
  AngleDistribution angle_distribution;
  bool outward;
  double speed_mean_mps;
  double speed_deviation_mps;
  Distribution speed_distribution;
  double size_mean_m;
  double size_deviation_m;
  Distribution size_distribution;
  double spin_mean_radps;
  double spin_deviation_radps;

  double start_s;
  double duration_s;
  double lifetime_mean_s;
  double lifetime_deviation_s;

  Trajectory trajectory;
  double drag_ps;
  double buoyancy_mps2;
  double turbulence_m;
  double turbulence_size_m;

  bool follow_ground;
  bool collide;
  double restitution;
  double friction;
  std::int64_t bounce_limit;
  double rest_speed_mps;

  Form form;
  Colour colour;
  double colour_variation;
  double opacity;
  double temperature_k;
  double cooling_s;
  Gradient colour_over_life;
  Curve opacity_over_life;
  Curve size_over_life;

  std::string pieces_model;
  double pieces_scale;
  double pieces_heading_rad;
  double pieces_density_kgpm3;
  double pieces_impulse_Pas;
  double pieces_reach_m;
  Vec3 pieces_burst_m;
  bool pieces_stand;

  friend bool operator==(const Layer&, const Layer&) = default;
};

/// Where a value was read from. It is no part of the value: presets from two folders may be equal.
struct FileFolder {
  std::filesystem::path path;
  friend bool operator==(const FileFolder&, const FileFolder&) { return true; }
};

/// An explosion preset: a plain value. Copying, comparing and storing it is all that undo needs.
struct Preset {
  Preset();

  std::string title;
  std::string description;
  std::string tags;
  BurstKind burst;
  double burst_height_m;
  double gravity_mps2;
  Vec3 wind_mps;
  double ground_height_m;
  Colour ground_colour;
  Sky sky;
  std::int64_t seed;
  std::vector<Layer> layers;
  FileFolder folder;  ///< the file's, against which models are looked for; not stored

  friend bool operator==(const Preset&, const Preset&) = default;
};

/// Limits of a preset as a whole.
inline constexpr int kPresetVersion = 1;
inline constexpr std::int64_t kMaxParticles = 4'000'000;
inline constexpr std::size_t kMaxLayers = 64;
inline constexpr std::size_t kMaxCurvePoints = 32;

/// Reads and validates a `*.npsee.json` file. The error lists every fault with file, line and JSON pointer.
/// Thread-safe.
Expected<Preset> loadPreset(const std::filesystem::path& path);

/// The same from text; `name` stands for the file in messages, `folder` is where the files that it names lie (empty: the current one). Errors as of
/// loadPreset. Thread-safe.
Expected<Preset> parsePreset(std::string_view text, std::string_view name, const std::filesystem::path& folder = {});

/// The file's text: keys in table order, values that equal their default left out, two-space indent, final newline.
/// `parsePreset(presetText(p), "") == p`, and the text is the same again when saved once more.
std::string presetText(const Preset& preset);

/// Writes atomically (temporary file in the same folder, synced, renamed). Error kind output; an existing file is then
/// untouched.
Expected<void> savePreset(const Preset& preset, const std::filesystem::path& path);

/// Every fault of the value itself: ranges, names, parents, cycles, particle budget. Empty = valid.
std::vector<Fault> validate(const Preset& preset);

/// Applies one `KEY=VALUE` (burst parameter) or `LAYER.key=VALUE` of the command line. Error kind usage; the preset is
/// then unchanged.
Expected<void> applySetting(Preset& preset, std::string_view expression);

/// Size of the region particles start in: m, m^2 or m^3 by the shape's dimension, 1 for a point.
double regionMeasure(const Layer& layer);

/// Particles a layer starts per parent event (or in all, without a parent): `count`, or density times measure.
std::int64_t particleCount(const Layer& layer);

/// Index of the named layer, -1 if there is none.
int findLayer(const Preset& preset, std::string_view name);

/// A name not yet used in `preset`, made from `wish` ("sparks", "sparks 2", ...).
std::string freeLayerName(const Preset& preset, std::string_view wish);

/// Gives a layer another name and turns its `variation` so that its random draws, hence its picture, stay the same;
/// children follow. Error kind usage if the name is taken or unfit.
Expected<void> renameLayer(Preset& preset, std::size_t index, std::string_view name);

}  // namespace npsee
