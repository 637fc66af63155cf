// Overlaps count once.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/compose/grow.h"
#include "generator/cut/cut.h"
#include "generator/cut/edge_balance.h"
#include "generator/cut/unite/united_bodies.h"
#include "generator/knife/parse_knife.h"
#include "generator/template/read/read_template.h"
#include "tests/cut/cut_checks.h"
#include "tests/cut/ray_volumes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using rays::ray_volumes;
using rays::RayVolumes;

rays::Point point(const glm::vec3& p) { return {double{p.x}, double{p.y}, double{p.z}}; }

rays::Triangle triangle(const std::vector<glm::vec3>& p, const glm::uvec3& t) {
  return {point(p[t.x]), point(p[t.y]), point(p[t.z])};
}

/// The triangles of the skin, facing air.
std::vector<rays::Triangle> skin_of(const DiffusionSurfaces& surfaces) {
  std::vector<rays::Triangle> all;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!surfaces.is_boundary(t)) continue;
    all.push_back(triangle(surfaces.position, surfaces.triangle[t]));
    if (surfaces.is_hidden(t, SideOf::back)) std::swap(all.back()[1], all.back()[2]);
  }
  return all;
}

std::vector<rays::Triangle> hull_of(const CutPiece& piece, const CrossSection& section) {
  std::vector<rays::Triangle> all;
  for (const glm::uvec3& t : piece.triangle) all.push_back(triangle(piece.position, t));
  for (const CutPiece::CapTriangle& cap : piece.caps) {
    all.push_back(triangle(section.position, section.triangle[cap.triangle]));
    if (cap.reversed) std::swap(all.back()[1], all.back()[2]);
  }
  return all;
}

std::vector<Knife> knives(std::initializer_list<const char*> texts) {
  std::vector<Knife> all;
  for (const char* text : texts) all.push_back(parse_knife(text));
  return all;
}

double area_of(const CrossSection& section, std::uint32_t triangle) {
  const std::vector<glm::vec3>& p = section.position;
  const glm::uvec3& t = section.triangle[triangle];
  return 0.5 * double{glm::length(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]))};
}

double area_of(const CrossSection& section) {
  double sum = 0;
  for (std::uint32_t t = 0; t < section.triangle.size(); ++t) sum += area_of(section, t);
  return sum;
}

/// The area of caps that lie where another does; slivers where rounding folds a skin do not count.
double doubled_area(const CutPiece& piece, const CrossSection& section) {
  std::set<std::uint32_t> seen;
  double sum = 0;
  for (const CutPiece::CapTriangle& cap : piece.caps)
    if (!seen.insert(cap.triangle).second) sum += area_of(section, cap.triangle);
  return sum;
}

double volume(const DiffusionSurfaces& surfaces, std::initializer_list<const char*> texts = {}) {
  const Cut cut = pomona::cut(surfaces, knives(texts));
  for (const CutPiece& piece : cut.pieces) EXPECT_TRUE(piece.closed);
  return shapes::volume_of(cut);
}

DiffusionSurfaces block(const glm::dvec3& low, const glm::dvec3& high, int n = 1) {
  return shapes::box(low, high, n, shapes::skin_paint());
}

std::size_t body_count(const UnitedBodies& united) {
  std::set<std::int32_t> all(united.bodies.of_triangle.begin(), united.bodies.of_triangle.end());
  all.erase(Bodies::none);
  return all.size();
}

/// Blocks with faces in one plane and edges on one line: nothing is in general position.
TEST(United, BlocksThatOverlapCountOnce) {
  const DiffusionSurfaces one = block({0, 0, 0}, {0.02, 0.02, 0.02}, 2);
  const auto with = [&](const glm::dvec3& low, const glm::dvec3& high) { return joined(one, block(low, high, 3)); };
  EXPECT_NEAR(volume(with({0.01, 0.01, 0.01}, {0.03, 0.03, 0.03})), 15e-6, 1e-11) << "corner in corner";
  EXPECT_NEAR(volume(with({0.01, 0, 0}, {0.03, 0.02, 0.02})), 12e-6, 1e-11) << "four faces in four faces";
  EXPECT_NEAR(volume(with({0.005, 0.01, 0.005}, {0.015, 0.04, 0.015})), 10e-6, 1e-11) << "a stalk";
  EXPECT_NEAR(volume(with({0.005, -0.01, 0.005}, {0.015, 0.03, 0.015})), 10e-6, 1e-11) << "a spit";
  EXPECT_NEAR(volume(with({0.005, 0.005, 0.005}, {0.015, 0.015, 0.015})), 8e-6, 1e-11) << "all of it within";
  EXPECT_NEAR(volume(with({0, 0, 0}, {0.01, 0.01, 0.01})), 8e-6, 1e-11) << "within, in a corner";
  EXPECT_NEAR(volume(with({0, 0, 0}, {0.02, 0.02, 0.02})), 8e-6, 1e-11) << "the same again";
}

