#include "generator/cut/carve/knife_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/cut/carve/part_windings.h"
#include "tests/cut/carve/carving_stages.h"
#include "tests/cut/solid_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using shapes::CarvingCase;
using shapes::CarvingStages;

/// Cell inside the knife, cell outside it, body, winding.
using Filling = std::array<std::int64_t, 4>;

std::vector<Filling> fillings(const std::vector<Regions::Closing>& closes) {
  std::vector<Filling> all;
  for (const Regions::Closing& closing : closes) {
    for (const BodyWinding& w : closing.inside) all.push_back({closing.cell[0], closing.cell[1], w.body, w.winding});
  }
  return all;
}

std::vector<Filling> fillings(const std::vector<CellBoundary>& inside, std::uint32_t stride) {
  std::vector<Filling> all;
  for (const CellBoundary& b : inside) all.push_back({b.cell + stride, b.cell, b.body, b.winding});
  return all;
}

double area_of(const Face& face, std::size_t triangle) {
  const glm::uvec3& t = face.triangle[triangle];
  return glm::length(shapes::area_of({face.place[t.x], face.place[t.y], face.place[t.z]}));
}

/// The walk over the knife's surface counts what solid angles give at every triangle's middle.
TEST(KnifeRegions, AreWhatWindsAroundTheMiddlesOfTheirTriangles) {
  std::map<Filling, double> area;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    CarvingStages stages(of);
    const Regions regions = stages.regions();
    ASSERT_EQ(regions.patch_of.size(), stages.face.triangle.size());
    for (std::size_t t = 0; t < stages.face.triangle.size(); ++t) {
      const std::vector<Filling> wanted = fillings(stages.inside_at(stages.middle(t)), stages.knife.stride);
      EXPECT_EQ(fillings(regions.closed_by(t)), wanted);
      for (const Filling& filling : wanted) area[filling] += area_of(stages.face, t);
    }
  }
  EXPECT_GE(area.size(), 5u) << "cells and bodies of several kinds";
}

TEST(KnifeRegions, CloseEachCellOnceInOrder) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    CarvingStages stages(of);
    for (const Regions::Patch& patch : stages.regions().patch) {
      std::set<std::uint32_t> cells;
      for (const Regions::Closing& closing : patch.closes) {
        EXPECT_FALSE(closing.inside.empty());
        EXPECT_EQ(closing.cell[0], closing.cell[1] + stages.knife.stride);
        EXPECT_TRUE(cells.insert(closing.cell[1]).second);
      }
    }
  }
}

TEST(KnifeRegions, AskOnceForEachPartOfAKnife) {
  for (const auto& [name, parts] : {std::pair("bowl", 1), {"hollow", 1}, {"quarters", 1}, {"two parts", 2}}) {
    CarvingStages stages(shapes::carving_case(name));
    stages.regions();
    EXPECT_EQ(stages.first_calls, parts) << name;
  }
}

/// The walk may begin at any triangle of a part.
TEST(KnifeRegions, AreTheSameWhereverTheyBegin) {
  const CarvingStages stages(shapes::carving_case("tube"));
  const auto fillings_from = [&](std::uint32_t first) {
    const Regions regions = knife_regions(stages.face, stages.split.traces, stages.knife.stride, stages.surfaces,
                                          stages.bodies, [&](std::uint32_t) {
                                            return KnownWindings{first, stages.inside_at(stages.middle(first))};
                                          });
    std::vector<std::vector<Filling>> all;
    for (std::size_t t = 0; t < stages.face.triangle.size(); ++t) all.push_back(fillings(regions.closed_by(t)));
    return all;
  };
  const std::vector<std::vector<Filling>> wanted = fillings_from(0);
  for (std::uint32_t first = 0; first < stages.face.triangle.size(); first += 7)
    EXPECT_EQ(fillings_from(first), wanted) << first;
}

TEST(KnifeRegions, OfAKnifeInTheMiddleAreAllSection) {
  CarvingStages stages(shapes::carving_case("hollow"));
  const Regions regions = stages.regions();
  ASSERT_EQ(regions.patch.size(), 1u);
  EXPECT_EQ(fillings(regions.patch[0].closes), (std::vector<Filling>{{1, 0, 0, 1}}));
}

/// The case with one triangle of its fruit left out.
CarvingCase with_hole(CarvingCase of, std::size_t triangle) {
  DiffusionSurfaces& surfaces = of.surfaces;
  const auto leave_out = [&](auto& all) { all.erase(all.begin() + static_cast<std::ptrdiff_t>(triangle)); };
  leave_out(surfaces.triangle);
  leave_out(surfaces.surface);
  leave_out(surfaces.front_part);
  leave_out(surfaces.back_part);
  return of;
}

