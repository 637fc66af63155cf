// Cutting named shapes: what is cut adds up, closes, and is where geometry says.
#include "generator/cut/cut.h"

#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using shapes::signed_volume;

Cut cut_with(const DiffusionSurfaces& surfaces, const std::vector<std::string>& knives,
             const CutOptions& options = {}) {
  std::vector<Knife> parsed;
  for (const std::string& k : knives) parsed.push_back(parse_knife(k));
  return cut(surfaces, parsed, options);
}

double area_of(const CrossSection& section) {
  double sum = 0;
  for (const glm::uvec3& t : section.triangle) {
    const glm::dvec3 a(section.position[t.x]), b(section.position[t.y]), c(section.position[t.z]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

double volume_of(const Cut& cut) {
  double sum = 0;
  for (const CutPiece& piece : cut.pieces) sum += piece.volume;
  return sum;
}

/// Every directed edge of a piece, by position, is matched by an opposite one.
bool closes(const CutPiece& piece, const CrossSection& section) {
  using Place = std::tuple<float, float, float>;
  std::map<std::pair<Place, Place>, int> edges;
  const auto place = [](const glm::vec3& p) { return Place(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f); };
  const auto add = [&](const glm::vec3& a, const glm::vec3& b) {
    const Place p = place(a), q = place(b);
    if (p < q)
      ++edges[{p, q}];
    else
      --edges[{q, p}];
  };
  const auto add_triangle = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    add(a, b);
    add(b, c);
    add(c, a);
  };
  for (const glm::uvec3& t : piece.triangle)
    add_triangle(piece.position[t.x], piece.position[t.y], piece.position[t.z]);
  for (const CutPiece::CapTriangle& cap : piece.caps) {
    const glm::uvec3& t = section.triangle[cap.triangle];
    const auto& p = section.position;
    if (cap.reversed)
      add_triangle(p[t.x], p[t.z], p[t.y]);
    else
      add_triangle(p[t.x], p[t.y], p[t.z]);
  }
  for (const auto& [edge, balance] : edges) {
    if (balance != 0) return false;
  }
  return true;
}

void expect_sound(const Cut& cut, double whole) {
  EXPECT_NEAR(volume_of(cut), whole, 1e-6 * whole);
  for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
    EXPECT_TRUE(cut.pieces[i].closed) << "piece " << i;
    EXPECT_TRUE(closes(cut.pieces[i], cut.section)) << "piece " << i;
    EXPECT_GT(cut.pieces[i].volume, 0) << "piece " << i;
  }
}

TEST(Cut, WithoutKnifeIsTheWholeFruit) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 12, shapes::skin_paint());
  const Cut whole = cut_with(ball, {});
  ASSERT_EQ(whole.pieces.size(), 1u);
  EXPECT_TRUE(whole.section.triangle.empty());
  EXPECT_EQ(whole.pieces[0].triangle.size(), ball.triangle_count());
  expect_sound(whole, signed_volume(ball));
}

TEST(Cut, SphereByAPlane) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 24, shapes::skin_paint());
  const Cut cut = cut_with(ball, {"plane:0.2,0.5,1,0.01"});
  ASSERT_EQ(cut.pieces.size(), 2u);
  expect_sound(cut, signed_volume(ball));
  const double expected = pi * (0.05 * 0.05 - 0.01 * 0.01);
  EXPECT_NEAR(area_of(cut.section), expected, 0.01 * expected);
  EXPECT_TRUE(cut.warnings.empty());
}

TEST(Cut, SphereThroughItsVertices) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 8, shapes::skin_paint());
  for (const char* knife :
       {"half", "across", "plane:1,0,0,0", "plane:1,1,0,0", "plane:1,1,1,0", "wedges:2", "slices:4mm", "slices:8"}) {
    SCOPED_TRACE(knife);
    expect_sound(cut_with(ball, {knife}), signed_volume(ball));
  }
}

TEST(Cut, KnivesThatCross) {
  const DiffusionSurfaces ball = shapes::tilted(shapes::sphere(0.05, 8, shapes::skin_paint()));
  const std::vector<std::pair<std::vector<std::string>, std::size_t>> cases = {
      {{"half", "across"}, 4},
      {{"wedges:2"}, 2},
      {{"wedges:3"}, 3},
      {{"wedges:5"}, 5},
      {{"wedges:6"}, 6},
      {{"wedges:4", "slices:3"}, 12},
      {{"half", "wedges:6"}, 6},
      {{"half", "across", "plane:1,0,0,0"}, 8},
      {{"half", "across", "plane:1,2,3,0.013"}, 8},
  };
  for (const auto& [knives, count] : cases) {
    SCOPED_TRACE(::testing::PrintToString(knives));
    const Cut cut = cut_with(ball, knives);
    EXPECT_EQ(cut.pieces.size(), count);
    expect_sound(cut, signed_volume(ball));
  }
}

}  // namespace
}  // namespace pomona
