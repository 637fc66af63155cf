// The right result of a cut, found independently: the input's triangles clipped one by one in quadruple precision,
// without mesh, chains and triangulation; and difficult knives.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/base/random.h"
#include "generator/cut/cut.h"
#include "generator/surface/bodies.h"

namespace pomona::oracle {

/// The errors of a cut.
struct CutFacts {
  double area_error = 0;    ///< of the section in one plane, the worst; share of the fruit's size squared; planes only
  double volume_error = 0;  ///< of all pieces together; share of the whole
  double side_error = 0;    ///< of the pieces on one side, with a single plane; share of the whole
  int open_chains = 0;      ///< ends of cut segments of closed bodies that meet nothing
  int open_pieces = 0;      ///< where all bodies are closed
  int pieces = 0;
};

/// Overlaps count once (generator/cut/unite). It knows no half-planes of wedges. Of closed knives it checks only pieces
/// and volumes.
class CutOracle {
 public:
  explicit CutOracle(const DiffusionSurfaces& surfaces);

  CutFacts facts(std::span<const Knife> knives) const;

  /// The diagonal of the fruit's bounding box, metres.
  double size() const { return size_; }

  /// A random plane through the fruit.
  Knife random_plane(const RandomStream& random, std::uint64_t number) const;

  /// Alternately: through a vertex, level with one, along an edge, in the plane of a triangle, touching the fruit, and
  /// touching its bounding box. `number` chooses which.
  Knife degenerate_plane(const RandomStream& random, std::uint64_t number) const;

  /// A stroke of up to twenty edges through the fruit, its corners anywhere or, alternately, over vertices of the
  /// fruit.
  Knife random_stroke(const RandomStream& random, std::uint64_t number) const;

  /// A ball, a block or a rod, alternately: anywhere; through a vertex of the fruit; with a face that touches it; as
  /// large as its bounding box; and the fruit's own skin.
  Knife random_solid(const RandomStream& random, std::uint64_t number) const;

 private:
  CutFacts facts_of_pieces(std::span<const CutPiece> pieces) const;
  double area_in(const CuttingPlane& plane) const;
  double volume_below(const CuttingPlane& plane) const;
  static double volume_below(std::span<const CutPiece> pieces, const CuttingPlane& plane);
  glm::dvec3 corner(const RandomStream& random, std::uint64_t draw) const;

  DiffusionSurfaces surfaces_;  // without overlaps
  ClosedSurface own_skin_;
  Bodies bodies_;
  double size_ = 0, whole_ = 0;
  bool closed_ = true;
};

}  // namespace pomona::oracle
