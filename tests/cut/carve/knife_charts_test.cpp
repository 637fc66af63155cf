#include "generator/cut/carve/knife_charts.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/knife/knife_mesh.h"
#include "tests/cut/carve/carving_stages.h"
#include "tests/cut/solid_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using shapes::CarvingStages;

/// A knife's face as it is before charts, and which of its triangles are section.
struct Uncharted {
  Face face;
  Regions regions;
};

/// A knife without a fruit; `is_section` says by a triangle's middle whether it is section.
template <typename IsSection>
Uncharted uncharted(const ClosedSurface& solid, const IsSection& is_section) {
  const KnifeMesh mesh = knife_mesh(solid, "knife");
  Uncharted all;
  all.face.place = mesh.point;
  all.regions.patch.resize(2);
  all.regions.patch[1].closes.push_back({{1, 0}, {{0, 1}}});
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const KnifeMesh::Triangle& own = mesh.triangle[t];
    all.face.triangle.emplace_back(own.corner[0], own.corner[1], own.corner[2]);
    all.face.normal.push_back({glm::vec3(own.normal[0]), glm::vec3(own.normal[1]), glm::vec3(own.normal[2])});
    all.face.facet.push_back(own.face);
    const Corners corners = mesh.corners(t);
    all.regions.patch_of.push_back(is_section((corners[0] + corners[1] + corners[2]) / 3.0) ? 1 : 0);
  }
  return all;
}

Uncharted uncharted(const ClosedSurface& solid) {
  return uncharted(solid, [](const glm::dvec3&) { return true; });
}

ClosedSurface ring() {
  const DiffusionSurfaces torus = shapes::torus(0.04, 0.015, 24, 12);
  ClosedSurface solid;
  for (const glm::vec3& p : torus.position) solid.point.emplace_back(p);
  solid.triangle = torus.triangle;
  return solid;
}

/// Knives without a fruit, whole and halved by a plane, and those of all carvings.
std::vector<Uncharted> uncharted_faces() {
  std::vector<Uncharted> all;
  for (const ClosedSurface& solid :
       {shapes::ball({0, 0, 0}, 0.02, 5), shapes::rod({0, 0, 0}, 0.01, 0.1, 16), shapes::tilted(ring()),
        shapes::tilted(shapes::rod({0, 0, 0}, 0.01, 0.1, 7)), shapes::block({0, 0, 0}, {1, 2, 3})}) {
    all.push_back(uncharted(solid));
    all.push_back(uncharted(solid, [](const glm::dvec3& p) { return p.x + 0.3 * p.y - 0.2 * p.z > 0.001; }));
  }
  for (const shapes::CarvingCase& of : shapes::carving_cases()) {
    CarvingStages stages(of);
    Regions regions = stages.regions();
    all.push_back({std::move(stages.face), std::move(regions)});
  }
  return all;
}

Corners corners_of(const Face& face, std::size_t triangle) {
  const glm::uvec3& t = face.triangle[triangle];
  return {face.place[t.x], face.place[t.y], face.place[t.z]};
}

glm::dvec3 area_of(const Face& face, std::size_t triangle) { return shapes::area_of(corners_of(face, triangle)); }

/// The triangles of the section in each chart.
std::vector<std::vector<std::size_t>> charts_of(const Face& face, const Regions& regions) {
  std::vector<std::vector<std::size_t>> charts(face.frame.size());
  for (std::size_t t = 0; t < face.triangle.size(); ++t) {
    if (regions.is_section(t)) charts.at(face.facet[t]).push_back(t);
  }
  return charts;
}

TEST(KnifeCharts, TurnNoTriangleAway) {
  for (const Uncharted& before : uncharted_faces()) {
    const Face face = charted(before.face, before.regions, 3);
    std::size_t section = 0;
    for (std::size_t t = 0; t < face.triangle.size(); ++t) {
      if (!before.regions.is_section(t)) continue;
      ++section;
      ASSERT_LT(face.facet[t], face.frame.size());
      if (shapes::is_collapsed(corners_of(face, t))) continue;
      EXPECT_GT(glm::dot(area_of(face, t), face.frame[face.facet[t]].normal), 0);
    }
    EXPECT_GT(section, 0u);
  }
}

TEST(KnifeCharts, AreOfOneSmoothFaceEachAndNeverEmpty) {
  for (const Uncharted& before : uncharted_faces()) {
    const Face face = charted(before.face, before.regions, 3);
    for (const std::vector<std::size_t>& chart : charts_of(face, before.regions)) {
      ASSERT_FALSE(chart.empty());
      for (const std::size_t t : chart) EXPECT_EQ(before.face.facet[t], before.face.facet[chart.front()]);
    }
  }
}

