// The winding numbers of the parts of a fruit around points on a closed knife.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/carve/arrangement.h"
#include "generator/cut/carve/knife_regions.h"
#include "generator/cut/carve/split_surfaces.h"
#include "generator/cut/section/face.h"
#include "generator/mesh/crossings/tie_rule.h"
#include "generator/mesh/disjoint_sets.h"

namespace pomona {

/// The boundaries of the fruit's parts: skins and cut faces.
struct Boundaries {
  std::vector<Corners> triangle;
  std::vector<std::vector<CellBoundary>> boundary;           ///< per triangle
  std::vector<std::vector<CellBoundary>> boundary_of_facet;  ///< per facet of the arranged fruit
};

class PartWindings {
 public:
  /// \param face the knife's face; each of its triangles is a part of a facet of the arrangement.
  PartWindings(const Arrangement& all, const ExactPoints& places, const Face& face, Boundaries boundaries);

  /// The winding numbers at some triangle of the face that is connected with this one. They are computed at the start
  /// of an edge along which no surface runs, so that both its sides lie in the same bodies.
  KnownWindings near(std::uint32_t triangle);

 private:
  std::vector<CellBoundary> at(std::uint32_t place, const Arrangement::Edge& edge) const;

  const Arrangement& all_;
  const ExactPoints& places_;
  const Face& face_;
  Boundaries boundaries_;
  DisjointSets part_of_;                 // of edges
  std::vector<std::uint32_t> facet_of_;  // per triangle of the face
};

}  // namespace pomona
