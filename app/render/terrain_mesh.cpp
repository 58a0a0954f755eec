#include "app/render/terrain_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::render {
namespace {

/// A quad is divided at most this often within a cell of the terrain, and not below this size, m.
constexpr int kMostWithinCell = 5;
constexpr double kFinest_m = 0.4;
/// The sea's bed is drawn flat this far below its surface: deep enough for the shore to be found between two samples.
constexpr double kBed_m = 12.0;

double clampedTo(double value, double last) { return value > 0.0 ? std::min(value, last) : 0.0; }

}  // namespace

double HeightGrid::height(double column, double row) const {
  const double x = clampedTo(column, columns - 1), z = clampedTo(row, rows - 1);
  const int i = std::min(static_cast<int>(x), columns - 2), j = std::min(static_cast<int>(z), rows - 2);
  const double u = x - i, v = z - j;
  const double nw = at(i, j), ne = at(i + 1, j), sw = at(i, j + 1), se = at(i + 1, j + 1);
  const double north = nw + u * (ne - nw), south = sw + u * (se - sw);
  return north + v * (south - north);
}

HeightGrid gridOf(const Terrain& terrain) { return {terrain.columns(), terrain.rows(), terrain.cellX(), terrain.cellZ(), terrain.seaLevel(), terrain.heights()}; }

/// Builds the tree from its leaves up.
class TerrainTree::Builder {
 public:
  Builder(const HeightGrid& grid, TerrainTree& tree) : grid_(grid), tree_(tree) {}

  std::int32_t build(const Area& area) {
    if (area.column >= tree_.cells_x_ || area.row >= tree_.cells_z_) return -1;
    const auto index = static_cast<std::int32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    if (area.across == 0 && area.down == 0) {
      tree_.nodes_[static_cast<std::size_t>(index)] = leaf(area);
      return index;
    }
    const bool wide = tree_.halvesWide(area);
    Area first = area, second = area;
    if (wide) {
      first.across = second.across = area.across - 1;
      second.column += kTileQuads << first.across;
    } else {
      first.down = second.down = area.down - 1;
      second.row += kTileQuads << first.down;
    }
    Node node;
    node.child[0] = build(first);
    node.child[1] = build(second);
    node.low = 1e30f;
    node.high = -1e30f;
    float below = 0.0f;
    for (const std::int32_t child : node.child) {
      if (child < 0) continue;
      const Node& half = tree_.nodes_[static_cast<std::size_t>(child)];
      node.low = std::min(node.low, half.low);
      node.high = std::max(node.high, half.high);
      below = std::max(below, half.error);
    }
    node.error = below + static_cast<float>(errorOfHalving(area, wide));
    tree_.nodes_[static_cast<std::size_t>(index)] = node;
    return index;
  }

 private:
  double shown(int column, int row) const { return std::max(grid_.at(std::min(column, tree_.cells_x_), std::min(row, tree_.cells_z_)), grid_.sea_m); }

  /// What a quad loses that is not halved: the middles of its sides against the samples there.
  double errorOfHalving(const Area& area, bool wide) const {
    const int step_x = 1 << area.across, step_z = 1 << area.down;
    double most = 0.0;
    for (int j = 0; j <= kTileQuads; ++j) {
      const int row = area.row + j * step_z;
      if (row - step_z >= tree_.cells_z_) break;
      for (int i = 0; i <= kTileQuads; ++i) {
        const int column = area.column + i * step_x;
        if (column - step_x >= tree_.cells_x_) break;
        const int half_x = wide ? step_x / 2 : 0, half_z = wide ? 0 : step_z / 2;
        if ((wide && i == kTileQuads) || (!wide && j == kTileQuads)) continue;
        const double a = shown(column, row), b = shown(column + 2 * half_x, row + 2 * half_z), middle = shown(column + half_x, row + half_z);
        most = std::max(most, std::abs(middle - 0.5 * (a + b)));
      }
    }
    return most;
  }

