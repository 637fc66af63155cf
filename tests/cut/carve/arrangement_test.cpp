#include "generator/cut/carve/arrangement.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/cut/carve/arranged_shapes.h"

namespace pomona {
namespace {

using shapes::ArrangedShapes;
using testing::UnorderedElementsAreArray;
using Way = std::pair<std::uint32_t, std::uint32_t>;

std::vector<std::uint32_t> chain_of(const Arrangement::Facet& facet, std::size_t edge) {
  if (facet.is_whole()) return {facet.corner[edge], facet.corner[(edge + 1) % 3]};
  return facet.mesh.chain[edge];
}

TEST(Arrangement, GivesBothFacetsAtAnEdgeTheSamePlacesOnIt) {
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    const ArrangedShapes shapes(pair.fruit, pair.knife);
    std::map<std::uint32_t, std::vector<std::vector<std::uint32_t>>> chains;
    for (const Arrangement::Facet& facet : shapes.all.facet) {
      for (std::size_t i = 0; i < 3; ++i) {
        std::vector<std::uint32_t> chain = chain_of(facet, i);
        if (chain.front() != shapes.all.edge[facet.edge[i]].low) std::reverse(chain.begin(), chain.end());
        chains[facet.edge[i]].push_back(chain);
      }
    }
    for (const auto& [number, of_facets] : chains) {
      const Arrangement::Edge& edge = shapes.all.edge[number];
      ASSERT_EQ(of_facets.size(), 2u);
      EXPECT_EQ(of_facets[0], of_facets[1]);
      std::vector<std::uint32_t> places = edge.places;
      places.push_back(edge.low);
      places.push_back(edge.high);
      EXPECT_THAT(of_facets[0], UnorderedElementsAreArray(places));
    }
  }
}

TEST(Arrangement, GivesBothFacetsThatMeetTheSamePlacesBetweenThem) {
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    const ArrangedShapes shapes(pair.fruit, pair.knife);
    std::map<std::uint32_t, std::vector<std::vector<std::uint32_t>>> chains;
    for (const Arrangement::Facet& facet : shapes.all.facet) {
      for (std::size_t i = 0; i < facet.segment.size(); ++i)
        chains[facet.segment[i]].push_back(facet.mesh.chain[3 + i]);
    }
    EXPECT_EQ(chains.size(), shapes.all.segment.size());
    for (const auto& [number, of_facets] : chains) {
      const Arrangement::Segment& segment = shapes.all.segment[number];
      ASSERT_EQ(of_facets.size(), 2u);
      EXPECT_EQ(of_facets[0], of_facets[1]);
      EXPECT_EQ(of_facets[0].front(), segment.from);
      EXPECT_EQ(of_facets[0].back(), segment.to);
    }
  }
}

/// Closed surfaces stay closed after the split, by identity of points.
TEST(Arrangement, KeepsClosedSurfacesClosed) {
  std::size_t parts = 0;
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    const ArrangedShapes shapes(pair.fruit, pair.knife);
    for (const bool of_fruit : {true, false}) {
      std::map<Way, int> balance;
      for (std::size_t f = 0; f < shapes.all.facet.size(); ++f) {
        if (shapes.all.is_fruit(f) != of_fruit) continue;
        for (const PlaceTriangle& t : shapes.all.facet[f].mesh.triangle) {
          ++parts;
          for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = t[i], to = t[(i + 1) % 3];
            balance[std::minmax(from, to)] += from < to ? 1 : -1;
          }
        }
      }
      for (const auto& [way, sum] : balance) EXPECT_EQ(sum, 0);
    }
  }
  EXPECT_GT(parts, 1000u);
}

glm::dvec3 area_of(const PlaceTriangle& t, const ExactPoints& places) {
  return glm::cross(places.at(t[1]) - places.at(t[0]), places.at(t[2]) - places.at(t[0]));
}

TEST(Arrangement, CoversEveryFacetWithItsParts) {
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    const ArrangedShapes shapes(pair.fruit, pair.knife);
    for (const Arrangement::Facet& facet : shapes.all.facet) {
      const glm::dvec3 whole = area_of(facet.corner, shapes.places);
      glm::dvec3 sum(0);
      for (const PlaceTriangle& t : facet.mesh.triangle) {
        const glm::dvec3 part = area_of(t, shapes.places);
        EXPECT_GT(glm::dot(part, whole), 0);
        sum += part;
      }
      EXPECT_LT(glm::distance(sum, whole), 1e-12);
    }
  }
}

/// The segments in which two closed surfaces intersect form loops: as many end at a point as begin there.
TEST(Arrangement, ClosesTheWaysInWhichSurfacesMeet) {
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    const ArrangedShapes shapes(pair.fruit, pair.knife);
    std::map<std::uint32_t, int> balance;
    for (const Arrangement::Segment& s : shapes.all.segment) {
      ++balance[s.from];
      --balance[s.to];
    }
    for (const auto& [place, sum] : balance) EXPECT_EQ(sum, 0) << place;
  }
}

/// Seen from outside the knife, the front of the fruit's triangle lies left of the segment: its direction is that of
/// the cross product of the normals.
TEST(Arrangement, DirectsSegmentsByTheFrontsOfTheirFacets) {
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    const ArrangedShapes shapes(pair.fruit, pair.knife);
    for (const Arrangement::Segment& s : shapes.all.segment) {
      if (s.from == s.to) continue;
      const glm::dvec3 way = shapes.places.at(s.to) - shapes.places.at(s.from);
      const glm::dvec3 along = glm::cross(area_of(shapes.all.facet[s.fruit].corner, shapes.places),
                                          area_of(shapes.all.facet[s.knife].corner, shapes.places));
      if (along == glm::dvec3(0)) continue;  // in one plane only the tie rule gives a direction
      EXPECT_GT(glm::dot(way, along), 0);
    }
  }
}

/// From one end of an edge to the other, crossings change the winding number of the other surface.
TEST(Arrangement, CountsWhatEdgesCross) {
  std::size_t crossings = 0;
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    const ArrangedShapes shapes(pair.fruit, pair.knife);
    const auto winding = [&](std::uint32_t place, bool by_knife) {
      int sum = 0;
      for (const Corners& t : by_knife ? shapes.knife : shapes.fruit) {
        sum += by_knife ? winding_of_knife(t, shapes.places.at(place)) : winding_of_fruit(t, shapes.places.at(place));
      }
      return sum;
    };
    for (const Arrangement::Edge& edge : shapes.all.edge) {
      const bool of_fruit = shapes.all.is_fruit(edge.facets.front());
      int change = 0;
      for (const Arrangement::Crossing& c : edge.crossings) {
        EXPECT_NE(shapes.all.is_fruit(c.facet), of_fruit);
        change += c.sense;
      }
      crossings += edge.crossings.size();
      EXPECT_EQ(change, winding(edge.high, of_fruit) - winding(edge.low, of_fruit));
    }
  }
  EXPECT_GT(crossings, 250u);
}

TEST(Arrangement, LeavesAloneWhatDoesNotMeet) {
  const std::vector<Corners> box = shapes::convex_shapes().front();
  std::vector<Corners> far = box;
  for (Corners& t : far) {
    for (glm::dvec3& p : t) p += glm::dvec3(10, 0, 0);
  }
  const ArrangedShapes shapes(box, far);
  EXPECT_TRUE(shapes.all.segment.empty());
  for (const Arrangement::Facet& facet : shapes.all.facet) {
    EXPECT_TRUE(facet.is_whole());
    EXPECT_EQ(facet.mesh.triangle, std::vector{facet.corner});
  }
}

}  // namespace
}  // namespace pomona
