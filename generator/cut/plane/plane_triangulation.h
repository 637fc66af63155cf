// Constrained triangulation of one cutting plane. It hides CGAL from the other files.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/base/left_in_flight.h"

namespace pomona {

/// A segment the triangulation must keep, between two of the points it was given.
struct PlaneConstraint {
  std::uint32_t a = 0, b = 0;
  bool divisible = true;  ///< conform() may put points on it; a crossing always does
};

/// The state of a triangulation as plain arrays, numbered the same on every run.
struct TriangulatedPlane {
  static constexpr std::int32_t none = -1;

  std::vector<glm::dvec2> point;        ///< the given ones first (those at equal places keep only the first in use)
  std::vector<std::uint32_t> stand_in;  ///< per given point: the first point with the same position
  std::vector<glm::uvec3> triangle;     ///< counter-clockwise
  std::vector<std::array<std::int32_t, 3>> neighbor;     ///< across the edge from corner i to i + 1; or none
  std::vector<std::array<std::uint8_t, 3>> constrained;  ///< that edge is part of a constraint
  std::vector<std::vector<std::uint32_t>> chain;         ///< per constraint: its points from a to b; empty if a is b
};

class PlaneTriangulation {
 public:
  /// Constraints may cross, overlap and touch; where they cross a point is made.
  PlaneTriangulation(std::span<const glm::dvec2> points, std::span<const PlaneConstraint> constraints);
  ~PlaneTriangulation();
  PlaneTriangulation(const PlaneTriangulation&) = delete;
  PlaneTriangulation& operator=(const PlaneTriangulation&) = delete;

  /// Splits divisible constraints until they are Delaunay edges, or shorter than `shortest`.
  void conform(double shortest);

  /// Adds free points. They must not lie on constraints.
  void insert(std::span<const glm::dvec2> points);

  TriangulatedPlane state() const;

  /// The triangle each point lies in, as numbered by the latest state() if nothing was added since; or none.
  std::vector<std::int32_t> locate(std::span<const glm::dvec2> points) const;

 private:
  struct Data;
  std::unique_ptr<Data, LeftInFlight<Data>> data_;
};

}  // namespace pomona
