// The arrangement of a fruit and a closed knife: the triangles of each, split along the other, so that all parts fit
// together exactly: they share the same points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "generator/cut/carve/exact_points.h"

namespace pomona {

using PlaceTriangle = std::array<std::uint32_t, 3>;

struct Arrangement {
  /// The crossing of an edge with a triangle of the other kind.
  struct Crossing {
    std::uint32_t place = 0;  ///< number of the point
    std::uint32_t facet = 0;  ///< the triangle
    int sense = 0;  ///< 1 if the edge, from low to high, goes from the front of the triangle to its back; else -1
  };
  struct Edge {
    std::uint32_t low = 0, high = 0;    ///< numbers of its end points
    std::vector<std::uint32_t> facets;  ///< its triangles, of one kind, sorted
    std::vector<std::uint32_t> places;  ///< all points on it, without its ends
    std::vector<Crossing> crossings;
  };
  /// The segment in which two triangles intersect, directed as in Intersection.
  struct Segment {
    std::uint32_t from = 0, to = 0;      ///< numbers of its end points; equal where only the tie rule separates them
    std::uint32_t fruit = 0, knife = 0;  ///< the two triangles, as indices of facets
    std::vector<std::uint32_t> places;   ///< all points on it, without its ends
  };
  struct Facet {
    PlaceTriangle corner{};
    std::array<std::uint32_t, 3> edge{};
    std::vector<std::uint32_t> segment;
    FacetMesh mesh;  ///< its triangles and chains; without chains it is the triangle itself
    bool is_whole() const { return mesh.chain.empty(); }
  };

  std::vector<Facet> facet;  ///< the fruit's, then the knife's
  std::size_t fruit_count = 0;
  std::vector<Edge> edge;
  std::vector<Segment> segment;

  bool is_fruit(std::size_t facet_number) const { return facet_number < fruit_count; }
};

/// Computes the arrangement. Triangles are given by the numbers of their points; the corners of a triangle differ.
Arrangement arranged(std::span<const PlaceTriangle> fruit, std::span<const PlaceTriangle> knife, ExactPoints& places);

}  // namespace pomona
