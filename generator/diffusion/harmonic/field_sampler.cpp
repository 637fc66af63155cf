#include "generator/diffusion/harmonic/field_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/nearest_labels.h"
#include "generator/diffusion/harmonic/short_rays.h"
#include "generator/mesh/triangle_distance.h"

namespace pomona {

namespace {

/// A linear function fitted to values at places around the origin: least squares with weights 1 / (d^2 + nearness)^2,
/// so that near places count more.
class LinearFit {
 public:
  void add(const glm::vec3& place, const Quad& value) {
    constexpr float nearness = 1e-3f;
    const float from_here = glm::dot(place, place) + nearness;
    const float weight = 1 / (from_here * from_here);
    const std::array<float, 4> basis = {1, place.x, place.y, place.z};
    for (std::size_t i = 0; i < 4; ++i) {
      const float share = weight * basis[i];
      for (std::size_t j = i; j < 4; ++j) matrix_[i][j] += share * basis[j];
      right_[i] += share * value;
    }
  }

  bool is_empty() const { return matrix_[0][0] == 0; }

  /// The value at the origin. A small stiffness keeps slopes at 0 that no value determines.
  Quad value_here() {
    const float stiffness = 1e-6f * matrix_[0][0];
    for (std::size_t i = 1; i < 4; ++i) matrix_[i][i] += stiffness;
    for (std::size_t p = 3; p > 0; --p) {
      for (std::size_t i = 0; i < p; ++i) {
        const float share = matrix_[i][p] / matrix_[p][p];
        for (std::size_t j = i; j < p; ++j) matrix_[i][j] -= share * matrix_[j][p];
        right_[i] -= share * right_[p];
      }
    }
    return right_[0] / matrix_[0][0];
  }

 private:
  std::array<std::array<float, 4>, 4> matrix_{};
  std::array<Quad, 4> right_{};
};

/// The colour of a node's value; nothing where no random walk ends on a surface.
std::optional<glm::vec3> color_in(const Quad& value) {
  constexpr float never = 1e-6f;
  if (!(value[3] > never)) return std::nullopt;
  return glm::vec3(value[0], value[1], value[2]) / value[3];
}

Quad quad_of(const Color& color) { return Quad{color.r, color.g, color.b, 1}; }

}  // namespace

/// The cell of a point in some grid, and where the point lies in the cell.
struct FieldSampler::Spot {
  Node cell{};
  glm::vec3 within{0};                  ///< the point's place in the cell, 0..1
  glm::vec3 place{0};                   ///< the point's distance from the origin, in cells
  float scale = 1;                      ///< how many cells of this grid make a side of a cell of the last grid
  double spacing = 0;                   ///< metres
  std::array<const Quad*, 8> corner{};  ///< values at the corners; null where there is none
  bool is_whole = false;                ///< all eight corners have a value
};

FieldSampler::FieldSampler(const SnappedSurfaces& snapped, SolvedGrids solved, CellTriangles triangles)
    : surfaces_(*snapped.surfaces), solved_(std::move(solved)), triangles_(std::move(triangles)) {
  const double unit = 1.0 / static_cast<double>(solved_.grids.back().lattice.units());
  position_.reserve(snapped.position.size());
  for (const auto& p : snapped.position) position_.emplace_back(glm::dvec3(p[0], p[1], p[2]) * unit);
}

FieldSampler::Spot FieldSampler::spot_in(const SolvedGrid& grid, const glm::vec3& point) const {
  // Note the grid's spacing, and how many of its cells make up the side of one of the last grid's.
  Spot spot;
  spot.spacing = grid.lattice.spacing;
  spot.scale =
      static_cast<float>(grid.lattice.count[0] - 1) / static_cast<float>(solved_.grids.back().lattice.count[0] - 1);

  // Find the cell that has the point; outside the grid there is none.
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double place = (static_cast<double>(point[axis]) - grid.lattice.origin[axis]) / grid.lattice.spacing;
    const double low = std::floor(place);
    if (!(low >= 0 && low < grid.lattice.count[a] - 1)) return spot;
    spot.cell[a] = static_cast<int>(low);
    spot.within[axis] = static_cast<float>(place - low);
    spot.place[axis] = static_cast<float>(place);
  }

  // Collect the nodes of the cell that have a value; the cell is whole if all eight do.
  spot.is_whole = true;
  for (int k = 0; k < 8; ++k) {
    const std::int32_t node =
        grid.blocks.node_at(spot.cell[0] + (k & 1), spot.cell[1] + (k >> 1 & 1), spot.cell[2] + (k >> 2));
    const bool is_member =
        node != SparseBlocks::none &&
        (grid.members[static_cast<std::size_t>(node) / SparseBlocks::length] >> node % SparseBlocks::length & 1);
    if (is_member) spot.corner[static_cast<std::size_t>(k)] = &grid.value[static_cast<std::size_t>(node)];
    spot.is_whole = spot.is_whole && is_member;
  }
  return spot;
}