/// The frame is right-handed and passes through the mean place of the chart's area.
TEST(KnifeCharts, HaveFramesThroughTheirMiddles) {
  for (const Uncharted& before : uncharted_faces()) {
    const Face face = charted(before.face, before.regions, 3);
    const std::vector<std::vector<std::size_t>> charts = charts_of(face, before.regions);
    for (std::size_t c = 0; c < charts.size(); ++c) {
      const CutFace& frame = face.frame[c];
      EXPECT_EQ(frame.knife, 3);
      EXPECT_LT(glm::distance(glm::cross(frame.u, frame.v), frame.normal), 1e-12);
      EXPECT_NEAR(glm::dot(frame.u, frame.v), 0, 1e-12);
      EXPECT_NEAR(glm::length(frame.u), 1, 1e-12);
      double height = 0, area = 0;
      for (const std::size_t t : charts[c]) {
        const glm::uvec3& v = face.triangle[t];
        const double own = glm::length(area_of(face, t));
        for (int i = 0; i < 3; ++i) height += own / 3 * glm::dot(frame.normal, face.place[v[i]] - frame.origin);
        area += own;
      }
      EXPECT_LE(std::abs(height), 1e-12 * area);
    }
  }
}

TEST(KnifeCharts, OfABowlIsOneThatLooksOutOfIt) {
  // Less than half of a ball, seen from below.
  const Uncharted bowl =
      uncharted(shapes::ball({0.01, 0.02, 0.03}, 0.02, 8), [](const glm::dvec3& p) { return p.y < 0.015; });
  const Face face = charted(bowl.face, bowl.regions, 0);
  ASSERT_EQ(face.frame.size(), 1u);
  EXPECT_LT(glm::distance(face.frame[0].normal, glm::dvec3(0, -1, 0)), 1e-6);
  EXPECT_TRUE(face.frame[0].curved);
}

TEST(KnifeCharts, OfATubeAreTwoHalvesFrontAndBack) {
  const Uncharted tube = uncharted(shapes::rod({0.003, -0.1, 0.002}, 0.012, 0.2, 13),
                                   [](const glm::dvec3& p) { return std::abs(p.y) < 0.099; });
  const Face face = charted(tube.face, tube.regions, 0);
  ASSERT_EQ(face.frame.size(), 2u);
  EXPECT_LT(glm::distance(face.frame[0].normal, -face.frame[1].normal), 1e-12);
  EXPECT_EQ(face.frame[0].normal.y, 0) << "along the axis nothing of it can be seen";
  EXPECT_TRUE(face.frame[0].curved && face.frame[1].curved);
  const std::vector<std::vector<std::size_t>> charts = charts_of(face, tube.regions);
  EXPECT_NEAR(static_cast<double>(charts[0].size()), static_cast<double>(charts[1].size()), 2);
}

TEST(KnifeCharts, OfAWholeBallAreTwoHalves) {
  const Uncharted ball = uncharted(shapes::tilted(shapes::ball({0, 0, 0}, 0.02, 6)));
  EXPECT_EQ(charted(ball.face, ball.regions, 0).frame.size(), 2u);
}

TEST(KnifeCharts, OfABlockAreItsSixFlatFaces) {
  const glm::dvec3 low(-0.01, 0.02, 0.01), high(0.02, 0.03, 0.05);
  const Uncharted block = uncharted(shapes::block(low, high));
  const Face face = charted(block.face, block.regions, 0);
  ASSERT_EQ(face.frame.size(), 6u);
  std::set<std::pair<int, double>> seen;
  for (const CutFace& frame : face.frame) {
    EXPECT_FALSE(frame.curved);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(frame.normal[axis]) < 0.5) continue;
      EXPECT_NEAR(std::abs(frame.normal[axis]), 1, 1e-12);
      const bool is_high = frame.normal[axis] > 0;
      EXPECT_NEAR(frame.origin[axis], is_high ? high[axis] : low[axis], 1e-12);
      seen.insert({axis, is_high ? 1 : -1});
    }
  }
  EXPECT_EQ(seen.size(), 6u);

  // In a turned block normals are rounded, and faces as flat as before.
  const Uncharted turned = uncharted(shapes::tilted(shapes::block(low, high)));
  const Face turned_face = charted(turned.face, turned.regions, 0);
  EXPECT_EQ(turned_face.frame.size(), 6u);
  for (const CutFace& frame : turned_face.frame) EXPECT_FALSE(frame.curved);
}

TEST(KnifeCharts, LeaveTheTrianglesAsTheyAre) {
  for (const Uncharted& before : uncharted_faces()) {
    const Face face = charted(before.face, before.regions, 0);
    EXPECT_EQ(face.triangle, before.face.triangle);
    EXPECT_EQ(face.place, before.face.place);
    EXPECT_EQ(face.normal, before.face.normal);
    EXPECT_EQ(face.neighbor, before.face.neighbor);
  }
}

TEST(KnifeCharts, OfWhatIsNoSectionIsAFrameAllTheSame) {
  const Uncharted air = uncharted(shapes::ball({0, 0, 0}, 0.02, 3), [](const glm::dvec3&) { return false; });
  EXPECT_EQ(charted(air.face, air.regions, 0).frame.size(), 1u);
}

}  // namespace
}  // namespace pomona
