// Guides of texture detail on cut faces.
#include "generator/piece/guided.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/cut/cut.h"
#include "generator/cut/section/guide_lattice.h"
#include "generator/knife/knife.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/solid.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

constexpr double radius = 0.03;

Template detailed_fruit() {
  Template fruit;
  fruit.parts = {"skin", "flesh"};
  DetailSketch rays;
  rays.run = DetailRun::to_skin;
  rays.parts = {1};
  rays.amount = 0.5;
  rays.depth = Ramp<double>{{{0.0, 0.0}, {0.01, 1.0}}};
  DetailSketch veins = rays;
  veins.run = DetailRun::along;
  veins.depth = Ramp<double>::constant(0.5);
  DetailSketch dots = rays;
  dots.kind = DetailKind::speckles;
  dots.face = DetailFace::skin;
  dots.parts = {0};
  dots.depth = Ramp<double>::constant(1);
  fruit.details = {rays, dots, veins};
  return fruit;
}

DiffusionSurfaces ball() { return shapes::sphere(radius, 24, shapes::skin_paint()); }

CrossSection section_of(const DiffusionSurfaces& surfaces, const std::vector<std::string>& knives) {
  std::vector<Knife> parsed;
  for (const std::string& knife : knives) parsed.push_back(parse_knife(knife));
  CrossSection section = cut(surfaces, parsed).section;
  for (std::int32_t& part : section.part) part = 1;
  return section;
}

TEST(Guided, costs_nothing_where_no_detail_asks) {
  Template fruit = detailed_fruit();
  fruit.details.clear();
  EXPECT_TRUE(guided(section_of(ball(), {"half"}), ball(), fruit).guide.empty());
  fruit.details = {detailed_fruit().details[1]};
  EXPECT_TRUE(guided(section_of(ball(), {"half"}), ball(), fruit).guide.empty());
  EXPECT_TRUE(guided(CrossSection{}, ball(), detailed_fruit()).guide.empty());
}

TEST(Guided, comes_out_the_same_where_the_skin_is_known_before_and_on_any_threads) {
  const DiffusionSurfaces surfaces = ball();
  const SkinDepth skin(surfaces);
  const CrossSection own = guided(section_of(surfaces, {"half"}), surfaces, detailed_fruit());
  const CrossSection known = guided(section_of(surfaces, {"half"}), surfaces, detailed_fruit(), {1}, &skin);
  ASSERT_EQ(own.guide.size(), own.position.size());
  ASSERT_EQ(known.guide.size(), own.guide.size());
  for (std::size_t v = 0; v < own.guide.size(); ++v) {
    EXPECT_EQ(known.guide[v].to_skin, own.guide[v].to_skin);
    EXPECT_EQ(known.guide[v].layer, own.guide[v].layer);
    EXPECT_EQ(known.guide[v].share, own.guide[v].share);
  }
}

TEST(Guided, points_to_the_foot_on_the_skin) {
  const DiffusionSurfaces surfaces = ball();
  const CrossSection section = guided(section_of(surfaces, {"half"}), surfaces, detailed_fruit());
  ASSERT_EQ(section.guide.size(), section.position.size());
  const Box<double> bounds = bounds_of(surfaces);
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    const glm::dvec3 out = glm::dvec3(section.position[v]) - bounds.center();
    const double away = glm::length(out);
    if (away < 0.2 * radius) continue;  // near the middle no direction is preferred
    const glm::dvec3 foot = out + glm::dvec3(section.guide[v].to_skin);
    EXPECT_NEAR(glm::length(foot), radius, 0.02 * radius);
    EXPECT_GT(glm::dot(foot, out) / (glm::length(foot) * away), 0.995);
    const double depth = radius - away;
    EXPECT_NEAR(static_cast<double>(section.guide[v].share[0]), std::min(1.0, depth / 0.01), 0.08);
    EXPECT_EQ(section.guide[v].share[1], 0.5f);
    EXPECT_EQ(section.guide[v].share[2], 0.0f);
  }
}

/// Of two nested spheres, the outer one has depth 0, the inner one its distance from the outer one.
TEST(Guided, layers_are_as_deep_as_they_lie) {
  const DiffusionSurfaces both = joined(ball(), shapes::sphere(0.5 * radius, 16, shapes::skin_paint()));
  const CrossSection section = guided(section_of(both, {"half"}), both, detailed_fruit());
  ASSERT_EQ(section.guide.size(), section.position.size());
  int at_inner = 0;
  float deepest = 0;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    const double out = glm::length(glm::dvec3(section.position[v]));
    const auto layer = static_cast<double>(section.guide[v].layer);
    deepest = std::max(deepest, section.guide[v].layer);
    if (std::fabs(out - 0.5 * radius) < 0.01 * radius) {
      EXPECT_NEAR(layer, 0.5 * radius, 0.06 * radius);
      ++at_inner;
    } else if (out > 0.97 * radius) {
      EXPECT_LT(layer, 0.06 * radius);
    }
  }
  EXPECT_GT(at_inner, 5);
  EXPECT_LE(deepest, 0.53f * float(radius));
}

