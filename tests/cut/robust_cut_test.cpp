// A sample of what bench/cuts does a hundred thousand times: difficult cuts, compared with clipping triangle by
// triangle.
#include <cmath>

#include <gtest/gtest.h>

#include "generator/base/random.h"
#include "generator/base/reproducible.h"
#include "generator/knife/parse_knife.h"
#include "tests/cut/cut_checks.h"
#include "tests/cut/cut_oracle.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using oracle::CutFacts;
using oracle::CutOracle;

void expect_right(const CutFacts& facts) {
  EXPECT_LE(facts.area_error, 1e-9);
  EXPECT_LE(facts.volume_error, 1e-6);
  EXPECT_LE(facts.side_error, 1e-6);
  EXPECT_EQ(facts.open_chains, 0);
  EXPECT_EQ(facts.open_pieces, 0);
}

TEST(RobustCut, OfPlanesOutForTrouble) {
  const RandomStream random({8, 0}, "test/robust");
  for (const DiffusionSurfaces& fruit : shapes::fruits_to_cut()) {
    const CutOracle oracle(fruit);
    for (std::uint64_t i = 0; i < 120; ++i) {
      const std::vector<Knife> knives{oracle.degenerate_plane(random, i)};
      SCOPED_TRACE(i);
      expect_right(oracle.facts(knives));
      if (HasFailure()) return;
    }
  }
}

TEST(RobustCut, OfRandomPlanesOneAndTwo) {
  const RandomStream random({9, 0}, "test/robust");
  for (const DiffusionSurfaces& fruit : shapes::fruits_to_cut()) {
    const CutOracle oracle(fruit);
    for (std::uint64_t i = 0; i < 60; ++i) {
      std::vector<Knife> knives{oracle.random_plane(random, 2 * i)};
      if (i % 2 == 1) knives.push_back(oracle.random_plane(random, 2 * i + 1));
      SCOPED_TRACE(i);
      expect_right(oracle.facts(knives));
      if (HasFailure()) return;
    }
  }
}

TEST(RobustCut, OfStrokesAnywhereAndOverVertices) {
  const RandomStream random({10, 0}, "test/robust");
  for (const DiffusionSurfaces& fruit : shapes::fruits_to_cut()) {
    const CutOracle oracle(fruit);
    for (std::uint64_t i = 0; i < 30; ++i) {
      const std::vector<Knife> knives{oracle.random_stroke(random, i)};
      SCOPED_TRACE(i);
      expect_right(oracle.facts(knives));
      if (HasFailure()) return;
    }
  }
}

TEST(RobustCut, OfClosedSurfacesOutForTrouble) {
  const RandomStream random({11, 0}, "test/robust");
  for (const DiffusionSurfaces& fruit : shapes::fruits_to_cut()) {
    const CutOracle oracle(fruit);
    for (std::uint64_t i = 0; i < 45; ++i) {
      std::vector<Knife> knives{oracle.random_solid(random, i)};
      if (i % 4 == 1) knives.insert(knives.begin(), parse_knife("half"));
      if (i % 4 == 2) knives.push_back(oracle.random_solid(random, 1000 + 7 * i));
      SCOPED_TRACE(i);
      expect_right(oracle.facts(knives));
      if (HasFailure()) return;
    }
  }
}

/// A knife as uneven as this fruit's own skin: the middles of its edges are rounded, so it lies inside and outside the
/// skin by turns. In floats, parts that are open by themselves close each other.
TEST(RobustCut, AlongTheFruitsOwnSkin) {
  DiffusionSurfaces fruit = shapes::sphere(0.05, 20, shapes::skin_paint());
  for (glm::vec3& p : fruit.position) {
    for (int i = 0; i < 3; ++i) {
      p[i] *= 1 + 0.1f * static_cast<float>(reproducible::sin(3700 * static_cast<double>(p[(i + 1) % 3])));
      if (std::fabs(p[i]) < 0.02f) p[i] *= 1e-3f;
    }
  }
  const CutOracle oracle(fruit);
  expect_right(oracle.facts(std::vector{oracle.random_solid(RandomStream({12, 0}, "test/robust"), 8)}));
}

/// The place behind a vertex is the same one, but for the last bit of a float.
DiffusionSurfaces slim_body() {
  DiffusionSurfaces body = shapes::sphere(0.09, 7, shapes::skin_paint());
  for (glm::vec3& p : body.position) {
    p.x *= 0.08f;
    p.z *= 0.08f;
    if (p.z < 0) p.x = std::nextafter(p.x, 1.0f);
  }
  return body;
}

/// Slight bends over one vertex, and past the one behind it by little more than what counts as the same place.
TEST(RobustCut, OfStrokesThatBendOverVerticesAndAlmostOverOthers) {
  const DiffusionSurfaces body = slim_body();
  const CutOracle oracle(body);
  for (std::size_t v = 0; v < body.vertex_count(); ++v) {
    const glm::dvec2 bend(body.position[v]), way(0.03, 0.02);
    for (const double turn : {0.03, 0.06, 0.12, 0.25}) {
      const glm::dvec2 end = bend + way + turn * glm::dvec2(-way.y, way.x);
      const Knife knife{PlaneCut(StrokeKnife{{bend - way, bend, end}})};
      SCOPED_TRACE(std::to_string(v) + ", " + std::to_string(turn));
      expect_right(oracle.facts({&knife, 1}));
    }
  }
}

/// A plane that misses a face of the box by less than a double resolves there is still told from one through it.
TEST(RobustCut, TellsAFaceFromAPlaneNextToIt) {
  const DiffusionSurfaces box = shapes::box({0, 0, 0}, {1, 1, 1}, 2, shapes::skin_paint());
  const CutOracle oracle(box);
  for (const double offset : {0.0, 1e-300, -1e-300, 1e-17, 1.0, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)}) {
    SCOPED_TRACE(offset);
    const Knife knife{PlaneCut(PlaneKnife{{{0, 1, 0}, offset}})};
    const CutFacts facts = oracle.facts(std::vector<Knife>{knife});
    expect_right(facts);
    EXPECT_EQ(facts.pieces, offset > 0 && offset < 1 ? 2 : 1);
  }
}

}  // namespace
}  // namespace pomona
