#include "app/render/terrain_pass.h"

#include "app/gl/state.h"
#include "app/gl/vertices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace npsee::render {
namespace {

/// Error of the ground's height on the screen, pixels, and tiles of a picture: together they bound its cost.
constexpr double kError_px = 1.5;
constexpr std::size_t kMostTiles = 260;
/// How far the world goes on level around the terrain, m.
constexpr double kSurroundings_m = 120e3;
/// Pixels larger than this on the ground show no plants and stones, m.
constexpr double kDetail_m = 4.0;
/// The noise repeats after these lengths, m.
constexpr double kFarNoise_m = 5200.0, kNearNoise_m = 310.0;
constexpr int kNoiseSide = 256;

gl::Texture makeTexture(GLenum internal_format, GLenum format, int width, int height, const std::uint8_t* texels, GLenum wrap) {
  gl::Texture texture = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0, format, GL_UNSIGNED_BYTE, texels);
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
  return texture;
}

/// The picture's four sides as half-spaces around an eye.
TerrainFrustum frustumOf(const Vec3& eye, const View& view, int width, int height) {
  TerrainFrustum out;
  out.eye = eye;
  out.tolerance = kError_px * view.metre_per_pixel;
  const double x = 0.5 * width * view.metre_per_pixel, y = 0.5 * height * view.metre_per_pixel;
  // A point at depth d is in the picture when its offset to the right is at most d x.
  const Vec3 forward = -1.0 * view.back;
  out.normals[0] = x * forward + view.right;
  out.normals[1] = x * forward - view.right;
  out.normals[2] = y * forward + view.up;
  out.normals[3] = y * forward - view.up;
  out.normals[4] = forward;
  out.planes = 5;
  return out;
}

void cornerAttributes() {
  gl::attribute(0, 3, sizeof(TerrainVertex), 0);
  gl::attribute(1, 1, sizeof(TerrainVertex), offsetof(TerrainVertex, skirt));
}

double shareOf(double value, double period) {
  const double share = value / period;
  return share - std::floor(share);
}

}  // namespace

TerrainModel TerrainModel::make(const Terrain& terrain, int threads) {
  TerrainModel model;
  model.terrain_ = terrain;
  model.tree_ = TerrainTree::make(gridOf(terrain));
  model.map_ = surfaceMapOf(gridOf(terrain), threads);
  return model;
}

bool TerrainModel::of(const Terrain& terrain) const {
  return terrain_.heights().data() == terrain.heights().data() && terrain_.columns() == terrain.columns() && terrain_.seaLevel() == terrain.seaLevel();
}

Expected<TerrainPass> TerrainPass::create() {
  TerrainPass pass;
  constexpr const char* kFiles[kKinds] = {"terrain_land.frag", "terrain_far.frag", "terrain_sea.frag", "terrain_shore.frag", "terrain_outside.frag"};
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    auto program = gl::Program::fromFiles("terrain.vert", kFiles[kind]);
    if (!program) return tl::unexpected<Error>(program.error());
    pass.programs_[kind] = std::move(*program);
  }
  pass.vertices_ = gl::Buffer::make();
  pass.indices_ = gl::Buffer::make();
  pass.surroundings_ = gl::Buffer::make();
  pass.attributes_ = gl::VertexArray::make();
  glBindVertexArray(pass.attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, pass.vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, pass.indices_.name());
  cornerAttributes();
  pass.surroundings_attributes_ = gl::VertexArray::make();
  glBindVertexArray(pass.surroundings_attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, pass.surroundings_.name());
  cornerAttributes();
  pass.noise_ = makeTexture(GL_R8, GL_RED, kNoiseSide, kNoiseSide, tilingNoise(kNoiseSide, 8, 5).data(), GL_REPEAT);
  // One level of the noise at a time: half the work, and where levels meet nobody sees it.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  return pass;
}

void TerrainPass::uploadMap(const TerrainModel& model) {
  const SurfaceMap& map = model.map();
  map_ = makeTexture(GL_RGBA8, GL_RGBA, map.width, map.height, map.texels.data(), GL_CLAMP_TO_EDGE);
  mapped_ = model.terrain().heights().data();
}

