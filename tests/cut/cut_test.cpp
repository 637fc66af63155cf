// Cuts of named shapes: pieces add up, are closed, and lie where geometry says.
#include "generator/cut/cut.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/units.h"
#include "generator/knife/parse_knife.h"
#include "tests/cut/cut_checks.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using shapes::expect_same;
using shapes::volume_of;

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

/// True if every directed edge of a piece has an opposite one, by position.
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

TEST(Cut, HollowStaysHollow) {
  const DiffusionSurfaces ball = shapes::hollow_ball(0.05, 0.03, 12);
  const double solid = signed_volume(shapes::sphere(0.05, 12)) - signed_volume(shapes::sphere(0.03, 12));
  const Cut whole = cut_with(ball, {});
  ASSERT_EQ(whole.pieces.size(), 1u);
  expect_sound(whole, solid);

  const Cut halves = cut_with(ball, {"half"});
  ASSERT_EQ(halves.pieces.size(), 2u);
  expect_sound(halves, solid);
  const double ring = pi * (0.05 * 0.05 - 0.03 * 0.03);
  EXPECT_NEAR(area_of(halves.section), ring, 0.02 * ring);
  for (const glm::vec3& p : halves.section.position) EXPECT_GT(glm::length(p), 0.0295f);

  // A slice off the side leaves the cavity whole, inside the larger piece.
  const Cut cheek = cut_with(ball, {"plane:0,0,1,0.04"});
  ASSERT_EQ(cheek.pieces.size(), 2u);
  expect_sound(cheek, solid);
}

TEST(Cut, OverlappingBodiesAreOnePieceAndCountOnce) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 10, shapes::skin_paint());
  const DiffusionSurfaces both = joined(ball, shapes::moved(ball, {0.06, 0, 0}));
  // Two balls with a lens between.
  const double lens = pi * 0.02 * 0.02 / 3 * (3 * 0.05 - 0.02) * 2;
  const double each = signed_volume(ball), together = shapes::volume_of(cut_with(both, {}));
  EXPECT_NEAR(2 * each - together, lens, 0.05 * lens);
  for (const char* knife : {"half", "across", "plane:0.3,1,0.2,0.001", "plane:1,0,0,0.03"}) {
    SCOPED_TRACE(knife);
    const Cut cut = cut_with(both, {knife});
    EXPECT_EQ(cut.pieces.size(), 2u);
    expect_sound(cut, together);
  }
  EXPECT_EQ(cut_with(both, {}).pieces.size(), 1u);
  const DiffusionSurfaces apart = joined(ball, shapes::moved(ball, {0.2, 0, 0}));
  EXPECT_EQ(cut_with(apart, {"half"}).pieces.size(), 4u);
}

TEST(Cut, SameBytesTwice) {
  const DiffusionSurfaces ball = shapes::tilted(shapes::nested_spheres(0.05, 0.02, 10));
  const Cut first = cut_with(ball, {"half", "wedges:5"}), second = cut_with(ball, {"half", "wedges:5"});
  expect_same(first, second);
}

TEST(Cut, SameBytesOnAnyNumberOfThreads) {
  const DiffusionSurfaces ball = shapes::tilted(shapes::nested_spheres(0.05, 0.02, 10));
  CutOptions one, two;
  one.threads.count = 1;
  two.threads.count = 2;
  for (const std::vector<std::string>& knives :
       {std::vector<std::string>{"half"}, {"wedges:5", "across"}, {"slices:7"}}) {
    SCOPED_TRACE(::testing::PrintToString(knives));
    const Cut first = cut_with(ball, knives, one), second = cut_with(ball, knives, two);
    expect_same(first, second);
  }
}

TEST(Cut, HasVerticesWhereColoursDiffer) {
  const auto interior_vertices = [](const Color& core) {
    const shapes::Paint paint{.front = core, .back = core};
    const DiffusionSurfaces ball = shapes::nested_spheres(0.05, 0.02, 10, shapes::skin_paint(), paint);
    const Cut cut = cut_with(ball, {"plane:0.1,0.2,1,0.003"}, {.coarsest = 0.3});
    expect_sound(cut, signed_volume(shapes::sphere(0.05, 10)));
    return std::count(cut.section.interior.begin(), cut.section.interior.end(), 1);
  };
  const Color flesh = shapes::skin_paint().back;
  const auto like = interior_vertices(flesh), unlike = interior_vertices(Color(0));
  EXPECT_GT(unlike, like);
}

