// Exact points, however they were constructed, and triangulations of them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A triangle with the points and segments on it. All are given by the numbers of points.
struct PatchedFacet {
  std::array<std::uint32_t, 3> corner{};
  std::vector<std::uint32_t> places;                   ///< points on the triangle
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< constraints; they may cross, overlap and lie on edges
};

struct FacetMesh {
  std::vector<std::array<std::uint32_t, 3>> triangle;  ///< with the orientation of the facet
  /// The points along each of the facet's edges (from corner i to i + 1), and then along each of its segments, with
  /// both ends; a single point if the ends are equal.
  std::vector<std::vector<std::uint32_t>> chain;
};

/// Numbered points, each stored once: a point that is constructed in two ways has one number.
class ExactPoints {
 public:
  ExactPoints();
  ~ExactPoints();
  ExactPoints(const ExactPoints&) = delete;
  ExactPoints& operator=(const ExactPoints&) = delete;

  /// Adds a point with the next number, even if there is an equal point. `known` is false for numbers that are not
  /// used.
  void append(const glm::dvec3& place, bool known = true);

  std::uint32_t number_of(const glm::dvec3& place);

  /// The intersection of the line through p and q with the plane of a triangle. They must not be parallel.
  std::uint32_t intersection(std::uint32_t p, std::uint32_t q, const std::array<std::uint32_t, 3>& triangle);

  /// The constrained Delaunay triangulation, projected along the axis that is nearest to the facet's normal. Makes new
  /// points where segments cross. Returns no triangles for a facet of area 0.
  FacetMesh triangulated(const PatchedFacet& facet);

  std::size_t count() const;

  /// The point, rounded to doubles.
  const glm::dvec3& at(std::uint32_t place) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace pomona
