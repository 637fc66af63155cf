// The lines of a solid from a viewpoint, hidden or not: contours of its smooth surfaces, and its sharp edges (as the
// silhouettes of [Northrup & Markosian 2000], in object space).
#pragma once

#include "render/strokes/seen_solid.h"
#include "render/strokes/solid_edges.h"

namespace pomona {

struct LinePoint {
  glm::dvec3 seen{0};      ///< as Lens::seen()
  glm::dvec3 own{0};       ///< in the fruit's own frame, metres
  glm::dvec2 outwards{0};  ///< on the picture, away from the solid; (0, 0) on inner lines
  double slope = 0;        ///< change of the surface's distance per metre across the line; at most 8
  double opacity = 1;
};

struct ObjectLine {
  std::vector<LinePoint> points;  ///< a closed line does not repeat its first point
  bool closed = false;
  LineKind kind = LineKind::contour;
  std::uint32_t instance = 0;
};

/// A contour is where the normal, interpolated on each triangle, is perpendicular to the line of sight [Hertzmann &
/// Zorin 2000]. Such contours are smooth and have no gaps; the edges between front and back faces would zigzag. A
/// normal exactly perpendicular counts as facing the eye. Edges whose faces both face away are left out.
std::vector<ObjectLine> object_lines(const Solid& solid, const SolidEdges& edges, const SeenSolid& seen,
                                     std::uint32_t instance, const Lens& lens);

}  // namespace pomona