/// A face of three corners begins as a single triangle: it gets vertices everywhere, whichever side it faces.
TEST(Cut, AFaceOfThreeCornersIsAsFineFromEitherSide) {
  const DiffusionSurfaces fruit =
      shapes::painted({{0.03f, 0, 0}, {-0.02f, 0, 0.03f}, {-0.02f, 0, -0.03f}, {0, 0.06f, 0}},
                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, shapes::skin_paint());
  for (const char* knife : {"plane:0,1,0,0.011", "plane:0,-1,0,-0.011"}) {
    const CrossSection section = cut_with(fruit, {knife}).section;
    EXPECT_EQ(std::count(section.interior.begin(), section.interior.end(), 0), 6) << "three corners, three middles";
    EXPECT_GT(std::count(section.interior.begin(), section.interior.end(), 1), 100) << knife;
  }
}

TEST(Cut, InnerSurfacesGiveBothTheirColours) {
  const shapes::Paint core{.front = {1, 0, 0}, .back = {0, 0, 1}};
  const DiffusionSurfaces ball = shapes::nested_spheres(0.05, 0.02, 10, shapes::skin_paint(), core);
  const Cut cut = cut_with(ball, {"plane:0.1,0.2,1,0.003"});
  expect_sound(cut, signed_volume(shapes::sphere(0.05, 10)));
  int red = 0, blue = 0;
  for (std::size_t v = 0; v < cut.section.position.size(); ++v) {
    const float r = glm::length(cut.section.position[v]);
    if (cut.section.interior[v] || r > 0.03f) continue;
    red += cut.section.color[v] == Color(1, 0, 0);
    blue += cut.section.color[v] == Color(0, 0, 1);
  }
  EXPECT_GT(red, 10);
  EXPECT_EQ(red, blue);
}

/// The triangles for whose middle `keep` is true.
template <typename Keep>
DiffusionSurfaces part_of(DiffusionSurfaces surfaces, const Keep& keep) {
  DiffusionSurfaces part = surfaces;
  part.triangle.clear();
  part.surface.clear();
  part.front_part.clear();
  part.back_part.clear();
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    const glm::uvec3& c = surfaces.triangle[t];
    if (!keep((surfaces.position[c.x] + surfaces.position[c.y] + surfaces.position[c.z]) / 3.0f)) continue;
    part.triangle.push_back(c);
    part.surface.push_back(surfaces.surface[t]);
    part.front_part.push_back(surfaces.front_part[t]);
    part.back_part.push_back(surfaces.back_part[t]);
  }
  return part;
}

TEST(Cut, OpenSkinIsCutOpenWithAWarning) {
  const auto below = [](const glm::vec3& p) { return p.y < 0.03f; };
  const DiffusionSurfaces bowl = part_of(shapes::sphere(0.05, 10, shapes::skin_paint()), below);

  // The knife passes through the hole: nothing is enclosed there.
  const Cut through_hole = cut_with(bowl, {"half"});
  EXPECT_FALSE(through_hole.warnings.empty());
  EXPECT_TRUE(through_hole.section.triangle.empty());
  EXPECT_EQ(through_hole.pieces.size(), 2u);

  // It passes below: the chain closes, and so does the lower piece.
  const Cut below_hole = cut_with(bowl, {"plane:0,1,0,0"});
  EXPECT_FALSE(below_hole.warnings.empty());
  ASSERT_EQ(below_hole.pieces.size(), 2u);
  EXPECT_TRUE(below_hole.pieces[0].closed);
  EXPECT_FALSE(below_hole.pieces[1].closed);
  EXPECT_NEAR(area_of(below_hole.section), pi * 0.05 * 0.05, 0.01 * pi * 0.05 * 0.05);
}

