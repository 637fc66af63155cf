// Triangles divided along the lines in which other bodies pass through them.
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "generator/mesh/crossings/facet_parts.h"

namespace pomona {
namespace {

using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

void pass(Edges& edges, std::uint32_t from, std::uint32_t to) {
  edges[std::minmax(from, to)] += from < to ? 1 : -1;
  if (edges[std::minmax(from, to)] == 0) edges.erase(std::minmax(from, to));
}

/// The edges of parts that lie inside or outside, without those between two of them.
Edges border_of(const std::vector<FacetPart>& parts, std::int32_t inside) {
  Edges edges;
  for (const FacetPart& part : parts)
    for (std::size_t k = 0; part.inside == inside && k < 3; ++k) pass(edges, part.corner[k], part.corner[(k + 1) % 3]);
  return edges;
}

/// Else the surface has a hole as wide as nothing, through which nothing can be united any more.
TEST(FacetParts, EndAtEachPointOfALineThoughRoundingMakesTwoOne) {
  std::vector<glm::dvec3> place{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {5, 0, 0}, {0, 5, 0}};
  std::vector<std::uint32_t> line{3};
  for (int i = 1; i < 16; ++i) {
    const double x = 5 - 5 * i / 16.0;
    line.push_back(static_cast<std::uint32_t>(place.size()));
    place.emplace_back(x, 5 - x + 0.2 * (i % 3), 0);
    if (i % 5 != 0) continue;
    line.push_back(static_cast<std::uint32_t>(place.size()));
    place.push_back(place.back());
  }
  line.push_back(4);
  CrossedFacet facet{{0, 1, 2}, {{{3}, {}, {4}}}, {}};
  Edges within, beyond;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    facet.segment.push_back({line[i], line[i + 1], 7});
    pass(within, line[i], line[i + 1]);
    pass(beyond, line[i + 1], line[i]);
  }
  for (const auto& [from, to] : {std::pair{4u, 0u}, {0u, 3u}}) pass(within, from, to);
  for (const auto& [from, to] : {std::pair{3u, 1u}, {1u, 2u}, {2u, 4u}}) pass(beyond, from, to);

  const auto parts = parts_of(facet, place);
  ASSERT_TRUE(parts);
  EXPECT_EQ(border_of(*parts, 7), within);
  EXPECT_EQ(border_of(*parts, FacetPart::outside), beyond);
}

}  // namespace
}  // namespace pomona
