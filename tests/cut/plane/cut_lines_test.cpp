// Lines in which planes and facets meet have the same points for all of them.
#include "generator/cut/plane/cut_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/cut/plane/split.h"
#include "generator/knife/parse_knife.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Knife oblique(const glm::dvec3& normal, double offset) {
  return {PlaneCut(PlaneKnife{{glm::normalize(normal), offset}}), "oblique"};
}

Knife stroke(std::vector<glm::dvec2> points) { return {PlaneCut(StrokeKnife{std::move(points)}), "stroke"}; }

/// A fruit, split, and the lines in which its knives' planes meet.
struct Lines {
  Lines(std::string knives_name, const DiffusionSurfaces& fruit, const std::vector<Knife>& knives)
      : name(std::move(knives_name)),
        bounds(bounds_of(fruit)),
        planes(cut_planes(knives, bounds)),
        all{SplitMesh(planes), {}} {
    SplitMesh mesh = split(fruit, planes);
    surface_points = mesh.point.size();
    segments = cut_segments(mesh, fruit, find_bodies(fruit), planes.count());
    all = cut_lines(std::move(mesh), planes, segments, bounds);
  }

  bool is_used(int plane) const { return !segments[static_cast<std::size_t>(plane)].empty(); }

  bool is_on(std::uint32_t point, int plane) const { return all.mesh.sets.has(all.mesh.planes_of[point], plane); }

  std::string name;
  Box<double> bounds;
  CutPlanes planes;
  std::vector<std::vector<CutSegment>> segments;
  std::size_t surface_points = 0;  ///< points before any line was laid out
  CutLines all;
};

/// Dice, wedges with and without a level plane, oblique planes, and strokes across planes and each other.
std::vector<Lines> lines_of_knives() {
  const DiffusionSurfaces ball = shapes::nested_spheres(0.05, 0.02, 5);
  const DiffusionSurfaces generic = shapes::tilted(ball);
  const Knife bent = stroke({{-0.03, -0.02}, {0.004, 0.013}, {0.03, 0.001}});
  std::vector<Lines> all;
  all.emplace_back("dice", generic, std::vector{parse_knife("dice:4")});
  all.emplace_back("wedges", generic, std::vector{parse_knife("wedges:5"), parse_knife("across")});
  all.emplace_back("even wedges", ball, std::vector{parse_knife("wedges:6"), oblique({1, 3, -1}, 0.004)});
  all.emplace_back("wedges far up", shapes::moved(ball, {0, 0.4, 0}), std::vector{parse_knife("wedges:5")});
  all.emplace_back("oblique", generic,
                   std::vector{oblique({1, 2, 3}, 0.004), oblique({-2, 1, 0.5}, -0.003), oblique({0.3, -0.2, 1}, 0.002),
                               oblique({1, -1, 0.1}, 0.01), parse_knife("half")});
  all.emplace_back(
      "stroke", generic,
      std::vector{bent, parse_knife("half"), oblique({0.2, 1, 0.3}, 0.003), oblique({-1.5, 1, 0.1}, 0.0139)});
  all.emplace_back("strokes", generic, std::vector{bent, stroke({{-0.011, 0.04}, {0.002, -0.001}, {0.015, -0.04}})});
  all.emplace_back("two fruits", joined(ball, shapes::moved(ball, {0.03, 0.01, 0.02})),
                   std::vector{parse_knife("sticks:3"), parse_knife("half")});
  return all;
}

double along(const CutLine& line, const glm::dvec3& place) { return glm::dot(line.direction, place - line.origin); }

bool has(const std::vector<std::uint32_t>& points, std::uint32_t point) {
  return std::find(points.begin(), points.end(), point) != points.end();
}

/// Error of rounding at a line's ends, far from the fruit.
constexpr double rounding = 1e-14;

void expect_on_planes(const Lines& lines, const CutLine& line, const CutLines& all) {
  for (const std::uint32_t p : line.points) {
    for (const int k : line.planes) {
      EXPECT_TRUE(all.mesh.sets.has(all.mesh.planes_of[p], k));
      EXPECT_NEAR(signed_distance(lines.planes[k].plane, all.mesh.point[p]), 0, rounding);
    }
  }
}

TEST(CutLines, LieOnTheirPlanes) {
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);
    EXPECT_GT(lines.all.lines.size(), 0u);
    for (const CutLine& line : lines.all.lines) {
      ASSERT_GE(line.planes.size(), 2u);
      EXPECT_TRUE(std::is_sorted(line.planes.begin(), line.planes.end()));
      EXPECT_NEAR(glm::length(line.direction), 1, 1e-12);
      expect_on_planes(lines, line, lines.all);
    }
  }
}

