// The lines of a solid as the eye sees it, hidden or not: contours of its smooth surfaces, and its sharp edges
// (as the silhouettes of [Northrup & Markosian 2000], in object space).
#pragma once

#include "render/strokes/seen_solid.h"
#include "render/strokes/solid_edges.h"

namespace pomona {

struct LinePoint {
  glm::dvec3 seen{0};      ///< as Lens::seen()
  glm::dvec3 own{0};       ///< in the fruit's own frame, metres
  glm::dvec2 outwards{0};  ///< on the picture, away from the solid; (0, 0) on inner lines
  double slope = 0;        ///< metres of distance per metre across the line, on the surface it lies on; at most 8
  double opacity = 1;
};

struct ObjectLine {
  std::vector<LinePoint> points;  ///< of a closed line the first is not repeated
  bool closed = false;
  LineKind kind = LineKind::contour;
  std::uint32_t instance = 0;
};

/// Contours are where the normal, interpolated on each triangle, is at right angles to the line of sight
/// [Hertzmann & Zorin 2000]: smooth, and linked without a gap, where the edges between front and back faces zigzag. A
/// normal exactly at right angles counts as turned to the eye. Edges whose faces are both turned away are left out.
std::vector<ObjectLine> object_lines(const Solid& solid, const SolidEdges& edges, const SeenSolid& seen,
                                     std::uint32_t instance, const Lens& lens);

}  // namespace pomona
