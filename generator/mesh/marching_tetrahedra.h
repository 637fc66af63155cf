// Marching tetrahedra [Doi & Koide 1991] for level sets of several functions at once. Each tetrahedron is split along
// one level set after the other; the surface lies between the parts inside and the parts outside.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "generator/mesh/closed_surface.h"
#include "generator/mesh/edge_map.h"

namespace pomona {

/// Builds the boundary of a region that is bounded by level sets of up to three functions. The functions are given at
/// vertices and linear in each tetrahedron. Tetrahedra that share a face split it in the same way, so the surface is
/// closed (by the numbers of its points) and cannot cross itself.
class LevelSurface {
 public:
  using Values = std::array<double, 3>;
  using Tetrahedron = std::array<std::uint32_t, 4>;
  struct Level {
    std::size_t function = 0;
    double value = 0;
    std::optional<std::size_t> where = std::nullopt;  ///< only along edges on which this function is not negative
  };

  /// \param period of a periodic function, such as an angle; 0 for others. Values of a periodic function are within
  /// half a period.
  explicit LevelSurface(const Values& period = {}) : period_(period) {}

  std::uint32_t add_vertex(const glm::dvec3& place, const Values& values);

  /// A tetrahedron (a, b, c, d), d on the side from which a, b, c run counter-clockwise. `is_inside` is asked for each
  /// part, with the values at its corners; at those that a level made they are the level's to the bit.
  void add(const Tetrahedron& whole, const std::vector<Level>& levels,
           const std::function<bool(const std::array<Values, 4>&)>& is_inside);

  /// The surface of everything that was added, facing outwards.
  ClosedSurface solid() const;

 private:
  std::uint32_t vertex_between(std::uint32_t a, std::uint32_t b, const Level& level);
  bool is_crossed(std::uint32_t a, std::uint32_t b, const Level& level) const;
  void split(std::vector<Tetrahedron>& parts, const Level& level);

  Values period_;
  std::vector<glm::dvec3> place_;
  std::vector<Values> values_;
  EdgeMap<std::uint32_t> between_;
  std::vector<glm::uvec3> surface_;
};

}  // namespace pomona
