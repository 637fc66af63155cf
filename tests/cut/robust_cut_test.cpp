// A sample of what bench/cuts does a hundred thousand times: difficult cuts, compared with clipping triangle by
// triangle.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/reproducible.h"
#include "generator/knife/parse_knife.h"
#include "tests/cut/cut_checks.h"
#include "tests/cut/cut_oracle.h"
#include "tests/cut/turned_blocks.h"
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
    }
  }
}

/// A seed that sinks into the wall of its hollow bounds one body with it: its front faces air, and of the wall the
/// back.
TEST(RobustCut, OfASeedInTheWallOfItsHollow) {
  const RandomStream random({12, 0}, "test/robust");
  const DiffusionSurfaces seed = shapes::moved(shapes::sphere(0.008, 3, shapes::skin_paint()), {0.028, 0.002, 0.001});
  const CutOracle oracle(joined(shapes::hollow_ball(0.05, 0.03, 4), seed));
  for (std::uint64_t i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    expect_right(oracle.facts(std::vector<Knife>{oracle.random_plane(random, i)}));
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
    }
  }
}

/// A knife like the fruit's own skin: the middles of its edges are rounded, so it lies partly inside and partly outside
/// of the skin. In floats, open parts close each other.
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

/// A plane that misses a face of the box by less than a double resolves there still differs from one through it.
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

/// Planes in the faces of a turned block, or beside them by about what floats resolve there.
TEST(RobustCut, AlongTheFacesOfATurnedBlock) {
  const RandomStream random({13, 0}, "test/robust");
  const glm::dvec3 half(0.005, 0.01, 0.015);
  for (std::uint64_t i = 0; i < 24; ++i) {
    // The directions of the turned block.
    std::array<glm::dvec3, 3> way;
    for (std::uint64_t k = 0; k < 2; ++k)
      for (std::uint64_t c = 0; c < 3; ++c) way[k][static_cast<int>(c)] = random.uniform(100 * i + 3 * k + c) - 0.5;
    way[0] = glm::normalize(way[0]);
    way[2] = glm::normalize(glm::cross(way[0], way[1]));
    way[1] = glm::cross(way[2], way[0]);
    DiffusionSurfaces block = shapes::box(-half, half, i % 2 == 0 ? 1 : 3, shapes::skin_paint());
    for (glm::vec3& p : block.position) {
      const glm::dvec3 q(p);
      p = glm::vec3(q.x * way[0] + q.y * way[1] + q.z * way[2]);
    }
    const double volume = shapes::signed_volume(block);

    // Two, three or all six faces, each moved in or out equally far.
    for (const double inwards : {0.0, 1e-10, -1e-10, 3e-10, -1e-9, 1e-9, 3e-9, 6e-9, 1e-8, -1e-8, 3e-8, 1e-7}) {
      std::vector<Knife> knives;
      const std::size_t planes = i % 3 == 0 ? 2 : i % 3 == 1 ? 3 : 6;
      for (std::size_t k = 0; k < planes; ++k) {
        const glm::dvec3 normal = (k < 3 ? 1.0 : -1.0) * way[k % 3];
        knives.push_back({PlaneCut(PlaneKnife{{normal, half[static_cast<int>(k % 3)] - inwards}})});
      }
      SCOPED_TRACE(std::to_string(i) + ", " + std::to_string(inwards * 1e9) + " nm");
      const Cut cut = pomona::cut(block, knives, {.coarsest = 0.01, .finest = 0.005});
      double sum = 0;
      for (const CutPiece& piece : cut.pieces) {
        EXPECT_TRUE(piece.closed);
        EXPECT_GT(piece.volume, 0);
        sum += piece.volume;
      }
      EXPECT_NEAR(sum, volume, 1e-6 * volume);
    }
  }
}

/// A sample of the blocks of bench/cuts; the first ones have faces on both sides of the distance that counts as flush.
TEST(RobustCut, OfTurnedBlocksNextToTheirFaces) {
  const RandomStream random({6, 0}, "bench/cuts/blocks");
  std::vector<std::uint64_t> numbers{1634, 1670, 1703, 2069, 3389};
  for (std::uint64_t i = 0; i < 500; ++i) numbers.push_back(i);
  for (const std::uint64_t number : numbers) {
    const oracle::BlockFaults faults = oracle::faults_of(oracle::turned_block_cut(random, number));
    EXPECT_EQ(faults.open, 0) << number;
    EXPECT_EQ(faults.without_volume, 0) << number;
    EXPECT_LE(faults.volume_error, 1e-6) << number;
  }
}

}  // namespace
}  // namespace pomona