TEST(United, ABlockInTwoThatTouch) {
  const DiffusionSurfaces two =
      joined(block({0, 0, 0}, {0.02, 0.02, 0.02}, 2), block({0.02, 0, 0}, {0.04, 0.02, 0.02}, 2));
  EXPECT_NEAR(volume(joined(two, block({0.013, 0.01, 0.005}, {0.026, 0.04, 0.015}, 3))), 18.6e-6, 1e-11);
  EXPECT_NEAR(volume(joined(two, block({0.01, 0.01, 0.005}, {0.03, 0.04, 0.015}, 4))), 20e-6, 1e-11)
      << "edges in faces";
}

TEST(United, BlocksThatOverlapAreCutAsOne) {
  const DiffusionSurfaces two =
      joined(block({0, 0, 0}, {0.02, 0.02, 0.02}, 2), block({0.01, 0.01, 0.01}, {0.03, 0.03, 0.03}, 3));
  for (const char* knife :
       {"plane:0,1,0,1.5cm", "plane:0,1,0,1cm", "plane:1,2,3,4cm", "slices:3mm", "wedges:5", "dice:6mm"})
    EXPECT_NEAR(volume(two, {knife}), 15e-6, 1e-11) << knife;
  const Cut cut = pomona::cut(two, knives({"plane:0,1,0,1.5cm"}));
  ASSERT_EQ(cut.pieces.size(), 2u);
  EXPECT_NEAR(area_of(cut.section), 7e-4, 1e-9);
  for (const CutPiece& piece : cut.pieces)
    EXPECT_EQ(piece.caps.size(), cut.section.triangle.size()) << "one cap a place";
}

TEST(United, WhatOnlyTouchesStaysApart) {
  const DiffusionSurfaces one = block({0, 0, 0}, {0.02, 0.02, 0.02}, 2);
  for (const DiffusionSurfaces& two : {joined(one, block({0.02, 0, 0}, {0.04, 0.02, 0.02}, 2)),
                                       joined(one, block({0.02, 0.005, 0.005}, {0.04, 0.01, 0.01})),
                                       joined(one, block({0.02, 0.02, 0}, {0.04, 0.04, 0.02}))}) {
    EXPECT_FALSE(united_bodies(two, find_bodies(two)));
  }
}

TEST(United, ThroughOneLargeTriangleAndThroughThreeBodies) {
  const DiffusionSurfaces large = block({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05});
  const DiffusionSurfaces ball = shapes::moved(shapes::sphere(0.01, 6, shapes::skin_paint()), {0.02, 0.05, 0.013});
  const DiffusionSurfaces two = joined(large, ball);
  const RayVolumes by_rays = ray_volumes(skin_of(two), 400);
  EXPECT_LT(by_rays.filled, 0.9995 * by_rays.counted);
  EXPECT_NEAR(volume(two) - 1e-3, shapes::signed_volume(ball) / 2, 2e-8);
  const DiffusionSurfaces three =
      joined(two, shapes::moved(shapes::sphere(0.008, 7, shapes::skin_paint()), {0.027, 0.05, 0.017}));
  for (const char* knife : {"plane:0,1,0,5cm", "plane:1,1,0,4.9cm", "plane:0,1,0,5.2cm"}) {
    const double whole = volume(three), cut = volume(three, {knife});
    EXPECT_NEAR(whole, cut, 1e-6 * whole);
  }
  const RayVolumes of_three = ray_volumes(skin_of(three), 400);
  const std::optional<UnitedBodies> united = united_bodies(three, find_bodies(three));
  ASSERT_TRUE(united);
  EXPECT_EQ(body_count(*united), 1u);
  EXPECT_NEAR(ray_volumes(skin_of(united->surfaces), 400).counted, of_three.filled, 1e-6 * of_three.filled);
}

TEST(United, InAHollowIsAlone) {
  const DiffusionSurfaces hollow = shapes::hollow_ball(0.05, 0.04, 8);
  const DiffusionSurfaces seed = shapes::sphere(0.01, 4, shapes::skin_paint());
  const DiffusionSurfaces loose = joined(hollow, shapes::moved(seed, {0.01, 0, 0}));
  EXPECT_FALSE(united_bodies(loose, find_bodies(loose)));
  const DiffusionSurfaces grown_on = joined(hollow, shapes::moved(seed, {0.035, 0, 0}));
  const std::optional<UnitedBodies> united = united_bodies(grown_on, find_bodies(grown_on));
  ASSERT_TRUE(united);
  EXPECT_EQ(body_count(*united), 1u);
  EXPECT_EQ(united_bodies(united->surfaces, united->bodies).has_value(), false) << "there is nothing left to unite";
}

TEST(United, OpenBodiesStayAsTheyAre) {
  DiffusionSurfaces open = shapes::sphere(0.02, 4, shapes::skin_paint());
  open.triangle.pop_back(), open.surface.pop_back(), open.front_part.pop_back(), open.back_part.pop_back();
  const DiffusionSurfaces two =
      joined(open, shapes::moved(shapes::sphere(0.02, 4, shapes::skin_paint()), {0.01, 0, 0}));
  EXPECT_FALSE(united_bodies(two, find_bodies(two)));
}

