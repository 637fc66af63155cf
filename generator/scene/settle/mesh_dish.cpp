#include "generator/scene/settle/mesh_dish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "generator/mesh/weld.h"

namespace pomona {

namespace {

constexpr double nothing = -1;  // the height of a cell under which there is no mesh
constexpr std::array<glm::ivec2, 4> sides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

DistanceGrid distances_of(const Solid& solid) {
  const std::vector<std::uint32_t> first = weld(solid.mesh.position);
  std::vector<glm::dvec3> position;
  for (const glm::vec3& p : solid.mesh.position) position.emplace_back(p);
  // A wall of 8 mm in a crate of half a metre is three cells thick.
  return {position,
          welded_triangles(first, solid.mesh.triangle),
          {.cells = 600'000, .max_width = 0.004, .max_cells = 2'000'000}};
}

}  // namespace

MeshDish::MeshDish(const Solid& solid, const TriangleTree& mesh, bool on_top)
    : box_(mesh.box()), distance_(distances_of(solid)) {
  measure_heights(mesh);
  find_outline();
  find_places(on_top);
}

/// One ray a cell, with a ring of empty cells around them all.
void MeshDish::measure_heights(const TriangleTree& mesh) {
  constexpr double along = 256;  // cells along the longer side
  const double wide = box_.high.x - box_.low.x, deep = box_.high.z - box_.low.z;
  cell_ = std::max(wide, deep) / along;
  count_ = {static_cast<int>(wide / cell_) + 4, static_cast<int>(deep / cell_) + 4};
  height_.assign(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y), nothing);
  const double sky = box_.high.y + 1;
  for (int j = 0; j < count_.y; ++j) {
    for (int i = 0; i < count_.x; ++i) {
      // A little beside the middle, so as to meet no edge end on.
      const double x = box_.low.x + (i - 1.4987) * cell_, z = box_.low.z + (j - 1.5013) * cell_;
      const double y = mesh.height_below({x, sky, z});
      if (y > nothing) height_[static_cast<std::size_t>(j * count_.x + i)] = std::max(0.0, y);
    }
  }
}

std::optional<std::size_t> MeshDish::cell_at(double x, double z) const {
  const double i = std::floor((x - box_.low.x) / cell_ + 2), j = std::floor((z - box_.low.z) / cell_ + 2);
  if (i < 0 || j < 0 || i >= count_.x || j >= count_.y) return {};
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(count_.x) + static_cast<std::size_t>(i);
}

/// All cells that cannot be reached from beside the mesh: a floor with slits is within, too.
void MeshDish::find_outline() {
  inside_.assign(height_.size(), 1);
  std::vector<glm::ivec2> reached{{0, 0}};
  inside_[0] = 0;
  while (!reached.empty()) {
    const glm::ivec2 from = reached.back();
    reached.pop_back();
    for (const glm::ivec2& side : sides) {
      const glm::ivec2 to = from + side;
      if (to.x < 0 || to.y < 0 || to.x >= count_.x || to.y >= count_.y) continue;
      const auto cell = static_cast<std::size_t>(to.y * count_.x + to.x);
      if (inside_[cell] == 0 || height_[cell] > nothing) continue;
      inside_[cell] = 0;
      reached.push_back(to);
    }
  }
}

/// So high water would stand in each cell after rain: from the border inwards, the lowest cells first, the level never
/// falls.
std::vector<double> MeshDish::water_levels() const {
  using Entry = std::tuple<double, int, int>;  // level, then the cell: a total order
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<double> level(height_.size(), -2);
  const auto visit = [&](int i, int j, double from) {
    double& known = level[static_cast<std::size_t>(j * count_.x + i)];
    if (known > -2) return;
    known = std::max(from, std::max(0.0, height_[static_cast<std::size_t>(j * count_.x + i)]));
    open.emplace(known, i, j);
  };
  for (int i = 0; i < count_.x; ++i) visit(i, 0, 0), visit(i, count_.y - 1, 0);
  for (int j = 0; j < count_.y; ++j) visit(0, j, 0), visit(count_.x - 1, j, 0);
  while (!open.empty()) {
    const auto [from, x, y] = open.top();
    open.pop();
    for (const glm::ivec2& side : sides) {
      const glm::ivec2 to = glm::ivec2(x, y) + side;
      if (to.x >= 0 && to.y >= 0 && to.x < count_.x && to.y < count_.y) visit(to.x, to.y, from);
    }
  }
  return level;
}

void MeshDish::find_places(bool on_top) {
  // A dent less deep than a twentieth of the dish's height holds nothing.
  const double min = std::max(0.002, 0.05 * box_.high.y);
  const std::vector<double> level = on_top ? height_ : water_levels();
  std::vector<double> inset(height_.size(), 0);
  for (std::size_t c = 0; c < height_.size(); ++c) {
    const bool is_place =
        on_top ? height_[c] > nothing : inside_[c] != 0 && level[c] - std::max(0.0, height_[c]) >= min;
    if (is_place) inset[c] = std::numeric_limits<double>::max();
  }

  // Distances to the border, in two sweeps over neighbours [Rosenfeld & Pfaltz 1966].
  const auto sweep = [&](int j, int i, int from) {
    double& here = inset[static_cast<std::size_t>(j * count_.x + i)];
    if (here == 0) return;
    const auto ask = [&](int x, int y, double way) {
      here = std::min(here, inset[static_cast<std::size_t>(y * count_.x + x)] + way * cell_);
    };
    ask(i + from, j, 1), ask(i, j + from, 1), ask(i - 1, j + from, 1.414213562), ask(i + 1, j + from, 1.414213562);
  };
  for (int j = 1; j + 1 < count_.y; ++j)
    for (int i = 1; i + 1 < count_.x; ++i) sweep(j, i, -1);
  for (int j = count_.y - 2; j > 0; --j)
    for (int i = count_.x - 2; i > 0; --i) sweep(j, i, 1);
  for (int j = 0; j < count_.y; ++j) {
    for (int i = 0; i < count_.x; ++i) {
      const auto cell = static_cast<std::size_t>(j * count_.x + i);
      const glm::dvec2 at(box_.low.x + (i - 1.5) * cell_, box_.low.z + (j - 1.5) * cell_);
      if (inset[cell] > 0) places_.push_back({at, inset[cell], level[cell]});
    }
  }
}

double MeshDish::height(double x, double z) const {
  const auto cell = cell_at(x, z);
  return cell ? std::max(0.0, height_[*cell]) : 0;
}

bool MeshDish::covers(double x, double z) const {
  for (const glm::ivec2& side : sides) {
    const auto cell = cell_at(x + side.x * cell_, z + side.y * cell_);
    if (cell && inside_[*cell] != 0) return true;
  }
  return false;
}

}  // namespace pomona