TEST(Cut, InnerSheetsMayEndAnywhere) {
  shapes::Paint paint{.front = {1, 0, 0}, .back = {0, 0, 1}};
  const DiffusionSurfaces skin = shapes::sphere(0.05, 8, shapes::skin_paint());
  const DiffusionSurfaces fruit = joined(skin, shapes::open_sheet(0.05, 0.001, 4, paint));
  const Cut cut = cut_with(fruit, {"half"});
  expect_sound(cut, signed_volume(skin));

  // Both ends of the chain are one vertex each, with the mean colour; between them are as many red as blue ones.
  int red = 0, blue = 0, mean = 0;
  for (std::size_t v = 0; v < cut.section.position.size(); ++v) {
    if (cut.section.interior[v]) continue;
    red += cut.section.color[v] == Color(1, 0, 0);
    blue += cut.section.color[v] == Color(0, 0, 1);
    mean += cut.section.color[v] == Color(0.5f, 0, 0.5f);
  }
  EXPECT_GT(red, 2);
  EXPECT_EQ(red, blue);
  EXPECT_EQ(mean, 2);
}

TEST(Cut, AKnifeThatMissesOnlyWarns) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 6, shapes::skin_paint());
  const Cut cut = cut_with(ball, {"plane:0,1,0,2"});
  ASSERT_EQ(cut.warnings.size(), 1u);
  EXPECT_THAT(cut.warnings[0], testing::HasSubstr("misses"));
  EXPECT_EQ(cut.pieces.size(), 1u);
}

TEST(Cut, FacesThatMeetShareTheirLine) {
  const DiffusionSurfaces fruit = shapes::tilted(shapes::nested_spheres(0.05, 0.02, 8));
  const Cut cut = cut_with(fruit, {"half", "across"});
  std::map<std::tuple<float, float>, std::set<int>> faces_at;  // by x along the line
  for (std::size_t t = 0; t < cut.section.triangle.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const glm::vec3& p = cut.section.position[cut.section.triangle[t][i]];
      const bool on_both = p.z == 0 && p.y == static_cast<float>(bounds_of(fruit).center().y);
      if (on_both) faces_at[{p.x, p.y}].insert(cut.section.cut[t]);
    }
  }
  EXPECT_GT(faces_at.size(), 10u);
  for (const auto& [place, faces] : faces_at) EXPECT_EQ(faces.size(), 2u) << std::get<0>(place);
}

TEST(Cut, RandomKnivesOnManyShapes) {
  std::vector<DiffusionSurfaces> fruits = {
      shapes::sphere(0.05, 5, shapes::skin_paint()),
      shapes::torus(0.04, 0.015, 16, 9),
      shapes::box({-0.03, 0, -0.02}, {0.03, 0.05, 0.04}, 3, shapes::skin_paint()),
      joined(shapes::nested_spheres(0.05, 0.02, 5), shapes::open_sheet(0.07, 0.003, 3)),
      shapes::hollow_ball(0.05, 0.044, 5),
      joined(shapes::torus(0.04, 0.015, 16, 9), shapes::moved(shapes::torus(0.04, 0.015, 16, 9), {0.013, 0.007, 0})),
  };
  const RandomStream random({7, 0}, "test/knives");
  std::uint64_t draw = 0;
  const auto coarse = [&] { return static_cast<double>(random.below(draw++, 5)) - 2; };
  for (std::size_t f = 0; f < fruits.size(); ++f) {
    const double whole = volume_of(cut_with(fruits[f], {}));
    for (int i = 0; i < 25; ++i) {
      // Two planes: small whole numbers give planes through vertices, edges and each other's lines.
      std::vector<Knife> knives;
      std::string text;
      for (int k = 0; k < 2; ++k) {
        const bool generic = random.below(draw++, 2) == 0;
        glm::dvec3 n(coarse(), coarse(), coarse());
        double d = 0.01 * coarse();
        if (generic) n += glm::dvec3(random.uniform(draw), random.uniform(draw + 1), random.uniform(draw + 2));
        if (generic) d += 0.01 * random.uniform(draw + 3);
        draw += 4;
        if (glm::length(n) < 0.1) n = {0, 1, 0};
        knives.push_back({PlaneCut(PlaneKnife{{glm::normalize(n), d}})});
        for (int axis = 0; axis < 3; ++axis) text += std::to_string(n[axis]) + ",";
        text += std::to_string(d) + " ";
      }
      SCOPED_TRACE("fruit " + std::to_string(f) + " " + text);
      const Cut cut = pomona::cut(fruits[f], knives, {.coarsest = 0.2, .finest = 0.05});
      EXPECT_NEAR(volume_of(cut), whole, 1e-6 * whole);
      for (const CutPiece& piece : cut.pieces) EXPECT_TRUE(piece.closed && closes(piece, cut.section));
      if (HasFailure()) return;
    }
  }
}

