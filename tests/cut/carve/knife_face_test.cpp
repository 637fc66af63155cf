#include "generator/cut/carve/knife_face.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/cut/carve/carving_stages.h"
#include "tests/cut/solid_shapes.h"

namespace pomona {
namespace {

using shapes::CarvingCase;
using shapes::CarvingStages;
using Way = std::pair<std::uint32_t, std::uint32_t>;

Corners corners_of(const Face& face, std::size_t triangle) {
  const glm::uvec3& t = face.triangle[triangle];
  return {face.place[t.x], face.place[t.y], face.place[t.z]};
}

glm::dvec3 area_of(const Face& face, std::size_t triangle) { return shapes::area_of(corners_of(face, triangle)); }

TEST(KnifeFace, CoversEveryTriangleOfTheKnifeWithItsParts) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const Face& face = stages.face;
    std::size_t next = 0;
    for (std::size_t k = 0; k < stages.knife.mesh.triangle.size(); ++k) {
      const glm::dvec3 whole = shapes::area_of(stages.knife.mesh.corners(k));
      glm::dvec3 sum(0);
      const std::size_t end = next + stages.all.facet[stages.all.fruit_count + k].mesh.triangle.size();
      for (; next < end; ++next) {
        if (!shapes::is_collapsed(corners_of(face, next))) {
          EXPECT_GT(glm::dot(area_of(face, next), whole), 0);
        }
        EXPECT_EQ(face.facet[next], stages.knife.mesh.triangle[k].face);
        sum += area_of(face, next);
      }
      EXPECT_LT(glm::distance(sum, whole), 1e-12 * glm::length(whole));
    }
    EXPECT_EQ(next, face.triangle.size());
    EXPECT_EQ(face.plane, stages.knife.plane);
  }
}

TEST(KnifeFace, HasEveryPlaceOnceAndWhereTheMeshHasIt) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    const CarvingStages stages(of);
    const Face& face = stages.face;
    const std::set<std::uint32_t> points(face.point.begin(), face.point.end());
    EXPECT_EQ(points.size(), face.point.size());
    ASSERT_EQ(face.place.size(), face.point.size());
    for (std::size_t v = 0; v < face.point.size(); ++v)
      EXPECT_EQ(face.place[v], stages.split.fruit.mesh.point[face.point[v]]);
  }
}

/// True if `second` is the neighbour of `first` across that edge of it, and uses the edge in the opposite direction.
bool is_met_by(const Face& face, std::uint32_t first, std::size_t side, std::uint32_t second) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (face.corner(second, i) == face.corner(first, side + 1) &&
        face.corner(second, i + 1) == face.corner(first, side) &&
        face.neighbor[second][i] == static_cast<std::int32_t>(first)) {
      return true;
    }
  }
  return false;
}

void expect_neighbors_meet(const Face& face) {
  ASSERT_EQ(face.neighbor.size(), face.triangle.size());
  for (std::uint32_t t = 0; t < face.triangle.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_GE(face.neighbor[t][i], 0) << "a closed knife has no rim";
      EXPECT_TRUE(is_met_by(face, t, i, static_cast<std::uint32_t>(face.neighbor[t][i])));
    }
  }
}

TEST(KnifeFace, NeighborsAreMutualAndRunTheirEdgeTheOtherWay) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    expect_neighbors_meet(CarvingStages(of).face);
  }
}

/// At the common edge of two blocks four triangles meet. Whatever their order, two that use it in the same direction
/// are no neighbours.
TEST(KnifeFace, PairsTheFourTrianglesAtAnEdgeOfTwoSolids) {
  CarvingCase of = shapes::carving_case("bowl");
  ClosedSurface both = shapes::block({0.01, 0.002, -0.02}, {0.03, 0.02, 0.02});
  const ClosedSurface second = shapes::block({0.03, 0.02, -0.02}, {0.06, 0.03, 0.02});
  for (const glm::uvec3& t : second.triangle) both.triangle.push_back(t + 8u);
  both.point.insert(both.point.end(), second.point.begin(), second.point.end());
  of.knife = both;
  for (std::size_t order = 0; order < 72; order += 3) {
    const std::size_t stride = std::array{5u, 7u, 11u}[order / 24];
    for (std::size_t t = 0; t < both.triangle.size(); ++t)
      of.knife.triangle[t] = both.triangle[(stride * t + order) % both.triangle.size()];
    const CarvingStages stages(of);
    expect_neighbors_meet(stages.face);
    std::map<Way, int> triangles_at;
    for (const glm::uvec3& t : stages.face.triangle) {
      for (int i = 0; i < 3; ++i) ++triangles_at[std::minmax({t[i], t[(i + 1) % 3]})];
    }
    const auto of_four = [](const auto& entry) { return entry.second == 4; };
    EXPECT_TRUE(std::any_of(triangles_at.begin(), triangles_at.end(), of_four));
  }
}

