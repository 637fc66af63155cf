// Relief of skins: pits around parts, such as a strawberry's achenes, and spots. It changes shading only; no vertex
// moves.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// The relief at a place on a skin.
struct PitPlace {
  double height = 0;    ///< height in metres, below 0 in pits and sunken spots
  glm::dvec3 slope{0};  ///< slope of the height, metres per metre, not yet projected into the skin
  double inside = 0;    ///< 0 = outside of all pits, 1 = in the middle of one
};

/// A pit around each grain of a part with `pit` that a solid shows on its skin. With x the distance from the grain's
/// middle as a share of the pit's radius, which is `wider` times the grain's own,
/// height = -pit (1 - x^2)^2, from x = 1 on 0 A spot stands out, or is sunk, by its relief times its cover there
/// (cover_of). Heights add up. shaders/skin_pits.glsl does the same.
class SkinPits {
 public:
  static constexpr double wider = 1.9;

  explicit SkinPits(const Solid& solid);

  bool empty() const { return pits_.empty() && spots_.empty(); }
  std::size_t count() const { return pits_.size(); }

  /// \param normal unit normal of the surface, towards air.
  PitPlace at(const glm::dvec3& place, const glm::dvec3& normal) const;

  /// Texels for shaders: the grid's lowest corner and the side of its cells; the numbers of cells along x, y and z; for
  /// each cell the start of its list in these texels, its number of pits and of spots; the lists, two texels a pit
  /// (middle and radius, depth) and six a spot (middle and radius, tangent and stretch, normal and softness, four
  /// waves, relief).
  std::vector<glm::vec4> texels() const;

 private:
  struct Pit {
    glm::dvec3 middle{0};
    double radius = 0, depth = 0;
  };

  void find(const Solid& solid);
  void add_pits(const std::vector<std::uint32_t>& own, const glm::dvec3& place, PitPlace& found) const;
  void add_spots(const std::vector<std::uint32_t>& own, const glm::dvec3& place, const glm::dvec3& normal,
                 PitPlace& found) const;
  void sort_into_cells();
  glm::ivec3 cell_at(const glm::dvec3& place) const;
  std::size_t index(const glm::ivec3& cell) const;

  /// Indices of the pits and spots that reach into a cell.
  struct Cell {
    std::vector<std::uint32_t> pits, spots;
  };

  std::vector<Pit> pits_;
  std::vector<Spot> spots_;
  glm::dvec3 low_{0};
  double side_ = 1;  // side of a cell, metres
  glm::ivec3 count_{0};
  std::vector<Cell> cells_;
};

}  // namespace pomona
