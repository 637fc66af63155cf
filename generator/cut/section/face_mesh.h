// One cutting sheet, a plane or a stroke, triangulated: what its triangles and edges are in the split mesh.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "generator/cut/plane/triangulate.h"
#include "generator/cut/plane/unrolled.h"
#include "generator/cut/section/cross_section.h"
#include "generator/cut/section/segments.h"

namespace pomona {

/// A cut segment, or a part of one, that an edge of the triangulation follows.
struct EdgeUse {
  std::uint32_t low = 0, high = 0;  ///< vertices of the triangulation
  std::uint32_t segment = 0;        ///< index into FaceMesh::segment
  bool forward = false;             ///< the segment runs from low to high
};

/// What the sheet is to planes and strokes, of the surface of a closed knife. Its triangulation has no points in two
/// dimensions.
struct SolidFaces {
  std::vector<glm::dvec3> place;                 ///< per vertex of the triangulation
  std::vector<std::array<glm::vec3, 3>> normal;  ///< per triangle, of its corners
  std::vector<std::uint32_t> facet;              ///< per triangle
  std::vector<CutFace> frame;                    ///< per facet
};

struct FaceMesh {
  int plane = 0;  ///< index into CutPlanes; of a stroke's, the first facet's
  Unrolled sheet;
  std::optional<SolidFaces> solid;  ///< of a closed knife's surface, which has no plane and no sheet
  std::vector<Segment> segment;
  TriangulatedPlane mesh;
  std::vector<std::uint32_t> point;  ///< per vertex of the triangulation: the point of the split mesh
  std::vector<EdgeUse> edges;        ///< sorted by (low, high, segment)

  /// The segments that the edge from p to q follows.
  std::span<const EdgeUse> uses(std::uint32_t p, std::uint32_t q) const;

  double distance(std::uint32_t p, std::uint32_t q) const;  ///< of two vertices

  // What becomes a cut face each: a plane, the facets of a stroke, the smooth parts of a closed surface.
  std::size_t facets() const;
  std::size_t facet_of(std::size_t triangle) const;
  const CutFace& frame(std::size_t facet) const;

  std::array<glm::vec3, 3> normals(std::size_t triangle) const;  ///< of its corners
};

}  // namespace pomona
