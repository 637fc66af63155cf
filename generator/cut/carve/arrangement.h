// The triangles of a fruit and those of a closed knife, each split where it meets the other kind, so that all parts fit
// together by identity.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "generator/cut/carve/exact_places.h"

namespace pomona {

using PlaceTriangle = std::array<std::uint32_t, 3>;

struct Arrangement {
  /// Where an edge passes through a triangle of the other kind.
  struct Crossing {
    std::uint32_t place = 0;
    std::uint32_t facet = 0;  ///< the triangle
    int sense = 0;            ///< on the way from low to high: 1 from its front to its back, -1 the other way
  };
  struct Edge {
    std::uint32_t low = 0, high = 0;    ///< places
    std::vector<std::uint32_t> facets;  ///< of one kind, ascending
    std::vector<std::uint32_t> places;  ///< all that lie on it, but its ends
    std::vector<Crossing> crossings;
  };
  /// Where two triangles meet, directed as a Meeting is.
  struct Segment {
    std::uint32_t from = 0, to = 0;      ///< places; one where the tie rule alone makes them two
    std::uint32_t fruit = 0, knife = 0;  ///< facets
    std::vector<std::uint32_t> places;   ///< that lie on it, but its ends
  };
  struct Facet {
    PlaceTriangle corner{};
    std::array<std::uint32_t, 3> edge{};
    std::vector<std::uint32_t> segment;
    FacetMesh mesh;  ///< chains of its edges and segments; the triangle itself where nothing is on it
    bool is_whole() const { return mesh.chain.empty(); }
  };

  std::vector<Facet> facet;  ///< the fruit's, then the knife's
  std::size_t fruit_count = 0;
  std::vector<Edge> edge;
  std::vector<Segment> segment;

  bool is_fruit(std::size_t facet_number) const { return facet_number < fruit_count; }
};

/// Triangles by the numbers of their places, no two corners of one alike.
Arrangement arranged(std::span<const PlaceTriangle> fruit, std::span<const PlaceTriangle> knife, ExactPlaces& places);

}  // namespace pomona
