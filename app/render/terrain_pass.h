#pragma once

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/mission_light.h"
#include "app/render/surface_map.h"
#include "app/render/terrain_mesh.h"
#include "app/render/view.h"

#include <array>

namespace npsee::render {

/// What a terrain needs to be drawn, made once for it: the tree of details and the surface map.
class TerrainModel {
 public:
  static TerrainModel make(const Terrain& terrain, int threads);
  const Terrain& terrain() const { return terrain_; }
  HeightGrid grid() const { return gridOf(terrain_); }
  const TerrainTree& tree() const { return tree_; }
  const SurfaceMap& map() const { return map_; }
  /// Whether this was made for that terrain (copies share their samples).
  bool of(const Terrain& terrain) const;

 private:
  Terrain terrain_;
  TerrainTree tree_;
  SurfaceMap map_;
};

/// How the ground is marked.
struct TerrainLines {
  double contour_m = 0.0;       ///< height between contours, every fifth stronger; 0 = by distance
  double strength = 1.0;        ///< 0 = none
  double grid_m = 1000.0;       ///< between the lines of the map's grid
  bool map = false;             ///< colours and lines of a map: no haze, less of the noise
  friend bool operator==(const TerrainLines&, const TerrainLines&) = default;
};

/// Draws the ground and the sea. Corners are made anew for every picture from the eye's place in double precision, so that nothing
/// trembles far from the origin and nothing depends on the pictures before.
class TerrainPass {
 public:
  static Expected<TerrainPass> create();

  /// `view` has its eye at the origin; the eye stands at `eye` in the world. Draws into the bound framebuffer with depth.
  void draw(const TerrainModel& model, const Vec3& eye, const View& view, int width, int height, const MissionLight& light, const TerrainLines& lines);

  /// The next picture shows another terrain.
  void forget() { mapped_ = nullptr; }
  /// Tiles of the last picture.
  std::size_t tiles() const { return tiles_.size(); }

 private:
  enum Kind { land, far_land, sea, shore, outside, kKinds };
  void uploadMap(const TerrainModel& model);
  void uploadMesh(const TerrainModel& model, const TerrainFrustum& frustum, const View& view);
  void prepare(Kind kind, const TerrainModel& model, const Vec3& eye, const View& view, const MissionLight& light, const TerrainLines& lines) const;

  std::array<gl::Program, kKinds> programs_;
  gl::VertexArray attributes_, surroundings_attributes_;
  gl::Buffer vertices_, indices_, surroundings_;
  gl::Texture map_, noise_;
  const float* mapped_ = nullptr;  // samples of the terrain whose map is in the texture
  std::size_t indexed_ = 0;        // tiles that the index buffer has room for
  std::vector<TerrainTile> tiles_;
  std::array<std::size_t, kKinds> ends_{};  // tiles of each kind end here
  std::vector<TerrainVertex> corners_, outer_;
};

}  // namespace npsee::render