TEST(CutLines, HaveTheirPointsInOrderEachOnce) {
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);
    for (const CutLine& line : lines.all.lines) {
      ASSERT_GE(line.points.size(), 2u);
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        EXPECT_GT(along(line, lines.all.mesh.point[line.points[i]]),
                  along(line, lines.all.mesh.point[line.points[i - 1]]));
      }
    }
  }
}

/// Two planes that cut the fruit and have a point of a surface in common have a line, with this point on it; of a
/// stroke's facet only what lies in its stretch counts.
TEST(CutLines, HoldAllPointsThatSurfacesHaveOnTwoPlanes) {
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);
    std::size_t held = 0;
    for (std::uint32_t p = 0; p < lines.surface_points; ++p) {
      const std::vector<int>& on = lines.all.mesh.sets.planes_in(lines.all.mesh.planes_of[p]);
      for (std::size_t i = 0; i < on.size(); ++i) {
        for (std::size_t j = i + 1; j < on.size(); ++j) {
          if (!lines.is_used(on[i]) || !lines.is_used(on[j])) continue;
          const glm::dvec3& place = lines.all.mesh.point[p];
          if (!lines.planes.is_in_facet(on[i], place) || !lines.planes.is_in_facet(on[j], place)) continue;
          const auto line = std::find_if(lines.all.lines.begin(), lines.all.lines.end(), [&](const CutLine& l) {
            return std::count(l.planes.begin(), l.planes.end(), on[i]) +
                       std::count(l.planes.begin(), l.planes.end(), on[j]) ==
                   2;
          });
          ASSERT_NE(line, lines.all.lines.end());
          EXPECT_TRUE(has(line->points, p));
          ++held;
        }
      }
    }
    EXPECT_GT(held, 7u);
  }
}

/// By Cramer's rule, for every three planes without a common line; of strokes only where all three facets reach.
TEST(CutLines, OfThreePlanesHaveTheOnePointWhereTheyMeet) {
  int intersections = 0;
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);
    std::map<std::array<int, 3>, std::set<std::uint32_t>> met;
    const CutPlanes& planes = lines.planes;
    const double reach = 0.5 * glm::length(lines.bounds.size());
    for (const CutLine& line : lines.all.lines) {
      for (int k = 0; k < planes.count(); ++k) {
        if (std::count(line.planes.begin(), line.planes.end(), k) > 0 || !lines.is_used(k)) continue;

        // The point where the line meets one more plane, if it lies within the fruit.
        const CuttingPlane &p = planes[line.planes[0]].plane, &q = planes[line.planes[1]].plane, &r = planes[k].plane;
        const glm::dvec3 qr = glm::cross(q.normal, r.normal), rp = glm::cross(r.normal, p.normal),
                         pq = glm::cross(p.normal, q.normal);
        const double volume = glm::dot(p.normal, qr);
        if (std::fabs(volume) < 1e-6) continue;
        const glm::dvec3 place = (p.offset * qr + q.offset * rp + r.offset * pq) / volume;
        if (glm::distance(place, lines.bounds.center()) > 0.999 * reach) continue;
        const auto is_beside = [&](int plane) { return !planes.is_in_facet(plane, place); };
        if (is_beside(k) || std::any_of(line.planes.begin(), line.planes.end(), is_beside)) continue;

        // The line has one point there, which lies on that plane.
        std::vector<std::uint32_t> there;
        for (const std::uint32_t point : line.points) {
          if (glm::distance(lines.all.mesh.point[point], place) < 1e-12) there.push_back(point);
        }
        ASSERT_EQ(there.size(), 1u);
        EXPECT_TRUE(lines.is_on(there[0], k));
        ++intersections;

        // The other lines of these planes have the same point.
        std::array<int, 3> all{line.planes[0], line.planes[1], k};
        std::sort(all.begin(), all.end());
        met[all].insert(there[0]);
        EXPECT_EQ(met[all].size(), 1u);
      }
    }
  }
  EXPECT_GT(intersections, 80);
}