  Node leaf(const Area& area) const {
    double low = 1e30, high = -1e30, twist = 0.0;
    for (int j = 0; j < kTileQuads && area.row + j < tree_.cells_z_; ++j)
      for (int i = 0; i < kTileQuads && area.column + i < tree_.cells_x_; ++i) {
        const int c = area.column + i, r = area.row + j;
        const double nw = shown(c, r), ne = shown(c + 1, r), sw = shown(c, r + 1), se = shown(c + 1, r + 1);
        for (const double bare : {grid_.at(c, r), grid_.at(c + 1, r), grid_.at(c, r + 1), grid_.at(c + 1, r + 1)}) {
          low = std::min(low, bare);
          high = std::max(high, bare);
        }
        twist = std::max(twist, std::abs(nw + se - ne - sw));
      }
    // Two triangles differ from the bilinear cell most on the diagonal's middle, by a quarter of the twist.
    return {static_cast<float>(0.25 * twist), static_cast<float>(low), static_cast<float>(high), {-1, -1}};
  }

  const HeightGrid& grid_;
  TerrainTree& tree_;
};

bool TerrainTree::halvesWide(const Area& area) const {
  if (area.down == 0) return true;
  if (area.across == 0) return false;
  return cell_x_m_ * (1 << area.across) >= cell_z_m_ * (1 << area.down);
}

TerrainTree TerrainTree::make(const HeightGrid& grid) {
  TerrainTree tree;
  if (grid.columns < 2 || grid.rows < 2) return tree;
  tree.cell_x_m_ = grid.cell_x_m;
  tree.cell_z_m_ = grid.cell_z_m;
  tree.sea_m_ = grid.sea_m;
  tree.cells_x_ = grid.columns - 1;
  tree.cells_z_ = grid.rows - 1;
  while ((kTileQuads << tree.root_.across) < tree.cells_x_) ++tree.root_.across;
  while ((kTileQuads << tree.root_.down) < tree.cells_z_) ++tree.root_.down;
  Builder(grid, tree).build(tree.root_);
  return tree;
}

namespace {

/// Whether a box (relative to the eye) lies behind one of the planes.
bool outside(const TerrainFrustum& frustum, const Vec3& low, const Vec3& high) {
  for (int i = 0; i < frustum.planes; ++i) {
    const Vec3& n = frustum.normals[i];
    const double most = n.x * (n.x > 0.0 ? high.x : low.x) + n.y * (n.y > 0.0 ? high.y : low.y) + n.z * (n.z > 0.0 ? high.z : low.z);
    if (most + frustum.offsets[i] < 0.0) return true;
  }
  return false;
}

double distanceTo(const Vec3& low, const Vec3& high) {
  const auto gap = [](double a, double b) { return a > 0.0 ? a : (b < 0.0 ? -b : 0.0); };
  return length({gap(low.x, high.x), gap(low.y, high.y), gap(low.z, high.z)});
}

}  // namespace

bool TerrainTree::choose(const TerrainFrustum& frustum, std::int32_t index, const Area& area, std::size_t limit, std::vector<TerrainTile>& out) const {
  if (index < 0) return true;
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  const auto last = [](int first, int quads_log, int cells) { return std::min(first + (kTileQuads << quads_log), cells); };
  const Vec3 low{area.column * cell_x_m_ - frustum.eye.x, std::max(static_cast<double>(node.low), sea_m_) - frustum.eye.y, area.row * cell_z_m_ - frustum.eye.z};
  const Vec3 high{last(area.column, area.across, cells_x_) * cell_x_m_ - frustum.eye.x, std::max(static_cast<double>(node.high), sea_m_) - frustum.eye.y, last(area.row, area.down, cells_z_) * cell_z_m_ - frustum.eye.z};
  if (outside(frustum, low, high)) return true;
  const double distance = distanceTo(low, high);
  const TerrainTile tile{static_cast<double>(area.column), static_cast<double>(area.row), static_cast<double>(1 << area.across), static_cast<double>(1 << area.down),
                         static_cast<double>(node.error), static_cast<double>(node.low), static_cast<double>(node.high), distance};
  if (area.across == 0 && area.down == 0) return chooseWithin(frustum, tile, 0, limit, out);
  if (tile.error_m <= frustum.tolerance * distance) {
    if (out.size() >= limit) return false;
    out.push_back(tile);
    return true;
  }
  Area first = area, second = area;
  if (halvesWide(area)) {
    first.across = second.across = area.across - 1;
    second.column += kTileQuads << first.across;
  } else {
    first.down = second.down = area.down - 1;
    second.row += kTileQuads << first.down;
  }
  return choose(frustum, node.child[0], first, limit, out) && choose(frustum, node.child[1], second, limit, out);
}

