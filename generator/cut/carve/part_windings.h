// How often the parts of a fruit wind around places on a closed knife.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/carve/arrangement.h"
#include "generator/cut/carve/knife_regions.h"
#include "generator/cut/carve/split_surfaces.h"
#include "generator/cut/carve/tie_rule.h"
#include "generator/cut/section/face.h"
#include "generator/mesh/disjoint_sets.h"

namespace pomona {

/// All that bounds the fruit's parts: skins and cut faces.
struct Boundaries {
  std::vector<Corners> triangle;
  std::vector<std::vector<CellBoundary>> boundary;           ///< per triangle
  std::vector<std::vector<CellBoundary>> boundary_of_facet;  ///< per facet of the arranged fruit
};

class PartWindings {
 public:
  /// \param face the knife's, of which each triangle is a part of a facet of the arrangement.
  PartWindings(const Arrangement& all, const ExactPlaces& places, const Face& face, Boundaries boundaries);

  /// Of some triangle of the face that hangs together with this one. Starts at the beginning of an edge along which no
  /// surface runs: both its sides lie in the same bodies.
  KnownWindings near(std::uint32_t triangle);

 private:
  std::vector<CellBoundary> at(std::uint32_t place, const Arrangement::Edge& edge) const;

  const Arrangement& all_;
  const ExactPlaces& places_;
  const Face& face_;
  Boundaries boundaries_;
  DisjointSets part_of_;                 // of edges
  std::vector<std::uint32_t> facet_of_;  // per triangle of the face
};

}  // namespace pomona
