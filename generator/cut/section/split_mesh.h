// All diffusion surfaces, split along the knives so far. Everything that later steps ask - what is cut, which side is
// which, what belongs to which cell - is recorded here as it happens, by identity, and never asked of coordinates
// again.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/base/color.h"
#include "generator/knife/cut_planes.h"
#include "generator/knife/knife_planes.h"

namespace pomona {

struct SplitMesh {
  explicit SplitMesh(const CutPlanes& planes) : sets(planes) {}

  // Points: places in space. Input vertices at equal positions are one point; so are the two ends at which two
  // triangles meet a plane on their common edge.
  std::vector<glm::dvec3> point;         ///< those of the input first
  std::vector<std::uint32_t> planes_of;  ///< per point: which planes it lies on, a number in `sets`
  std::vector<std::uint32_t> same_as;    ///< per point: the point that stands for all those at its place

  // Vertices: points with the attributes that a surface has there. The first are those of the input.
  std::vector<std::uint32_t> point_of;
  std::vector<Color> front_color, back_color;
  std::vector<glm::vec3> normal;  ///< to air, smooth; only where a boundary triangle uses the vertex

  struct Triangle {
    std::array<std::uint32_t, 3> vertex{};
    std::uint32_t source = 0;  ///< the input triangle it is part of
    std::uint32_t cell = 0;    ///< of all knives; cells are numbered knife by knife, the first knife's slowest
    /// Per edge (from corner i to i + 1): the planes it is cut by, of which the triangle lies on the negative side.
    std::array<std::uint32_t, 3> cut_by{};
    KnifeSides sides;  ///< of the knife at work; of no meaning in the result
  };
  std::vector<Triangle> triangle;

  PlaneSets sets;

  /// A point that lies on the planes of this set, and stands for itself. Its number.
  std::uint32_t add_point(const glm::dvec3& place, std::uint32_t set) {
    const auto number = static_cast<std::uint32_t>(point.size());
    point.push_back(place);
    planes_of.push_back(set);
    same_as.push_back(number);
    return number;
  }

  /// A vertex with what a surface has at this point. Its number.
  std::uint32_t add_vertex(std::uint32_t at, const Color& front, const Color& back, const glm::vec3& to_air) {
    point_of.push_back(at);
    front_color.push_back(front);
    back_color.push_back(back);
    normal.push_back(to_air);
    return static_cast<std::uint32_t>(point_of.size() - 1);
  }

  const glm::dvec3& place_of(std::uint32_t vertex) const { return point[point_of[vertex]]; }
};

}  // namespace pomona
