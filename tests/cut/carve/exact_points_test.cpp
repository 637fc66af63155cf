#include "generator/cut/carve/exact_points.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace pomona {
namespace {

using testing::ElementsAre;
using Way = std::pair<std::uint32_t, std::uint32_t>;

/// Twice the area of a facet's triangles, as a vector: exact where all coordinates are small multiples of powers of 2.
glm::dvec3 area_of(const FacetMesh& mesh, const ExactPoints& places) {
  glm::dvec3 sum(0);
  for (const auto& t : mesh.triangle)
    sum += glm::cross(places.at(t[1]) - places.at(t[0]), places.at(t[2]) - places.at(t[0]));
  return sum;
}

std::set<Way> edges_of(const FacetMesh& mesh) {
  std::set<Way> ways;
  for (const auto& t : mesh.triangle) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(ways.emplace(t[i], t[(i + 1) % 3]).second) << "covered twice";
  }
  return ways;
}

/// All triangles face as the facet does, meet edge to edge, and end at its border; chains follow their edges.
void expect_cover(const PatchedFacet& facet, const FacetMesh& mesh, const ExactPoints& places) {
  const auto [a, b, c] = facet.corner;
  const glm::dvec3 normal = glm::cross(places.at(b) - places.at(a), places.at(c) - places.at(a));
  EXPECT_EQ(area_of(mesh, places), normal);
  for (const auto& t : mesh.triangle) {
    const glm::dvec3 own = glm::cross(places.at(t[1]) - places.at(t[0]), places.at(t[2]) - places.at(t[0]));
    EXPECT_GT(glm::dot(own, normal), 0);
  }

  const std::set<Way> ways = edges_of(mesh);
  std::set<Way> border;
  for (std::size_t i = 0; i < mesh.chain.size(); ++i) {
    for (std::size_t k = 1; k < mesh.chain[i].size(); ++k) {
      const Way way(mesh.chain[i][k - 1], mesh.chain[i][k]);
      if (i < 3) border.insert(way);
      EXPECT_TRUE(ways.contains(way) || ways.contains({way.second, way.first})) << "chain " << i;
    }
  }
  for (const Way& way : ways) EXPECT_NE(ways.contains({way.second, way.first}), border.contains(way));
}

/// A triangle in the plane x + y + z = 16, whose corners are the first points.
PatchedFacet large_facet(ExactPoints& places) {
  return {{places.number_of({16, 0, 0}), places.number_of({0, 16, 0}), places.number_of({0, 0, 16})}, {}, {}};
}

TEST(ExactPoints, GivesEachPlaceOneNumber) {
  ExactPoints places;
  const std::uint32_t first = places.number_of({0.1, 0, 3});
  EXPECT_EQ(places.number_of({0.1, -0.0, 3}), first);
  EXPECT_NE(places.number_of({0.1, 1e-300, 3}), first);
  EXPECT_EQ(places.count(), 2u);
  EXPECT_EQ(places.at(first), glm::dvec3(0.1, 0, 3));
}

TEST(ExactPoints, AppendsWhetherOrNotSomethingLiesThere) {
  ExactPoints places;
  places.append({1, 2, 3});
  places.append({1, 2, 3});
  places.append({4, 5, 6}, false);
  EXPECT_EQ(places.count(), 3u);
  EXPECT_EQ(places.number_of({1, 2, 3}), 0u) << "the first of those that are there";
  EXPECT_EQ(places.number_of({4, 5, 6}), 3u) << "what is not in use is not found";
}

TEST(ExactPoints, FindsWhatWasAppendedWithAZeroOfTheOtherSign) {
  ExactPoints places;
  places.append({-0.0, 1, 2});
  EXPECT_EQ(places.number_of({0, 1, 2}), 0u);
}

