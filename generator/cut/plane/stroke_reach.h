// What a stroke's facets may reach, so that not every facet looks at everything.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/plane/flat_grid.h"
#include "generator/cut/section/split_mesh.h"

namespace pomona {

/// A stretch of a line in the view along -Z, metres.
struct FlatStretch {
  glm::dvec2 from{0}, to{0};
};

/// The facet and `more` beyond its ends; ends that go on without end, as far as `farthest` from its start.
FlatStretch stretch_of(const Stroke::Facet& facet, double more, double farthest);

/// The triangles of a mesh while a stroke splits them. Parts of a triangle lie within its box and meet the neighbours
/// that it had at the start of the stroke.
class StrokeReach {
 public:
  StrokeReach(const SplitMesh& mesh, const glm::dvec2& low, const glm::dvec2& high);

  /// The mesh's last triangle is part of another one.
  void add_part_of(std::uint32_t triangle);

  /// All triangles and parts within `margin` of the stretch, and others; in ascending order.
  std::vector<std::uint32_t> near(const FlatStretch& stretch, double margin) const;

  /// All that share an edge with one of these, and others; in ascending order.
  std::vector<std::uint32_t> neighbours(const std::vector<std::uint32_t>& triangles) const;

 private:
  std::vector<std::uint32_t> parts_of(const std::vector<std::uint32_t>& wholes) const;

  FlatGrid grid_;                                      // of whole triangles
  std::vector<std::array<std::uint32_t, 3>> corner_;   // points, per whole triangle
  std::vector<std::uint32_t> at_point_, point_begin_;  // whole triangles by point; per point: its first
  std::vector<std::uint32_t> whole_;                   // per triangle
  std::vector<std::uint32_t> before_, newest_;         // per triangle: the part before it; per whole one: its last part
};

}  // namespace pomona
