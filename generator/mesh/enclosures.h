// Closed meshes, and which of them wind around a point.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pomona {

class Enclosures {
 public:
  /// A triangle of mesh number `mesh`, counter-clockwise seen from outside.
  struct Triangle {
    std::array<glm::dvec3, 3> corner;
    std::uint32_t mesh = 0;
  };
  explicit Enclosures(std::vector<Triangle> triangles);

  /// The meshes that wind around the point, sorted, with their winding numbers; negative for cavities.
  std::vector<std::pair<std::uint32_t, int>> around(const glm::dvec3& point) const;

  /// The triangles that a line upwards from the point may meet, by their place among those given, ascending; others
  /// too.
  std::span<const std::uint32_t> over(const glm::dvec3& point) const;

 private:
  int column(double v, int axis) const;
  void set_cells(const glm::dvec2& high);
  std::size_t count_entries() const;
  void fill_columns();

  /// Calls visit(first column, last column) for each row of columns that the triangle lies over.
  template <typename Visit>
  void visit_columns(const Triangle& triangle, const Visit& visit) const;

  std::vector<Triangle> triangles_;
  glm::dvec2 low_{0}, cell_{1};
  int across_ = 1;                    // columns along x and along z
  std::vector<std::uint32_t> start_;  // per column, into entry_
  std::vector<std::uint32_t> entry_;  // triangles over the column
};

}  // namespace pomona
