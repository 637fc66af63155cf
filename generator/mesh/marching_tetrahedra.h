// Marching tetrahedra [Doi & Koide 1991], for levels of several functions at once: surfaces on which functions have
// given values. Each tetrahedron is split along one level after the other, and the surface is what then lies between
// the parts inside and those outside.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "generator/mesh/closed_surface.h"
#include "generator/mesh/edge_map.h"

namespace pomona {

/// Collects the boundary of a region that levels of up to three functions border. The functions are known at vertices
/// and linear in each tetrahedron. Tetrahedra that share a face split it alike, so the surface closes by identity and
/// cannot cross itself.
class LevelSurface {
 public:
  using Values = std::array<double, 3>;
  using Tetrahedron = std::array<std::uint32_t, 4>;
  struct Level {
    std::size_t function = 0;
    double value = 0;
    std::optional<std::size_t> where = std::nullopt;  ///< only along edges on which this function is not negative
  };

  /// `period`: of a function that starts anew, an angle's for one; 0 for others. Such values lie within half of it.
  explicit LevelSurface(const Values& period = {}) : period_(period) {}

  std::uint32_t add_vertex(const glm::dvec3& place, const Values& values);

  /// A tetrahedron (a, b, c, d), d on the side from which a, b, c run counter-clockwise. `is_inside` is asked for each
  /// part, with the values at its corners; at those that a level made they are the level's to the bit.
  void add(const Tetrahedron& whole, const std::vector<Level>& levels,
           const std::function<bool(const std::array<Values, 4>&)>& is_inside);

  /// What has been added up to now, facing outwards.
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