/// Dice along the axes meet in places with exactly the coordinates of their planes; wedges meet on the axis itself.
TEST(CutLines, SnapTheirPointsToTheAxes) {
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);
    for (const CutLine& line : lines.all.lines) {
      for (const std::uint32_t p : line.points) {
        if (p < lines.surface_points || line.points.front() == p || line.points.back() == p) continue;
        const std::vector<int>& on = lines.all.mesh.sets.planes_in(lines.all.mesh.planes_of[p]);
        EXPECT_EQ(lines.all.mesh.point[p], snapped_to_planes(lines.all.mesh.point[p], on, lines.planes));
      }
    }
  }
}

/// A line ends outside the fruit, or where a facet does.
TEST(CutLines, EndOutsideTheFruitOrWithTheirFacets) {
  int outside = 0, within = 0;
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);
    const double reach = 0.5 * glm::length(lines.bounds.size());
    for (const CutLine& line : lines.all.lines) {
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        const glm::dvec3& place = lines.all.mesh.point[line.points[i]];
        const bool is_end = (i == 0 && line.begins_outside()) || (i + 1 == line.points.size() && line.ends_outside());
        EXPECT_EQ(glm::distance(place, lines.bounds.center()) > reach, is_end);
        ++(is_end ? outside : within);
        EXPECT_GE(along(line, place), line.low - lines.planes.tolerance);
        EXPECT_LE(along(line, place), line.high + lines.planes.tolerance);
        for (const int k : line.planes) EXPECT_TRUE(lines.planes.is_in_facet(k, place));
      }
      EXPECT_EQ(line.leads_outside(1), line.begins_outside() || (line.points.size() == 2 && line.ends_outside()));
      EXPECT_EQ(line.leads_outside(line.points.size() - 1),
                line.ends_outside() || (line.points.size() == 2 && line.begins_outside()));
    }
  }
  EXPECT_GT(outside, 40);
  EXPECT_GT(within, 100);
}

/// Points that lines add to the mesh lie on them, and only on facets that reach there.
TEST(CutLines, AddNoPointForNothing) {
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);
    for (std::uint32_t p = static_cast<std::uint32_t>(lines.surface_points); p < lines.all.mesh.point.size(); ++p) {
      EXPECT_TRUE(std::any_of(lines.all.lines.begin(), lines.all.lines.end(),
                              [&](const CutLine& line) { return has(line.points, p); }));
      for (const int k : lines.all.mesh.sets.planes_in(lines.all.mesh.planes_of[p]))
        EXPECT_TRUE(lines.planes.is_in_facet(k, lines.all.mesh.point[p]));
    }
  }
}

TEST(CutLines, OfWedgesAreOneAxis) {
  for (const Lines& lines : lines_of_knives()) {
    if (lines.name != "wedges") continue;
    std::size_t of_wedges = 0;
    for (const CutLine& line : lines.all.lines) {
      if (line.planes.size() < 3) continue;
      ++of_wedges;
      EXPECT_THAT(line.planes, ElementsAre(0, 1, 2, 3, 4));
      for (const std::uint32_t p : line.points) {
        EXPECT_EQ(lines.all.mesh.point[p].x, 0);
        EXPECT_EQ(lines.all.mesh.point[p].z, 0);
      }
    }
    EXPECT_EQ(of_wedges, 1u);
    EXPECT_EQ(lines.all.lines.size(), 6u) << "the axis, and each wedge's plane with the level one";
  }
}

/// Planes that cut nothing, parallel ones, and those that meet beside the fruit have no lines.
TEST(CutLines, AreNoneWhereNothingMeetsWithinTheFruit) {
  const DiffusionSurfaces ball = shapes::tilted(shapes::sphere(0.05, 5, shapes::skin_paint()));
  for (const std::vector<Knife>& knives :
       {std::vector{parse_knife("slices:5")}, std::vector{parse_knife("half"), oblique({0, 1, 0}, 0.2)},
        std::vector{parse_knife("half"), oblique({0, 0.04, 1}, 0.04)}}) {
    EXPECT_THAT(Lines("none", ball, knives).all.lines, IsEmpty());
  }
}

/// The wanted length of edges: half as long on every other plane, and shorter towards one side.
double size_at(int plane, const glm::dvec3& place) {
  return (plane % 2 == 0 ? 0.006 : 0.003) + 0.02 * std::fabs(place.x);
}

