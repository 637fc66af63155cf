// Places in space known exactly, however they were constructed, and triangulations between them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A triangle with what lies on it: all by number of place.
struct PatchedFacet {
  std::array<std::uint32_t, 3> corner{};
  std::vector<std::uint32_t> places;                   ///< on the triangle
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< to be kept; they may cross, overlap and lie on edges
};

struct FacetMesh {
  std::vector<std::array<std::uint32_t, 3>> triangle;  ///< turned as the facet is
  /// What the facet's edges (from corner i to i + 1), and then its segments, consist of, both ends included; a place
  /// alone where the ends are one.
  std::vector<std::vector<std::uint32_t>> chain;
};

/// Places by number, each once: two ways to one place lead to one number.
class ExactPlaces {
 public:
  ExactPlaces();
  ~ExactPlaces();
  ExactPlaces(const ExactPlaces&) = delete;
  ExactPlaces& operator=(const ExactPlaces&) = delete;

  /// The next number, whether or not another place lies there; `known` is false for numbers that are not in use.
  void append(const glm::dvec3& place, bool known = true);

  std::uint32_t number_of(const glm::dvec3& place);

  /// Where the line through p and q meets the plane of a triangle to which it is not parallel.
  std::uint32_t meeting(std::uint32_t p, std::uint32_t q, const std::array<std::uint32_t, 3>& triangle);

  /// The constrained Delaunay triangulation, seen along the axis that is nearest to the facet's normal. New places
  /// where segments cross. No triangles for a facet without area.
  FacetMesh triangulated(const PatchedFacet& facet);

  std::size_t count() const;

  /// Rounded to doubles.
  const glm::dvec3& at(std::uint32_t place) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace pomona