void TerrainPass::uploadMesh(const TerrainModel& model, const TerrainFrustum& frustum, const View& view) {
  const HeightGrid grid = model.grid();
  model.tree().select(frustum, kMostTiles, tiles_);
  // Each kind with its own shader, near ones first.
  const double far = kDetail_m / std::max(view.metre_per_pixel, 1e-9);
  const auto kindOf = [&](const TerrainTile& tile) { return tile.low_m >= grid.sea_m ? (tile.distance_m > far ? far_land : land) : tile.high_m < grid.sea_m ? sea : shore; };
  std::ranges::stable_sort(tiles_, {}, kindOf);
  ends_ = {};
  for (const TerrainTile& tile : tiles_)
    for (std::size_t kind = kindOf(tile); kind < kKinds; ++kind) ++ends_[kind];
  corners_.clear();
  for (const TerrainTile& tile : tiles_) addTileVertices(grid, tile, frustum.eye, frustum.tolerance, corners_);
  gl::upload(GL_ARRAY_BUFFER, vertices_, corners_, GL_STREAM_DRAW);
  if (tiles_.size() > indexed_) {
    indexed_ = std::max(tiles_.size(), kMostTiles);
    std::vector<std::uint32_t> indices;
    for (std::size_t tile = 0; tile < indexed_; ++tile)
      for (const std::uint16_t index : tileIndices()) indices.push_back(static_cast<std::uint32_t>(tile * kTileVertices + index));
    glBindVertexArray(attributes_.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(), GL_STATIC_DRAW);
  }
  outer_.clear();
  addSurroundings(grid, frustum.eye, kSurroundings_m, frustum.tolerance, outer_);
  gl::upload(GL_ARRAY_BUFFER, surroundings_, outer_, GL_STREAM_DRAW);
}

void TerrainPass::prepare(Kind kind, const TerrainModel& model, const Vec3& eye, const View& view, const MissionLight& light, const TerrainLines& lines) const {
  const gl::Program& program = programs_[kind];
  program.use();
  setView(program, view);
  setLight(program, light, eye);
  const auto f = [](double v) { return static_cast<float>(v); };
  const Terrain& terrain = model.terrain();
  program.set("u_eye_height", f(eye.y), f(terrain.seaLevel()));
  program.set("u_place", f(eye.x / terrain.sizeX()), f(eye.z / terrain.sizeZ()), f(1.0 / terrain.sizeX()), f(1.0 / terrain.sizeZ()));
  program.set("u_noise_at", f(shareOf(eye.x, kFarNoise_m)), f(shareOf(eye.z, kFarNoise_m)), f(shareOf(eye.x, kNearNoise_m)), f(shareOf(eye.z, kNearNoise_m)));
  program.set("u_noise_scale", f(1.0 / kFarNoise_m), f(1.0 / kNearNoise_m));
  program.set("u_lines", f(lines.contour_m), f(lines.strength), f(lines.grid_m), lines.map ? 1.0f : 0.0f);
  program.set("u_grid_at", f(shareOf(eye.x, lines.grid_m) * lines.grid_m), f(shareOf(eye.z, lines.grid_m) * lines.grid_m));
  program.set("u_pixel", f(view.metre_per_pixel));
  program.set("u_map", 0);
  program.set("u_noise", 1);
}

void TerrainPass::draw(const TerrainModel& model, const Vec3& eye, const View& view, int width, int height, const MissionLight& light, const TerrainLines& lines) {
  if (mapped_ != model.terrain().heights().data()) uploadMap(model);
  uploadMesh(model, frustumOf(eye, view, width, height), view);
  gl::drawSolid();
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, noise_.name());
  glBindSampler(1, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, map_.name());
  glBindSampler(0, 0);
  glBindVertexArray(attributes_.name());
  const std::size_t per_tile = tileIndices().size();
  std::size_t first = 0;
  for (const Kind kind : {land, far_land, sea, shore}) {
    const std::size_t count = ends_[kind] - first;
    if (count > 0) {
      prepare(kind, model, eye, view, light, lines);
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count * per_tile), GL_UNSIGNED_INT, reinterpret_cast<const void*>(first * per_tile * sizeof(std::uint32_t)));
    }
    first = ends_[kind];
  }
  prepare(outside, model, eye, view, light, lines);
  glBindVertexArray(surroundings_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(outer_.size()));
}

}  // namespace npsee::render