TEST(ExactPoints, MeetsAtOnePlaceByManyWays) {
  // A vertical line through (1, 1) meets a plane that rises by a third per step: 1/3 and 2/3 are no doubles.
  ExactPoints places;
  const std::uint32_t p = places.number_of({1, 1, 0}), q = places.number_of({1, 1, 2}),
                      far = places.number_of({1, 1, 7});
  const std::uint32_t a = places.number_of({0, 0, 0}), b = places.number_of({3, 0, 1}), c = places.number_of({0, 3, 1}),
                      d = places.number_of({3, 3, 2});
  const std::uint32_t there = places.intersection(p, q, {a, b, c});
  EXPECT_EQ(there, places.count() - 1);
  EXPECT_EQ(places.at(there), glm::dvec3(1, 1, 2.0 / 3));
  EXPECT_EQ(places.intersection(q, p, {a, b, c}), there);
  EXPECT_EQ(places.intersection(p, far, {c, a, b}), there);
  EXPECT_EQ(places.intersection(far, q, {d, c, b}), there) << "the line counts, and the plane";
  // A line across gives the same point.
  EXPECT_EQ(places.intersection(places.number_of({0, 0, 0}), d, {p, q, places.number_of({5, -3, 0})}), there);
  // A double next to it is another point, though it rounds to the same.
  const std::uint32_t rounded = places.number_of({1, 1, 2.0 / 3});
  EXPECT_NE(rounded, there);
  EXPECT_EQ(places.at(rounded), places.at(there));
}

TEST(ExactPoints, MeetsAtAnEndThatLiesInThePlane) {
  ExactPoints places;
  const std::uint32_t p = places.number_of({0.1, 0.7, 0}), q = places.number_of({0.3, 0.2, 1});
  const std::uint32_t a = places.number_of({0, 0, 0}), b = places.number_of({1, 0, 0}), c = places.number_of({0, 1, 0});
  EXPECT_EQ(places.intersection(p, q, {a, b, c}), p);
  EXPECT_EQ(places.intersection(q, p, {a, b, c}), p);
}

TEST(ExactPoints, TriangulatesAFacetAlone) {
  ExactPoints places;
  for (const auto& turned : {std::array{0, 1, 2}, {1, 2, 0}, {0, 2, 1}}) {
    const std::array<std::uint32_t, 3> corner = large_facet(places).corner;
    PatchedFacet facet;
    for (std::size_t i = 0; i < 3; ++i) facet.corner[i] = corner[static_cast<std::size_t>(turned[i])];
    const FacetMesh mesh = places.triangulated(facet);
    EXPECT_EQ(mesh.triangle.size(), 1u);
    expect_cover(facet, mesh, places);
  }
}

TEST(ExactPoints, NamesACrossingOfSegments) {
  ExactPoints places;
  PatchedFacet facet = large_facet(places);
  const std::uint32_t west = places.number_of({8, 0, 8}), east = places.number_of({4, 12, 0}),
                      south = places.number_of({12, 0, 4}), north = places.number_of({0, 12, 4});
  facet.places = {west, east, south, north};
  facet.segments = {{west, east}, {north, south}};
  const FacetMesh mesh = places.triangulated(facet);
  expect_cover(facet, mesh, places);
  ASSERT_EQ(mesh.chain[3].size(), 3u);
  const std::uint32_t crossing = mesh.chain[3][1];
  EXPECT_EQ(crossing, places.count() - 1);
  EXPECT_THAT(mesh.chain[3], ElementsAre(west, crossing, east));
  EXPECT_THAT(mesh.chain[4], ElementsAre(north, crossing, south));
  EXPECT_EQ(places.at(crossing), glm::dvec3(6, 6, 4));
  EXPECT_EQ(places.number_of({6, 6, 4}), crossing);
  // Edges list the points on them, in their direction: from x to y, from y to z, from z to x.
  EXPECT_THAT(mesh.chain[0], ElementsAre(facet.corner[0], east, facet.corner[1]));
  EXPECT_THAT(mesh.chain[1], ElementsAre(facet.corner[1], north, facet.corner[2]));
  EXPECT_THAT(mesh.chain[2], ElementsAre(facet.corner[2], west, south, facet.corner[0]));
}

TEST(ExactPoints, KeepsSegmentsThatOverlapOrFollowAnEdge) {
  ExactPoints places;
  PatchedFacet facet = large_facet(places);
  const auto on_line = [&](double s) { return places.number_of({16 - 2 * s, s, s}); };
  const std::uint32_t a = on_line(2), b = on_line(3), c = on_line(4), d = on_line(6);
  const std::uint32_t low = places.number_of({12, 4, 0}), high = places.number_of({4, 12, 0});
  facet.places = {b, d};
  facet.segments = {{a, c}, {d, b}, {high, low}, {c, c}};
  const FacetMesh mesh = places.triangulated(facet);
  expect_cover(facet, mesh, places);
  EXPECT_THAT(mesh.chain[3], ElementsAre(a, b, c));
  EXPECT_THAT(mesh.chain[4], ElementsAre(d, c, b));
  EXPECT_THAT(mesh.chain[5], ElementsAre(high, low));
  EXPECT_THAT(mesh.chain[6], ElementsAre(c));
  EXPECT_THAT(mesh.chain[0], ElementsAre(facet.corner[0], low, high, facet.corner[1]));
}