TEST(Guided, surfaces_that_stay_out_turn_nothing_aside) {
  Template fruit = detailed_fruit();
  fruit.surfaces.resize(2);
  const DiffusionSurfaces rays = shapes::moved(shapes::sphere(0.3 * radius, 12), {0.4 * radius, 0, 0});
  const DiffusionSurfaces both = joined(ball(), rays);
  const CrossSection section = section_of(both, {"half"});
  const CrossSection aside = guided(section, both, fruit);
  fruit.surfaces[1].guide = false;
  const CrossSection straight = guided(section, both, fruit), alone = guided(section, ball(), fruit);
  float max = 0;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    EXPECT_LT(glm::distance(straight.guide[v].to_skin, alone.guide[v].to_skin), 1e-6f * float(radius));
    max = std::max(max, glm::distance(aside.guide[v].to_skin, alone.guide[v].to_skin));
  }
  EXPECT_GT(max, 0.2f * float(radius)) << "it would have";
}

/// The places on the line where the planes z = 0 and y = 0 meet, which are no vertices.
std::vector<glm::dvec3> places_on_the_common_line() {
  std::vector<glm::dvec3> places;
  for (int i = -97; i <= 97; ++i) places.emplace_back(radius * i / 100.0, 0, 0);
  return places;
}

TEST(Guided, two_cuts_made_apart_agree_to_the_bit_where_they_meet) {
  const DiffusionSurfaces surfaces = ball();
  const CrossSection half = guided(section_of(surfaces, {"half"}), surfaces, detailed_fruit());
  const CrossSection across = guided(section_of(surfaces, {"plane:0,1,0,0mm"}), surfaces, detailed_fruit(), {1});
  const CrossSection both = guided(section_of(surfaces, {"half", "wedges:5"}), surfaces, detailed_fruit(), {3});
  ASSERT_NE(half.guide_lattice, nullptr);
  for (const glm::dvec3& place : places_on_the_common_line()) {
    const auto in_half = half.guide_lattice->at(place), in_across = across.guide_lattice->at(place);
    ASSERT_TRUE(in_half && in_across) << place.x;
    EXPECT_EQ(*in_half, *in_across) << place.x;
    EXPECT_EQ(*in_half, both.guide_lattice->at(place)) << place.x;
  }
}

TEST(Guided, vertices_have_what_the_lattice_has_there) {
  const DiffusionSurfaces surfaces = ball();
  const CrossSection section = guided(section_of(surfaces, {"half", "across"}), surfaces, detailed_fruit());
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    const auto at = section.guide_lattice->at(glm::dvec3(section.position[v]));
    ASSERT_TRUE(at);
    EXPECT_EQ(section.guide[v].to_skin, glm::vec3(*at));
    EXPECT_EQ(section.guide[v].layer, at->w);
  }
}

/// The ball's section; only its middle is flesh.
CrossSection section_with_a_core() {
  CrossSection section = section_of(ball(), {"half"});
  const glm::dvec3 middle = bounds_of(ball()).center();
  for (std::size_t v = 0; v < section.part.size(); ++v)
    section.part[v] = glm::length(glm::dvec3(section.position[v]) - middle) < 0.4 * radius ? 1 : 0;
  return section;
}

TEST(Guided, left_out_is_only_what_nobody_asks_for) {
  // Details of the flesh only, and details of all parts.
  Template core = detailed_fruit(), everywhere = detailed_fruit();
  for (DetailSketch& detail : everywhere.details) detail.parts = {0, 1};
  const CrossSection some = guided(section_with_a_core(), ball(), core);
  const CrossSection all = guided(section_with_a_core(), ball(), everywhere);

  // Corners of triangles in which the core's guides are blended keep their guides; far from them there are none.
  std::vector<std::uint8_t> blended(some.position.size(), 0);
  for (const glm::uvec3& t : some.triangle) {
    if (some.part[t.x] != 1 && some.part[t.y] != 1 && some.part[t.z] != 1) continue;
    for (int k = 0; k < 3; ++k) blended[t[k]] = 1;
  }
  int as_ever = 0, none = 0;
  for (std::size_t v = 0; v < some.guide.size(); ++v) {
    if (blended[v] != 0) {
      EXPECT_LT(glm::distance(some.guide[v].to_skin, all.guide[v].to_skin), 1e-6f * float(radius));
      EXPECT_NEAR(some.guide[v].layer, all.guide[v].layer, 1e-6f * float(radius));
      ++as_ever;
    }
    if (some.guide[v].to_skin == glm::vec3(0) && all.guide[v].to_skin != glm::vec3(0)) {
      EXPECT_EQ(some.guide[v].share, glm::vec4(0));
      ++none;
    }
    if (some.part[v] == 1) {
      EXPECT_EQ(some.guide[v].share, all.guide[v].share);
    }
  }
  EXPECT_GT(as_ever, 10);
  EXPECT_GT(none, 10);
}

TEST(Guided, goes_with_the_pieces) {
  const DiffusionSurfaces surfaces = ball();
  std::vector<Knife> knives = {parse_knife("half")};
  Cut pieces = cut(surfaces, knives);
  for (std::int32_t& part : pieces.section.part) part = 1;
  const CrossSection section = guided(pieces.section, surfaces, detailed_fruit());
  for (const Solid& solid : solids(pieces.pieces, section, detailed_fruit(), "ball")) {
    ASSERT_EQ(solid.mesh.guide.size(), solid.mesh.position.size());
    EXPECT_EQ(solid.mesh.guide_lattice, section.guide_lattice);
    for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
      const DetailGuide& guide = solid.mesh.guide[solid.mesh.triangle[t].x];
      EXPECT_EQ(guide.share[1], solid.mesh.cut_face[t] < 0 ? 0.0f : 0.5f);
      if (solid.mesh.cut_face[t] < 0) {
        EXPECT_EQ(guide.share[0], 1.0f);
      }
    }
  }
}

}  // namespace
}  // namespace pomona