std::optional<FieldSample> FieldSampler::at(const glm::vec3& point) const {
  const SolvedGrid& whole = solved_.grids.back();
  Spot spot = spot_in(whole, point);
  const Node& count = whole.lattice.count;
  if (!(spot.place.x > 0 && spot.place.y > 0 && spot.place.z > 0)) return std::nullopt;
  const auto cell = (static_cast<std::size_t>(spot.cell[2]) * static_cast<std::size_t>(count[1]) +
                     static_cast<std::size_t>(spot.cell[1])) *
                        static_cast<std::size_t>(count[0]) +
                    static_cast<std::size_t>(spot.cell[0]);
  const Node whole_cell = spot.cell;

  // The finest patch that has the point's cell.
  for (std::size_t g = 0; g + 1 < solved_.grids.size(); ++g) {
    const Spot finer = spot_in(solved_.grids[g], point);
    if (!finer.is_whole) continue;
    spot = finer;
    break;
  }
  const auto triangles = triangles_.in(cell);
  if (!triangles.empty()) return beside_surfaces(spot, triangles);
  auto found = between_nodes(spot);
  if (found) found->side = label_near(whole_cell);
  return found;
}

/// The label of a cell without surfaces: that of its one corner with even coordinates, which is visible.
std::optional<std::uint32_t> FieldSampler::label_near(const Node& cell) const {
  const std::int32_t node = solved_.every_other.node_at((cell[0] + 1) / 2, (cell[1] + 1) / 2, (cell[2] + 1) / 2);
  if (node == SparseBlocks::none || solved_.label[static_cast<std::size_t>(node)] == no_side) return std::nullopt;
  return solved_.label[static_cast<std::size_t>(node)];
}

std::optional<FieldSample> FieldSampler::between_nodes(const Spot& spot) const {
  if (!spot.is_whole) return std::nullopt;
  const glm::vec3 f = spot.within;
  Quad sum{};
  for (int k = 0; k < 8; ++k) {
    const float weight = (k & 1 ? f.x : 1 - f.x) * (k & 2 ? f.y : 1 - f.y) * (k & 4 ? f.z : 1 - f.z);
    sum += weight * *spot.corner[static_cast<std::size_t>(k)];
  }
  const auto color = color_in(sum);
  if (!color) return std::nullopt;
  return FieldSample{*color, std::numeric_limits<float>::infinity(), std::nullopt};
}

std::optional<FieldSample> FieldSampler::beside_surfaces(const Spot& spot,
                                                         std::span<const std::uint32_t> triangles) const {
  // Cast rays to the corners, and find the nearest point of any surface.
  ShortRays rays(-spot.within);
  float nearest = std::numeric_limits<float>::infinity();
  glm::vec3 nearest_weight{0}, nearest_place{0};
  std::uint32_t nearest_triangle = 0;
  float nearest_height = 0;
  for (const std::uint32_t t : triangles) {
    const glm::uvec3& corner = surfaces_.triangle[t];
    const SeenTriangle seen{spot.scale * position_[corner.x] - spot.place,
                            spot.scale * position_[corner.y] - spot.place,
                            spot.scale * position_[corner.z] - spot.place};
    rays.meet(seen, t);
    const glm::vec3 weight = nearest_weights(glm::vec3(0), seen.a, seen.b, seen.c);
    const glm::vec3 place = weight.x * seen.a + weight.y * seen.b + weight.z * seen.c;
    const float squared = glm::dot(place, place);
    if (!(squared < nearest)) continue;
    nearest = squared;
    nearest_weight = weight;
    nearest_place = place;
    nearest_triangle = t;
    nearest_height = -glm::dot(seen.a, glm::cross(seen.b - seen.a, seen.c - seen.a));
  }

  // Fit a linear function to what the rays hit.
  const auto colors_of = [&](std::uint32_t t, bool front, const glm::vec3& weight) {
    const glm::uvec3& v = surfaces_.triangle[t];
    const std::vector<Color>& color = front ? surfaces_.front_color : surfaces_.back_color;
    return quad_of(weight.x * color[v.x] + weight.y * color[v.y] + weight.z * color[v.z]);
  };
  LinearFit fit;
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 towards = rays.towards(k);
    if (const auto hit = rays.hit(k)) {
      fit.add(hit->fraction * towards, colors_of(hit->triangle, hit->sees_front, hit->weight));
    } else if (const Quad* value = spot.corner[static_cast<std::size_t>(k)]; value != nullptr && (*value)[3] > 0) {
      fit.add(towards, *value);
    }
  }
  FieldSample found;
  const bool sees_front = nearest_height >= 0;
  if (nearest < std::numeric_limits<float>::infinity()) {
    fit.add(nearest_place, colors_of(nearest_triangle, sees_front, nearest_weight));
    found.side = 2 * nearest_triangle + (sees_front ? 0 : 1);
  }
  if (fit.is_empty()) return std::nullopt;
  const auto color = color_in(fit.value_here());
  if (!color) return std::nullopt;
  found.color = *color;
  found.distance = static_cast<float>(spot.spacing) * std::sqrt(nearest);
  return found;
}

std::size_t FieldSampler::bytes() const {
  std::size_t sum = solved_.every_other.bytes() + solved_.label.size() * sizeof(std::uint32_t) + triangles_.bytes() +
                    position_.size() * sizeof(glm::vec3);
  for (const SolvedGrid& grid : solved_.grids) sum += grid.value.bytes() + grid.blocks.bytes() + grid.members.size();
  return sum;
}

}  // namespace pomona