/// The boundary of an open body divides the knife's surface, or ends on it: what it does not separate from the outside
/// is not filled, whatever rounding does to lengths.
TEST(KnifeRegions, FillOpenBodiesWhereTheirBoundaryCloses) {
  int closed = 0, open = 0;
  for (int step = 0; step < 4; ++step) {
    CarvingCase of = shapes::carving_case("bowl");
    for (glm::dvec3& p : of.knife.point) p += static_cast<double>(step) * glm::dvec3(0.0004, 0.0007, 0.0005);
    const CarvingStages whole(of);
    for (std::size_t hole = 0; hole < of.surfaces.triangle_count(); hole += 3) {
      CarvingStages stages(with_hole(of, hole));
      const Regions regions = stages.regions();
      const bool is_parted = stages.split.traces.edges.size() == whole.split.traces.edges.size();
      (is_parted ? closed : open) += 1;
      for (std::size_t t = 0; t < stages.face.triangle.size(); ++t) {
        const bool is_inside = !whole.inside_at(stages.middle(t)).empty();
        EXPECT_EQ(regions.is_section(t), is_parted && is_inside) << hole;
      }
    }
  }
  EXPECT_GT(closed, 100);
  EXPECT_GT(open, 10);
}

/// A ring passes through the knife's surface twice: a hole beside one of its two boundaries leaves the other closed,
/// and what the closed one bounds is filled, although the body is open.
TEST(KnifeRegions, FillOpenBodiesAsFarAsTheyAreClosed) {
  const CarvingCase of{"ring", shapes::torus(0.03, 0.01, 12, 8), {}, shapes::ball({0.0303, 0.0007, 0.0011}, 0.018, 3)};
  const CarvingStages whole(of);
  int opened = 0, filled = 0;
  for (std::size_t hole = 0; hole < of.surfaces.triangle_count() && opened < 4; ++hole) {
    const glm::uvec3& corner = of.surfaces.triangle[hole];
    const double side = static_cast<double>(of.surfaces.position[corner.x].z);
    if (std::fabs(side) < 0.01) continue;
    CarvingStages stages(with_hole(of, hole));
    if (stages.split.traces.edges.size() == whole.split.traces.edges.size()) continue;
    ++opened;
    const Regions regions = stages.regions();
    for (std::size_t t = 0; t < stages.face.triangle.size(); ++t) {
      if (stages.middle(t).z * side > 0) continue;
      const bool is_inside = !whole.inside_at(stages.middle(t)).empty();
      EXPECT_EQ(regions.is_section(t), is_inside) << hole;
      if (is_inside) {
        EXPECT_EQ(fillings(regions.closed_by(t)), (std::vector<Filling>{{1, 0, 0, 1}})) << hole;
        ++filled;
      }
    }
  }
  EXPECT_EQ(opened, 4);
  EXPECT_GT(filled, 10);
}

TEST(Cross, TakesBackWhatItAdded) {
  const RandomStream random({7, 0}, "tests/cross");
  std::vector<CellBoundary> inside;
  std::map<std::pair<std::uint32_t, std::int32_t>, int> wanted;
  std::vector<std::pair<std::vector<CellBoundary>, int>> taken;
  const auto expect_wanted = [&] {
    std::vector<std::tuple<std::uint32_t, std::int32_t, int>> found, listed;
    for (const CellBoundary& b : inside) found.emplace_back(b.cell, b.body, b.winding);
    for (const auto& [key, winding] : wanted) {
      if (winding != 0) listed.emplace_back(key.first, key.second, winding);
    }
    EXPECT_EQ(found, listed);
  };

  // Cross boundaries of three cells and three bodies in both directions.
  for (std::uint64_t n = 0; n < 200; ++n) {
    const auto draw = [&](std::uint64_t k) { return static_cast<int>(3 * random.uniform(8 * n + k)); };
    const std::vector<CellBoundary> boundary{{static_cast<std::uint32_t>(draw(0)), draw(1), draw(2) + 1},
                                             {static_cast<std::uint32_t>(draw(3)), draw(4), -1}};
    const int times = draw(5) == 0 ? -1 : 1;
    cross(inside, boundary, times);
    taken.emplace_back(boundary, times);
    for (const CellBoundary& b : boundary) wanted[{b.cell, b.body}] += times * b.winding;
    expect_wanted();
  }

  // And back again.
  for (const auto& [boundary, times] : taken) cross(inside, boundary, -times);
  EXPECT_TRUE(inside.empty());
}

}  // namespace
}  // namespace pomona