bool TerrainTree::chooseWithin(const TerrainFrustum& frustum, const TerrainTile& tile, int depth, std::size_t limit, std::vector<TerrainTile>& out) const {
  const double east = std::min(tile.column + kTileQuads * tile.step_x, static_cast<double>(cells_x_)), south = std::min(tile.row + kTileQuads * tile.step_z, static_cast<double>(cells_z_));
  if (tile.column >= east || tile.row >= south) return true;
  const Vec3 low{tile.column * cell_x_m_ - frustum.eye.x, std::max(tile.low_m, sea_m_) - frustum.eye.y, tile.row * cell_z_m_ - frustum.eye.z};
  const Vec3 high{east * cell_x_m_ - frustum.eye.x, std::max(tile.high_m, sea_m_) - frustum.eye.y, south * cell_z_m_ - frustum.eye.z};
  if (outside(frustum, low, high)) return true;
  TerrainTile here = tile;
  here.distance_m = distanceTo(low, high);
  const bool finest = depth >= kMostWithinCell || std::max(tile.step_x * cell_x_m_, tile.step_z * cell_z_m_) < kFinest_m;
  if (finest || here.error_m <= frustum.tolerance * here.distance_m) {
    if (out.size() >= limit) return false;
    out.push_back(here);
    return true;
  }
  here.step_x *= 0.5;
  here.step_z *= 0.5;
  here.error_m *= 0.25;
  for (int quarter = 0; quarter < 4; ++quarter) {
    TerrainTile part = here;
    part.column += (quarter & 1) * kTileQuads * here.step_x;
    part.row += (quarter >> 1) * kTileQuads * here.step_z;
    if (!chooseWithin(frustum, part, depth + 1, limit, out)) return false;
  }
  return true;
}

void TerrainTree::select(const TerrainFrustum& frustum, std::size_t limit, std::vector<TerrainTile>& out) const {
  TerrainFrustum wanted = frustum;
  for (int attempt = 0; attempt < 12; ++attempt) {
    out.clear();
    if (nodes_.empty() || choose(wanted, 0, root_, limit, out)) break;
    wanted.tolerance *= 1.6;
  }
  std::ranges::sort(out, [](const TerrainTile& a, const TerrainTile& b) {
    return a.distance_m != b.distance_m ? a.distance_m < b.distance_m : (a.row != b.row ? a.row < b.row : a.column < b.column);
  });
}

void addTileVertices(const HeightGrid& grid, const TerrainTile& tile, const Vec3& eye, double tolerance, std::vector<TerrainVertex>& out) {
  const std::size_t first = out.size();
  const double last_column = grid.columns - 1, last_row = grid.rows - 1;
  for (int j = 0; j <= kTileQuads; ++j) {
    const double row = std::min(tile.row + j * tile.step_z, last_row);
    for (int i = 0; i <= kTileQuads; ++i) {
      const double column = std::min(tile.column + i * tile.step_x, last_column);
      const double ground = std::max(grid.height(column, row), grid.sea_m - kBed_m);
      out.push_back({static_cast<float>(column * grid.cell_x_m - eye.x), static_cast<float>(row * grid.cell_z_m - eye.z), static_cast<float>(ground), 0.0f});
    }
  }
  // A neighbour may be as coarse as the tolerance allows at the tile's far side.
  const double across = kTileQuads * (tile.step_x * grid.cell_x_m + tile.step_z * grid.cell_z_m);
  const auto depth = static_cast<float>(tile.error_m + 2.0 * tolerance * (tile.distance_m + across) + 0.02);
  constexpr int kSide = kTileQuads + 1;
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < kSide; ++k) {
      const int along[4] = {k, (kSide - 1) * kSide + k, k * kSide, k * kSide + kSide - 1};
      TerrainVertex corner = out[first + static_cast<std::size_t>(along[side])];
      corner.skirt = depth;
      out.push_back(corner);
    }
}

