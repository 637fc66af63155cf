// One cutting sheet triangulated step by step.
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
#include "generator/cut/plane/face_meshes.h"
#include "generator/cut/section/size_field.h"

namespace pomona {

/// Two points of the split mesh at one place.
using Twins = std::pair<std::uint32_t, std::uint32_t>;

/// Points on lines that not all planes there know of.
using Unshared = std::map<const CutLine*, std::vector<std::uint32_t>>;

/// Triangulates one plane step by step: conform, sample, conform, update, finish.
class FaceBuilder {
 public:
  FaceBuilder(const SplitMesh& mesh, const CutPlanes& planes, int plane, std::vector<Segment> segments,
              const std::vector<CutLine>& lines);

  void conform(double shortest) { triangulation_->conform(shortest); }

  /// Points spread inside the section, finer near cut segments.
  void sample(const SizeLimits& limits, const DiffusionSurfaces& surfaces, const Bodies& bodies);

  /// Takes over the triangulation's present state.
  void update();

  /// Makes new points of the triangulation points of `mesh`, the one that was built from.
  FaceMesh finish(SplitMesh& mesh, FaceMeshes& all, std::vector<Twins>& twins, Unshared& unshared);

 private:
  /// An edge of the split mesh as constraints of the triangulation: one, or several where it runs along a line in which
  /// planes meet.
  struct MeshEdge {
    std::uint32_t low = 0, high = 0;  // points
    std::vector<std::uint32_t> constraint;
  };

  std::uint32_t vertex(std::uint32_t point);

  /// The first facet of the sheet that the point lies on.
  int facet_of(std::uint32_t point) const;

  /// Points too near to each other for what CGAL computes of them become one.
  glm::dvec2 snapped(const glm::dvec2& p) const { return grid_ * glm::floor(p / grid_ + 0.5); }

  std::uint32_t constraint_between(std::uint32_t p, std::uint32_t q, bool divisible);

  void take_line(const CutLine& line);

  void take_segments();

  void take_edge(std::uint32_t low, std::uint32_t high);

  const CutLine* line_with(std::uint32_t p, std::uint32_t q);

  /// Four points far outside, so that no constraint lies on the hull.
  void surround();

  /// Constraints as they are now. A plane cuts triangles at random, some only at a corner: so a segment counts with
  /// the mean length of itself and its neighbours on the chain, if that is more than its own.
  std::vector<SizeSource> sources(double contrast) const;

  /// Where several surfaces lie on one edge, the first counts.
  SizeSource source_along(std::uint32_t from, std::uint32_t to, double contrast) const;

  /// The vertices along an edge, from its low to its high end.
  std::vector<std::uint32_t> chain_of(const MeshEdge& edge) const;

  void list_uses(std::uint32_t segment);

  static std::span<const std::uint32_t> inner(const std::vector<std::uint32_t>& chain);

  /// The end of a constraint that the vertex cannot be told from; or none.
  std::optional<std::uint32_t> near_end(std::uint32_t vertex_number, std::uint32_t constraint) const;

  const glm::dvec2& uv(std::uint32_t v) const { return face_.mesh.point[v]; }

  /// Pairs of points that are one place: at equal coordinates, or next to a point of a line.
  void list_twins(std::vector<Twins>& twins) const;

  /// Points that crossing surfaces have put on lines after these were laid out. The other planes must have them too.
  void list_unshared(Unshared& unshared) const;

  void list_edge_points(const MeshEdge& edge, std::vector<EdgePoint>& edge_points) const;

  const SplitMesh& mesh_;
  const CutPlanes& planes_;
  FaceMesh face_;
  double grid_ = 0;  // a power of two, less than the tolerance
  std::vector<const CutLine*> lines_;
  std::vector<glm::dvec2> uv_;
  std::vector<PlaneConstraint> constraint_;
  std::vector<std::uint8_t> leads_outside_;                            // per constraint: the end of a line
  std::vector<std::pair<const CutLine*, std::uint32_t>> line_pieces_;  // with their constraints
  std::vector<MeshEdge> edge_;
  std::vector<std::uint32_t> edge_of_segment_;
  std::map<std::uint32_t, std::uint32_t> vertex_of_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> constraint_of_;
  std::unique_ptr<PlaneTriangulation> triangulation_;
};

}  // namespace pomona