TEST(CutLines, AreSubdividedAsFineAsTheFinestOfTheirPlanesWants) {
  std::size_t added = 0;
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);
    const CutLines fine = subdivided(lines.all, lines.planes, size_at);
    ASSERT_EQ(fine.lines.size(), lines.all.lines.size());
    for (std::size_t n = 0; n < fine.lines.size(); ++n) {
      const CutLine &line = fine.lines[n], &before = lines.all.lines[n];
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        const glm::dvec3 &a = fine.mesh.point[line.points[i - 1]], &b = fine.mesh.point[line.points[i]];
        double size = 1;
        for (const int k : line.planes) size = std::min(size, size_at(k, 0.5 * (a + b)));
        EXPECT_GT(along(line, b), along(line, a));
        if (line.leads_outside(i)) {
          EXPECT_TRUE(has(before.points, line.points[i - 1]) && has(before.points, line.points[i]));
          continue;
        }
        EXPECT_LE(glm::distance(a, b), 1.2 * size);

        // Not finer than needed: added points halve stretches that were too long.
        if (has(before.points, line.points[i - 1]) && has(before.points, line.points[i])) continue;
        EXPECT_GT(glm::distance(a, b), 0.5 * size);
      }

      // All earlier points are still there, in their order.
      std::vector<std::uint32_t> old;
      std::copy_if(line.points.begin(), line.points.end(), std::back_inserter(old),
                   [&](std::uint32_t p) { return p < lines.all.mesh.point.size(); });
      EXPECT_EQ(old, before.points);
      expect_on_planes(lines, line, fine);
      added += line.points.size() - before.points.size();
    }
  }
  EXPECT_GT(added, 300u);
}

TEST(CutLines, TakeMorePointsIntoTheirOrderEachOnce) {
  for (const Lines& lines : lines_of_knives()) {
    SCOPED_TRACE(lines.name);

    // Points between all points of a line, from the last to the first, some of them twice.
    CutLines before = lines.all;
    Unshared more;
    for (std::size_t n = 0; n < before.lines.size(); n += 2) {
      const CutLine& line = before.lines[n];
      for (std::size_t i = line.points.size() - 1; i > 0; --i) {
        const glm::dvec3 middle = 0.5 * (before.mesh.point[line.points[i]] + before.mesh.point[line.points[i - 1]]);
        const std::uint32_t p =
            before.mesh.add_point(middle, before.mesh.sets.with(0, i % 2 == 0 ? line.planes[0] : line.planes[1]));
        more[n].insert(more[n].end(), i % 2 == 0 ? 2 : 1, p);
      }
      more[n].push_back(line.points.front());
    }

    // Every other line has all of them.
    const CutLines after = with_points(before, more);
    for (std::size_t n = 0; n < after.lines.size(); ++n) {
      const CutLine& line = after.lines[n];
      const std::vector<std::uint32_t>& old = before.lines[n].points;
      EXPECT_EQ(line.points.size(), n % 2 == 0 ? 2 * old.size() - 1 : old.size());
      for (const std::uint32_t p : old) EXPECT_TRUE(has(line.points, p));
      for (const std::uint32_t p : more[n]) EXPECT_TRUE(has(line.points, p));
      for (std::size_t i = 1; i < line.points.size(); ++i)
        EXPECT_GT(along(line, after.mesh.point[line.points[i]]), along(line, after.mesh.point[line.points[i - 1]]));
      for (const std::uint32_t p : line.points) {
        for (const int k : line.planes) EXPECT_TRUE(after.mesh.sets.has(after.mesh.planes_of[p], k));
      }
    }
  }
}

TEST(CutLines, TellWhatLiesBetweenTwoOfTheirPoints) {
  CutLine line;
  line.points = {7, 3, 9, 4, 1};
  EXPECT_THAT(points_between(line, 7, 1), ElementsAre(3, 9, 4));
  EXPECT_THAT(points_between(line, 1, 7), ElementsAre(4, 9, 3));
  EXPECT_THAT(points_between(line, 3, 4), ElementsAre(9));
  EXPECT_THAT(points_between(line, 4, 9), IsEmpty());
  EXPECT_THAT(points_between(line, 9, 9), IsEmpty());
  EXPECT_THAT(points_between(line, 9, 5), IsEmpty()) << "5 does not lie on the line";
  EXPECT_THAT(points_between(line, 5, 9), IsEmpty());
}

TEST(CutLines, AreTheSameEveryTime) {
  const std::vector<Lines> first = lines_of_knives(), second = lines_of_knives();
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].all.mesh.point, second[i].all.mesh.point);
    for (std::size_t n = 0; n < first[i].all.lines.size(); ++n)
      EXPECT_EQ(first[i].all.lines[n].points, second[i].all.lines[n].points);
  }
}

}  // namespace
}  // namespace pomona