TEST(United, ABodyThatStaysApartEndsAtTheOthers) {
  const DiffusionSurfaces two =
      joined(block({0, 0, 0}, {0.02, 0.02, 0.02}, 2), block({0.005, 0.01, 0.005}, {0.015, 0.04, 0.015}, 3));
  const Bodies bodies = find_bodies(two);
  const std::vector<std::int32_t> apart{1};
  const std::optional<UnitedBodies> united = united_bodies(two, bodies, {.apart = apart});
  ASSERT_TRUE(united);
  EXPECT_EQ(body_count(*united), 2u);
  for (const std::int32_t body : {0, 1}) {
    EdgeBalance edges;
    double six = 0;
    for (std::size_t t = 0; t < united->surfaces.triangle_count(); ++t) {
      if (united->bodies.of_triangle[t] != body) continue;
      const std::vector<glm::vec3>& p = united->surfaces.position;
      glm::uvec3 c = united->surfaces.triangle[t];
      if (united->surfaces.is_hidden(t, SideOf::back)) std::swap(c.y, c.z);
      const bool is_line = p[c.x] == p[c.y] || p[c.y] == p[c.z] || p[c.z] == p[c.x];
      if (!is_line) edges.add(p[c.x], p[c.y], p[c.z]);
      six += glm::dot(glm::dvec3(p[c.x]), glm::cross(glm::dvec3(p[c.y]), glm::dvec3(p[c.z])));
    }
    EXPECT_TRUE(edges.closed());
    EXPECT_NEAR(six / 6, body == 0 ? 8e-6 : 2e-6, 1e-11);
  }
}

TEST(United, DoesNotDependOnThreads) {
  const DiffusionSurfaces rings = shapes::fruits_to_cut().back();
  shapes::expect_same(cut(rings, knives({"half"}), {.threads = {1}}), cut(rings, knives({"half"}), {.threads = {7}}));
}

// ---- The program's templates ----

class UnitedTemplates : public testing::TestWithParam<std::string> {};

/// Whole and in slices, volumes are those of rays through the grown bodies, to a thousandth.
TEST_P(UnitedTemplates, WeighWhatTheyFill) {
  const Template fruit = read_template(std::string(POMONA_SOURCE_DIR) + "/templates/" + GetParam() + ".toml");
  const DiffusionSurfaces surfaces = grow(fruit, {0, 0}, {.as_drawn = true, .detail = 0.5}).sheets;
  const RayVolumes grown = ray_volumes(skin_of(surfaces), 500);
  const Cut whole = cut(surfaces, {});
  std::vector<rays::Triangle> all;
  for (const CutPiece& piece : whole.pieces) {
    const std::vector<rays::Triangle> hull = hull_of(piece, whole.section);
    all.insert(all.end(), hull.begin(), hull.end());
    EXPECT_TRUE(piece.closed);
  }
  EXPECT_NEAR(ray_volumes(all, 500).filled, grown.filled, 1e-4 * grown.filled) << "the same place is filled";
  EXPECT_NEAR(shapes::volume_of(whole), grown.filled, 1e-3 * grown.filled);

  const Box<double> box = bounds_of(surfaces);
  const std::string slices = "slices:" + std::to_string(box.size().y * 1000 / 12) + "mm";
  for (const std::string& knife : {slices, std::string("wedges:5")}) {
    const Cut sliced = cut(surfaces, knives({knife.c_str()}));
    EXPECT_NEAR(shapes::volume_of(sliced), shapes::volume_of(whole), 1e-6 * shapes::volume_of(whole));
    for (std::size_t i = 0; i < sliced.pieces.size(); ++i) {
      const CutPiece& piece = sliced.pieces[i];
      const RayVolumes by_rays = ray_volumes(hull_of(piece, sliced.section), 200);
      EXPECT_TRUE(piece.closed);
      EXPECT_NEAR(by_rays.counted, by_rays.filled, 1e-3 * by_rays.filled) << knife << ": piece " << i + 1;
      EXPECT_LT(doubled_area(piece, sliced.section), 1e-5 * area_of(sliced.section)) << knife << ": piece " << i + 1;
      if (piece.volume < 1e-3 * grown.filled) continue;
      // Few rays through a thin leaf pass its rim; more of them tell.
      const bool is_near = std::fabs(piece.volume - by_rays.filled) < 2e-3 * by_rays.filled;
      const double filled = is_near ? by_rays.filled : ray_volumes(hull_of(piece, sliced.section), 1000).filled;
      EXPECT_NEAR(piece.volume, filled, 2e-3 * filled) << knife << ": piece " << i + 1;
    }
  }
}

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(POMONA_SOURCE_DIR) + "/templates"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Shipped, UnitedTemplates, testing::ValuesIn(template_names()),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace pomona