const std::vector<std::uint16_t>& tileIndices() {
  static const std::vector<std::uint16_t> indices = [] {
    constexpr int kSide = kTileQuads + 1;
    std::vector<std::uint16_t> out;
    const auto quad = [&](int a, int b, int c, int d) {
      for (const int k : {a, b, c, a, c, d}) out.push_back(static_cast<std::uint16_t>(k));
    };
    for (int j = 0; j < kTileQuads; ++j)
      for (int i = 0; i < kTileQuads; ++i) {
        const int nw = j * kSide + i;
        quad(nw, nw + kSide, nw + kSide + 1, nw + 1);
      }
    constexpr int kFirst = kSide * kSide;
    for (int k = 0; k < kTileQuads; ++k) {
      const int skirt[4] = {kFirst + k, kFirst + kSide + k, kFirst + 2 * kSide + k, kFirst + 3 * kSide + k};
      const int top[4] = {k, (kSide - 1) * kSide + k, k * kSide, k * kSide + kSide - 1};
      const int next[4] = {1, 1, kSide, kSide};
      for (int side = 0; side < 4; ++side) {
        // Facing outwards: north and east sides run against the order of their corners.
        if (side == 0 || side == 3) quad(top[side], top[side] + next[side], skirt[side] + 1, skirt[side]);
        else quad(top[side], skirt[side], skirt[side] + 1, top[side] + next[side]);
      }
    }
    return out;
  }();
  return indices;
}

void addSurroundings(const HeightGrid& grid, const Vec3& eye, double reach_m, double tolerance, std::vector<TerrainVertex>& out) {
  const double size_x = (grid.columns - 1) * grid.cell_x_m, size_z = (grid.rows - 1) * grid.cell_z_m;
  const auto corner = [&](double x, double z) {
    const double ground = std::max(grid.height(x / grid.cell_x_m, z / grid.cell_z_m), grid.sea_m - kBed_m);
    return TerrainVertex{static_cast<float>(x - eye.x), static_cast<float>(z - eye.z), static_cast<float>(ground), 0.0f};
  };
  const auto strip = [&](double x0, double z0, double x1, double z1, double dx, double dz) {
    const TerrainVertex a = corner(x0, z0), b = corner(x1, z1), c = corner(x1 + dx, z1 + dz), d = corner(x0 + dx, z0 + dz);
    // Counter-clockwise from above: z is south, so the turn from east to south is clockwise.
    const bool turned = (x1 - x0) * dz - (z1 - z0) * dx > 0.0;
    for (const TerrainVertex& v : turned ? std::array{a, d, c, a, c, b} : std::array{a, b, c, a, c, d}) out.push_back(v);
  };
  // Along an edge, samples are joined while none between is farther off the straight line than the tolerance at its distance.
  const auto edge = [&](bool along_x, double across, double dx, double dz) {
    const int last = along_x ? grid.columns - 1 : grid.rows - 1;
    const double cell = along_x ? grid.cell_x_m : grid.cell_z_m;
    const auto shown = [&](int k) { return std::max(along_x ? grid.height(k, across / grid.cell_z_m) : grid.height(across / grid.cell_x_m, k), grid.sea_m); };
    for (int from = 0; from < last;) {
      int to = from + 1;
      double low = -1e30, high = 1e30;
      for (; to < last; ++to) {
        // Slopes of lines from `from` that pass every sample so far closely enough.
        const double x = along_x ? to * cell : across, z = along_x ? across : to * cell;
        const double allowed = tolerance * length({x - eye.x, shown(to) - eye.y, z - eye.z}), run = to - from;
        low = std::max(low, (shown(to) - allowed - shown(from)) / run);
        high = std::min(high, (shown(to) + allowed - shown(from)) / run);
        const double next = (shown(to + 1) - shown(from)) / (run + 1.0);
        if (next < low || next > high) break;
      }
      if (along_x) strip(from * cell, across, to * cell, across, dx, dz);
      else strip(across, from * cell, across, to * cell, dx, dz);
      from = to;
    }
  };
  edge(true, 0.0, 0.0, -reach_m);
  edge(true, size_z, 0.0, reach_m);
  edge(false, 0.0, -reach_m, 0.0);
  edge(false, size_x, reach_m, 0.0);
  for (const double x : {0.0, size_x})
    for (const double z : {0.0, size_z}) {
      const double dx = x == 0.0 ? -reach_m : reach_m, dz = z == 0.0 ? -reach_m : reach_m;
      strip(x, z, x + dx, z, 0.0, dz);
    }
}

}  // namespace npsee::render
