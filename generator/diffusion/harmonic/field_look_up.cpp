#include "generator/diffusion/harmonic/field_look_up.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/short_rays.h"

namespace pomona {

namespace {

/// A linear function through values at places around the origin, the nearer the better: least squares with weights
/// 1 / (d^2 + nearness)^2.
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

  /// At the origin. A trace of stiffness keeps slopes that nothing determines at 0.
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

/// Nothing where no walk would end on a surface.
std::optional<glm::vec3> color_in(const Quad& value) {
  constexpr float never = 1e-6f;
  if (!(value[3] > never)) return std::nullopt;
  return glm::vec3(value[0], value[1], value[2]) / value[3];
}

Quad quad_of(const Color& color) { return Quad{color.r, color.g, color.b, 1}; }

}  // namespace

/// A point's cell, and where it lies in it.
struct FieldLookUp::Spot {
  Node cell{};
  glm::vec3 within{0};  ///< 0..1
  glm::vec3 place{0};   ///< in cells from the origin
};

FieldLookUp::FieldLookUp(const SnappedSurfaces& snapped, SolvedGrid grid, CellTriangles triangles)
    : surfaces_(*snapped.surfaces), grid_(std::move(grid)), triangles_(std::move(triangles)) {
  const double unit = 1.0 / static_cast<double>(grid_.lattice.units());
  position_.reserve(snapped.position.size());
  for (const auto& p : snapped.position) position_.emplace_back(glm::dvec3(p[0], p[1], p[2]) * unit);
}

std::optional<LookedUp> FieldLookUp::at(const glm::vec3& point) const {
  Spot spot;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double place = (static_cast<double>(point[axis]) - grid_.lattice.origin[axis]) / grid_.lattice.spacing;
    const double low = std::floor(place);
    if (!(low >= 0 && low < grid_.lattice.count[a] - 1)) return std::nullopt;
    spot.cell[a] = static_cast<int>(low);
    spot.within[axis] = static_cast<float>(place - low);
    spot.place[axis] = static_cast<float>(place);
  }
  const Node& count = grid_.lattice.count;
  const auto cell = (static_cast<std::size_t>(spot.cell[2]) * static_cast<std::size_t>(count[1]) +
                     static_cast<std::size_t>(spot.cell[1])) *
                        static_cast<std::size_t>(count[0]) +
                    static_cast<std::size_t>(spot.cell[0]);
  const auto triangles = triangles_.in(cell);
  return triangles.empty() ? between_nodes(spot) : beside_surfaces(spot, triangles);
}

std::array<const Quad*, 8> FieldLookUp::corners(const Spot& spot) const {
  std::array<const Quad*, 8> corner{};
  for (int k = 0; k < 8; ++k) {
    const std::int32_t node =
        grid_.runs.node_at(spot.cell[0] + (k & 1), spot.cell[1] + (k >> 1 & 1), spot.cell[2] + (k >> 2));
    if (node != NodeRuns::none) corner[static_cast<std::size_t>(k)] = &grid_.value[static_cast<std::size_t>(node)];
  }
  return corner;
}

std::optional<LookedUp> FieldLookUp::between_nodes(const Spot& spot) const {
  const auto corner = corners(spot);
  const glm::vec3 f = spot.within;
  Quad sum{};
  for (int k = 0; k < 8; ++k) {
    if (corner[static_cast<std::size_t>(k)] == nullptr) return std::nullopt;
    const float weight = (k & 1 ? f.x : 1 - f.x) * (k & 2 ? f.y : 1 - f.y) * (k & 4 ? f.z : 1 - f.z);
    sum += weight * *corner[static_cast<std::size_t>(k)];
  }
  const auto color = color_in(sum);
  if (!color) return std::nullopt;
  return LookedUp{*color, std::numeric_limits<float>::infinity(), std::nullopt};
}

std::optional<LookedUp> FieldLookUp::beside_surfaces(const Spot& spot, std::span<const std::uint32_t> triangles) const {
  // Look towards the corners, and for the nearest place of all.
  ShortRays rays(-spot.within);
  float nearest = std::numeric_limits<float>::infinity();
  glm::vec3 nearest_weight{0}, nearest_place{0};
  std::uint32_t nearest_triangle = 0;
  float nearest_height = 0;
  for (const std::uint32_t t : triangles) {
    const glm::uvec3& corner = surfaces_.triangle[t];
    const SeenTriangle seen{position_[corner.x] - spot.place, position_[corner.y] - spot.place,
                            position_[corner.z] - spot.place};
    rays.meet(seen, t);
    const glm::vec3 weight = nearest_weights(seen);
    const glm::vec3 place = weight.x * seen.a + weight.y * seen.b + weight.z * seen.c;
    const float squared = glm::dot(place, place);
    if (!(squared < nearest)) continue;
    nearest = squared;
    nearest_weight = weight;
    nearest_place = place;
    nearest_triangle = t;
    nearest_height = -glm::dot(seen.a, glm::cross(seen.b - seen.a, seen.c - seen.a));
  }

  // Fit what they see.
  const auto colors_of = [&](std::uint32_t t, bool front, const glm::vec3& weight) {
    const glm::uvec3& v = surfaces_.triangle[t];
    const std::vector<Color>& color = front ? surfaces_.front_color : surfaces_.back_color;
    return quad_of(weight.x * color[v.x] + weight.y * color[v.y] + weight.z * color[v.z]);
  };
  LinearFit fit;
  const auto corner = corners(spot);
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 towards = rays.towards(k);
    if (const auto hit = rays.hit(k)) {
      fit.add(hit->fraction * towards, colors_of(hit->triangle, hit->sees_front, hit->weight));
    } else if (const Quad* value = corner[static_cast<std::size_t>(k)]; value != nullptr && (*value)[3] > 0) {
      fit.add(towards, *value);
    }
  }
  LookedUp found;
  const bool sees_front = nearest_height >= 0;
  if (nearest < std::numeric_limits<float>::infinity()) {
    fit.add(nearest_place, colors_of(nearest_triangle, sees_front, nearest_weight));
    found.side = 2 * nearest_triangle + (sees_front ? 0 : 1);
  }
  if (fit.is_empty()) return std::nullopt;
  const auto color = color_in(fit.value_here());
  if (!color) return std::nullopt;
  found.color = *color;
  found.distance = static_cast<float>(grid_.lattice.spacing) * std::sqrt(nearest);
  return found;
}

std::size_t FieldLookUp::bytes() const {
  return grid_.value.bytes() + grid_.runs.place.size() * sizeof(std::int32_t) +
         grid_.runs.run.size() * sizeof(NodeRun) + triangles_.bytes() + position_.size() * sizeof(glm::vec3);
}

}  // namespace pomona