TEST(Cut, BoxThroughVerticesEdgesAndFaces) {
  const DiffusionSurfaces box = shapes::box({0, 0, 0}, {2, 2, 2}, 2, shapes::skin_paint());
  int number = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        for (int d = -2; d <= 4; ++d) {
          const double length = std::sqrt(x * x + y * y + z * z);
          const Knife knife{PlaneCut(PlaneKnife{{glm::dvec3(x, y, z) / length, d / length}})};
          const Cut cut = pomona::cut(box, std::vector<Knife>{knife}, {.coarsest = 0.2, .finest = 0.05});
          SCOPED_TRACE(::testing::PrintToString(std::vector<int>{x, y, z, d}));
          expect_sound(cut, 8);
          EXPECT_LE(cut.pieces.size(), 2u);
          ++number;
        }
      }
    }
  }
  EXPECT_EQ(number, 26 * 7);
}

// An edge on the axis is cut by each half-plane that separates its triangles, and by no other.
TEST(Cut, WedgesWhoseAxisLiesInTheSkin) {
  for (const glm::dvec3& low : {glm::dvec3(0), glm::dvec3(-0.02, 0, 0), glm::dvec3(-0.01, 0, -0.02)}) {
    const DiffusionSurfaces box = shapes::box(low, {0.02, 0.02, 0.02}, 2, shapes::skin_paint());
    for (const char* knife : {"wedges:3", "wedges:4", "wedges:5", "wedges:6", "wedges:7", "wedges:12"}) {
      SCOPED_TRACE(std::to_string(low.x) + ", " + knife);
      shapes::expect_whole(cut_with(box, {knife}), signed_volume(box));
    }
  }
}

/// The shape and its mirror image across one axis, as one surface; triangles in the mirror are there twice.
DiffusionSurfaces with_mirror_image(const DiffusionSurfaces& one, int axis) {
  DiffusionSurfaces image = one;
  for (glm::vec3& p : image.position) p[axis] = -p[axis];
  for (glm::uvec3& t : image.triangle) std::swap(t.y, t.z);
  DiffusionSurfaces both = joined(one, image);
  both.surface.assign(both.triangle_count(), 0);
  return both;
}

// Voxels, tetrahedra and parts of an assembly share faces, triangle by triangle.
TEST(Cut, SolidsOfOneSurfaceThatTouchAreEachCut) {
  DiffusionSurfaces touching = shapes::box({0, 0, 0}, {0.02, 0.02, 0.02}, 2, shapes::skin_paint());
  double volume = 8e-6;
  for (int axis = 0; axis < 3; ++axis) {
    touching = with_mirror_image(touching, axis);
    volume *= 2;
    for (const char* knife :
         {"plane:0,1,0,0.007", "plane:1,0,0,0.004", "plane:1,1,0,0.003", "plane:1,0,0,0", "plane:1,2,3,0.001",
          "wedges:5", "slices:4mm", "dice:7mm", "sticks:8mm", "crinkle:5mm", "half", "ball:12mm", "core:9mm"}) {
      SCOPED_TRACE(std::to_string(axis) + ", " + knife);
      const Cut cut = cut_with(touching, {knife}, {.coarsest = 0.02, .finest = 0.01});
      shapes::expect_whole(cut, volume);
      EXPECT_FALSE(cut.section.triangle.empty() && std::string(knife) != "plane:1,0,0,0" &&
                   std::string(knife) != "half");
      for (const CutPiece& piece : cut.pieces) EXPECT_GT(piece.volume, 0);
    }
  }
}

// A knife that meets surfaces but leaves no face has not missed them.
TEST(Cut, SaysWhyAKnifeLeavesNoFace) {
  const auto warnings_of = [](const char* knife) {
    return cut(shapes::sphere(0.05, 4, shapes::Paint{}), std::vector{parse_knife(knife)}).warnings;
  };
  EXPECT_THAT(warnings_of("plane:1,0,0,0.01"), testing::Contains(testing::HasSubstr("leaves no cut face")));
  EXPECT_THAT(warnings_of("plane:1,0,0,0.2"), testing::Contains(testing::HasSubstr("cuts nothing: it misses")));
}

}  // namespace
}  // namespace pomona