TEST(ExactPoints, GivesEachOfTwoOppositeSegmentsItsOwnDirection) {
  ExactPoints places;
  PatchedFacet facet = large_facet(places);
  const std::uint32_t a = places.number_of({8, 4, 4}), b = places.number_of({4, 8, 4}),
                      on = places.number_of({6, 6, 4});
  facet.places = {on};
  facet.segments = {{b, a}, {a, b}, {on, b}};
  const FacetMesh mesh = places.triangulated(facet);
  EXPECT_THAT(mesh.chain[3], ElementsAre(b, on, a));
  EXPECT_THAT(mesh.chain[4], ElementsAre(a, on, b));
  EXPECT_THAT(mesh.chain[5], ElementsAre(on, b));
}

TEST(ExactPoints, CoversFacetsFullOfSegments) {
  // A fan from the middle of one edge and one from a corner, which cross at points that are no doubles.
  ExactPoints places;
  PatchedFacet facet = large_facet(places);
  const std::uint32_t middle = places.number_of({8, 8, 0});
  for (int i = 1; i < 8; ++i) {
    facet.segments.push_back({middle, places.number_of({2.0 * i, 0, 16 - 2.0 * i})});
    facet.segments.push_back({facet.corner[0], places.number_of({0, 2.0 * i, 16 - 2.0 * i})});
  }
  const FacetMesh mesh = places.triangulated(facet);
  EXPECT_LT(glm::distance(area_of(mesh, places), glm::dvec3(256)), 1e-10);
  EXPECT_EQ(mesh.triangle, places.triangulated(facet).triangle) << "crossings are found again";

  // Segments that cross share a point, and nothing else does: Euler's formula of a disc.
  std::set<std::uint32_t> vertices;
  const std::set<Way> ways = edges_of(mesh);
  std::size_t inner = 0;
  for (const Way& way : ways) {
    vertices.insert(way.first);
    inner += ways.contains({way.second, way.first}) ? 1 : 0;
  }
  const std::size_t edges = ways.size() - inner / 2;
  EXPECT_EQ(vertices.size() + mesh.triangle.size(), edges + 1);
  EXPECT_GT(vertices.size(), 30u);
}

TEST(ExactPoints, GivesTheSameCrossingToBothFacetsThatShareIt) {
  // The same two segments in a facet and in a larger one of the same plane with the opposite orientation.
  ExactPoints places;
  PatchedFacet facet = large_facet(places);
  facet.segments = {{places.number_of({8, 0, 8}), places.number_of({3, 13, 0})},
                    {places.number_of({0, 11, 5}), places.number_of({13, 0, 3})}};
  const std::uint32_t crossing = places.triangulated(facet).chain[3][1];
  PatchedFacet larger = facet;
  larger.corner = {places.number_of({-32, -32, 80}), places.number_of({-32, 80, -32}),
                   places.number_of({80, -32, -32})};
  std::reverse(larger.segments.begin(), larger.segments.end());
  EXPECT_EQ(places.triangulated(larger).chain[3][1], crossing);
}

TEST(ExactPoints, HasNoTrianglesForFacetsWithoutArea) {
  ExactPoints places;
  const std::uint32_t a = places.number_of({0, 0, 0}), b = places.number_of({3, 3, 3}), c = places.number_of({1, 1, 1}),
                      on = places.number_of({2, 2, 2});
  const FacetMesh mesh = places.triangulated({{a, b, c}, {on}, {{on, a}, {c, c}}});
  EXPECT_TRUE(mesh.triangle.empty());
  EXPECT_THAT(mesh.chain[0], ElementsAre(a, c, on, b));
  EXPECT_THAT(mesh.chain[1], ElementsAre(b, on, c));
  EXPECT_THAT(mesh.chain[2], ElementsAre(c, a));
  EXPECT_THAT(mesh.chain[3], ElementsAre(on, c, a));
  EXPECT_THAT(mesh.chain[4], ElementsAre(c));
}

}  // namespace
}  // namespace pomona
