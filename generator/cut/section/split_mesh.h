// All diffusion surfaces, split along the knives so far. Later steps need to know what is cut, which side is which, and
// what belongs to which cell. This is recorded here, by the numbers of points, when it is decided; no later step
// decides it again from coordinates.
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

  // Points: positions in space. Input vertices with equal positions are one point. Where a plane cuts the common edge
  // of two triangles, both get the same point.
  std::vector<glm::dvec3> point;         ///< those of the input first
  std::vector<std::uint32_t> planes_of;  ///< per point: which planes it lies on, a number in `sets`
  std::vector<std::uint32_t> same_as;    ///< per point: the representative of all points with the same position

  // Vertices: points with the attributes that a surface has there. The first are those of the input.
  std::vector<std::uint32_t> point_of;
  std::vector<Color> front_color, back_color;
  std::vector<glm::vec3> normal;  ///< smooth, towards air; only for vertices of boundary triangles

  struct Triangle {
    std::array<std::uint32_t, 3> vertex{};
    std::uint32_t source = 0;  ///< the input triangle it is part of
    std::uint32_t cell = 0;    ///< cell of all knives together; the number of the first knife's cell varies slowest
    /// Per edge (from corner i to i + 1): the planes that cut it and on whose negative side the triangle lies.
    std::array<std::uint32_t, 3> cut_by{};
    KnifeSides sides;  ///< of the present knife; not used in the result
  };
  std::vector<Triangle> triangle;

  PlaneSets sets;

  /// Adds a point on the planes of this set, which is its own representative. Returns its number.
  std::uint32_t add_point(const glm::dvec3& place, std::uint32_t set) {
    const auto number = static_cast<std::uint32_t>(point.size());
    point.push_back(place);
    planes_of.push_back(set);
    same_as.push_back(number);
    return number;
  }

  /// Adds a vertex with the attributes of a surface at this point. Returns its number.
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