/// The edges of all traces by points of the arrangement, from low to high.
std::set<Way> traced(const KnifeTraces& traces) {
  std::set<Way> ways;
  for (const CutSegment& s : traces.segments) ways.insert(std::minmax(s.from, s.to));
  for (const KnifeEdge& e : traces.edges) ways.insert(std::minmax(e.from, e.to));
  return ways;
}

TEST(KnifeFace, IsConstrainedAlongTracesAndNowhereElse) {
  std::size_t constrained = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const Face& face = stages.face;
    const std::set<Way> ways = traced(stages.split.traces);
    std::set<Way> found;
    for (std::size_t t = 0; t < face.triangle.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Way way = std::minmax({face.point[face.corner(t, i)], face.point[face.corner(t, i + 1)]});
        EXPECT_EQ(face.constrained[t][i] != 0, ways.contains(way));
        if (face.constrained[t][i]) found.insert(way);
      }
    }
    EXPECT_EQ(found, ways) << "traces are sides of triangles";
    constrained += found.size();
  }
  EXPECT_GT(constrained, 400u);
}

/// Triangles of the knife change bodies or cells only where surfaces pass through it: so what no constraint separates
/// lies in the same.
TEST(KnifeFace, PartsWhatLiesInDifferentBodiesByConstraints) {
  std::size_t parted = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const Face& face = stages.face;
    std::vector<std::vector<std::array<int, 3>>> inside(face.triangle.size());
    for (std::size_t t = 0; t < face.triangle.size(); ++t) {
      for (const CellBoundary& b : stages.inside_at(stages.middle(t)))
        inside[t].push_back({static_cast<int>(b.cell), b.body, b.winding});
    }
    for (std::size_t t = 0; t < face.triangle.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (inside[t] == inside[static_cast<std::size_t>(face.neighbor[t][i])]) continue;
        EXPECT_TRUE(face.constrained[t][i]);
        ++parted;
      }
    }
  }
  EXPECT_GT(parted, 400u);
}

TEST(KnifeFace, UsesEverySegmentOnceInItsDirection) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const Face face = CarvingStages(of).face;
    std::vector<int> uses(face.segment.size(), 0);
    for (const EdgeUse& use : face.edges) {
      EXPECT_LT(use.low, use.high);
      const CutSegment& segment = face.segment.at(use.segment);
      EXPECT_EQ(face.point[use.forward ? use.low : use.high], segment.from);
      EXPECT_EQ(face.point[use.forward ? use.high : use.low], segment.to);
      ++uses[use.segment];
    }
    for (const int count : uses) EXPECT_EQ(count, 1);
    EXPECT_TRUE(std::is_sorted(face.edges.begin(), face.edges.end(), [](const EdgeUse& a, const EdgeUse& b) {
      return std::tuple(a.low, a.high, a.segment) < std::tuple(b.low, b.high, b.segment);
    }));
  }
}

TEST(KnifeFace, IsShadedAsTheKnifeIs) {
  // A ball's normals point away from its middle, up to the error between corners.
  const CarvingStages bowl(shapes::carving_case("bowl"));
  for (std::size_t t = 0; t < bowl.face.triangle.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 out = glm::normalize(bowl.face.place[bowl.face.corner(t, i)] - glm::dvec3(0.045, 0.003, 0.002));
      EXPECT_GT(glm::dot(out, glm::dvec3(bowl.face.normal[t][i])), 0.995);
      EXPECT_NEAR(glm::length(bowl.face.normal[t][i]), 1, 1e-6);
    }
  }

  // Normals of a block are those of its faces.
  const CarvingStages flat(shapes::carving_case("quarters"));
  for (std::size_t t = 0; t < flat.face.triangle.size(); ++t) {
    for (const glm::vec3& n : flat.face.normal[t])
      EXPECT_GT(glm::dot(glm::normalize(area_of(flat.face, t)), glm::dvec3(n)), 1 - 1e-6);
  }
}

}  // namespace
}  // namespace pomona
