// The face that one blade cuts, triangulated step by step (paper, section 3.2, Figure 3b).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "generator/cut/plane/cut_lines.h"
#include "generator/cut/plane/edge_point.h"
#include "generator/cut/plane/plane_triangulation.h"
#include "generator/cut/plane/unrolled_blade.h"
#include "generator/cut/section/face.h"
#include "generator/cut/section/size_field.h"
#include "generator/mesh/edge_map.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// Two points of the split mesh with the same position.
using Twins = std::pair<std::uint32_t, std::uint32_t>;

/// The face of one blade, and its changes of the split mesh.
struct BladeFace {
  /// A point that the triangulation made.
  struct NewPoint {
    glm::dvec3 place{0};  ///< metres
    int plane = 0;        ///< the plane on which it lies
  };
  Face face;
  std::vector<NewPoint> point;  ///< numbered from `first_new` of finish() on
  std::vector<EdgePoint> edge_point;
  std::vector<Twins> twins;
  Unshared unshared;
};

/// Step by step: conform, sample, conform, update, finish.
class BladeFaceBuilder {
 public:
  /// \param plane that of the blade; for a stroke, that of its first facet. \param segments of all its planes.
  BladeFaceBuilder(const SplitMesh& mesh, const CutPlanes& planes, int plane, std::vector<CutSegment> segments,
                   const std::vector<CutLine>& lines);

  void conform(double shortest) { triangulation_->conform(shortest); }

  /// Adds points inside the section, denser near cut segments.
  void sample(const SizeLimits& limits, const DiffusionSurfaces& surfaces, const Bodies& bodies);

  /// Copies the present state of the triangulation.
  void update();

  /// The result. The builder must not be used afterwards.
  /// \param first_new number of the first new point; at least the split mesh's size.
  BladeFace finish(std::uint32_t first_new) &&;

 private:
  /// An edge of the split mesh as constraints of the triangulation: one, or several where it runs along a line in which
  /// planes meet.
  struct MeshEdge {
    std::uint32_t low = 0, high = 0;  // points
    std::vector<std::uint32_t> constraint;
  };

  std::uint32_t vertex(std::uint32_t point);

  /// The first facet of the blade that the point lies on.
  int facet_of(std::uint32_t point) const;

  /// Rounds to a grid: points that are too near to each other for CGAL become equal.
  glm::dvec2 snapped(const glm::dvec2& p) const { return grid_ * glm::floor(p / grid_ + 0.5); }

  std::uint32_t constraint_between(std::uint32_t p, std::uint32_t q, bool divisible);

  void take_line(std::size_t number);

  void take_segments();

  void take_edge(std::uint32_t low, std::uint32_t high);

  const CutLine* line_with(std::uint32_t p, std::uint32_t q);

  /// Four points far outside, so that no constraint lies on the hull.
  void surround();

  /// The present constraints as sources of the size field. A plane cuts some triangles only at a corner, so a segment's
  /// size is the mean length of the segment and its neighbours on the chain, if that is larger than its own length.
  std::vector<SizeSource> sources(double contrast) const;

  /// The source along an edge. If several surfaces lie on it, the first is used.
  SizeSource source_along(std::uint32_t from, std::uint32_t to, double contrast) const;

  /// The vertices along an edge, from its low to its high end.
  std::vector<std::uint32_t> chain_of(const MeshEdge& edge) const;

  void list_uses(std::uint32_t segment);

  static std::span<const std::uint32_t> inner(const std::vector<std::uint32_t>& chain);

  /// The end of a constraint that is so near that the vertex counts as equal to it; nothing if none is.
  std::optional<std::uint32_t> near_end(std::uint32_t vertex_number, std::uint32_t constraint) const;

  const glm::dvec2& uv(std::uint32_t v) const { return flat_.point[v]; }

  void number_new_points(std::uint32_t first_new);

  /// Which facet each triangle lies on, and its normals.
  void find_facets();

  /// Pairs of points that count as equal: with equal coordinates, or next to a point of a line.
  std::vector<Twins> twins() const;

  /// Points that crossing surfaces have added to lines after the lines were made. The other planes need them, too.
  Unshared unshared() const;

  void list_edge_points(const MeshEdge& edge, std::uint32_t first_new);

  const SplitMesh& mesh_;
  const CutPlanes& planes_;
  UnrolledBlade blade_;
  TriangulatedPlane flat_;  // the face in two dimensions; its triangles are the face's
  BladeFace made_;
  double grid_ = 0;  // a power of two, less than the tolerance
  const std::vector<CutLine>& all_lines_;
  std::vector<std::size_t> lines_;  // of the blade
  std::vector<glm::dvec2> uv_;
  std::vector<PlaneConstraint> constraint_;
  std::vector<std::uint8_t> leads_outside_;                         // per constraint: the end of a line
  std::vector<std::pair<std::size_t, std::uint32_t>> line_pieces_;  // lines, and constraints that are part of them
  std::vector<MeshEdge> edge_;
  std::vector<std::uint32_t> edge_of_segment_;
  std::map<std::uint32_t, std::uint32_t> vertex_of_;
  EdgeMap<std::uint32_t> constraint_of_;
  std::unique_ptr<PlaneTriangulation> triangulation_;
};

}  // namespace pomona
