// Ripeness and colour of individuals.
#include "generator/variation/ripen.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/variation/individual_colors.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

const Color red(0.6f, 0.03f, 0.02f), green(0.1f, 0.3f, 0.05f), brown(0.2f, 0.05f, 0.02f), cream(0.8f, 0.7f, 0.4f);

/// Skin and flesh ripen from green over red, as drawn, to brown; the stone does not change.
Template ripening_fruit() {
  Template fruit;
  fruit.name = "ball";
  fruit.parts = {"skin", "flesh", "stone"};
  for (const int part : {0, 1}) fruit.ripeness.parts.push_back({.part = part, .stops = {{0, green}, {2, brown}}});
  return fruit;
}

/// Three nested spheres of 30, 20 and 10 mm in one colour: skin, flesh, stone.
DiffusionSurfaces nested_fruit(const Color& color = red) {
  shapes::Paint skin = shapes::skin_paint(), flesh, stone;
  skin.front = skin.back = flesh.front = flesh.back = stone.front = stone.back = color;
  flesh.front_part = "flesh", stone.back_part = "stone";
  skin.name = "skin", flesh.name = "flesh", stone.name = "stone", stone.front_part = "flesh";
  DiffusionSurfaces surfaces = shapes::sphere(0.03, 6, skin);
  surfaces = joined(surfaces, shapes::sphere(0.02, 6, flesh));
  return joined(surfaces, shapes::sphere(0.01, 6, stone));
}

DiffusionSurfaces ripened_to(double ripeness, Template fruit, const DiffusionSurfaces& surfaces) {
  fruit.individual.ripeness = ripeness;
  if (!surfaces.part_names.empty()) fruit.parts = surfaces.part_names;
  return ripened(surfaces, fruit, SkinDepth(surfaces), tissue_colors(surfaces, {}, fruit));
}

/// The share of the way from `from` to `to` at which a colour lies, in OKLab, and its distance from that line.
struct OnWay {
  double share = 0, beside = 0;
};
OnWay on_way(const Color& color, const Color& from, const Color& to) {
  const glm::dvec3 a(to_oklab(from)), b(to_oklab(to)), c(to_oklab(color));
  const double share = glm::dot(c - a, b - a) / glm::dot(b - a, b - a);
  return {share, glm::length(c - (a + share * (b - a)))};
}

/// The vertices of a named surface.
std::vector<std::size_t> vertices_of(const DiffusionSurfaces& surfaces, const std::string& name) {
  std::vector<std::uint8_t> is_in(surfaces.vertex_count(), 0);
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    if (surfaces.surface_names[static_cast<std::size_t>(surfaces.surface[i])] != name) continue;
    for (int k = 0; k < 3; ++k) is_in[surfaces.triangle[i][k]] = 1;
  }
  std::vector<std::size_t> vertices;
  for (std::size_t v = 0; v < is_in.size(); ++v)
    if (is_in[v] != 0) vertices.push_back(v);
  return vertices;
}

TEST(OwnRipeness, is_as_drawn_at_one_and_extreme_at_the_ends) {
  for (double late = -0.5; late <= 1.5; late += 0.125) {
    for (const double spread : {0.0, 0.5, 3.0}) {
      EXPECT_EQ(own_ripeness(1, late, spread), 1);
      EXPECT_EQ(own_ripeness(0, late, spread), 0);
      EXPECT_EQ(own_ripeness(2, late, spread), 2);
    }
  }
}

TEST(OwnRipeness, never_falls_as_the_fruit_ripens_nor_rises_with_lateness) {
  for (double late = 0; late <= 1; late += 0.1) {
    for (double r = 0; r < 1.99; r += 0.01) {
      EXPECT_LE(own_ripeness(r, late, 2), own_ripeness(r + 0.01, late, 2));
      EXPECT_GE(own_ripeness(r, late, 2), own_ripeness(r, late + 0.1, 2));
    }
  }
}

TEST(Ripening, at_one_every_bit_is_as_drawn) {
  Template fruit = ripening_fruit();
  fruit.ripeness.depth = {{{0, 0.0}, {0.01, 1.0}}};
  fruit.ripeness.patches = 0.5;
  const DiffusionSurfaces drawn = nested_fruit();
  const DiffusionSurfaces same = ripened_to(1, fruit, drawn);
  EXPECT_EQ(same.front_color, drawn.front_color);
  EXPECT_EQ(same.back_color, drawn.back_color);
  EXPECT_EQ(same.position, drawn.position);
}

TEST(Ripening, colours_lie_between_drawn_and_target_and_go_on_towards_it) {
  Template fruit = ripening_fruit();
  fruit.ripeness.height = {{{0, 0.0}, {1, 0.7}}};
  fruit.ripeness.patches = 0.3;
  const DiffusionSurfaces drawn = nested_fruit();
  std::vector<double> before(drawn.vertex_count(), 0);
  for (double r = 0; r < 1; r += 0.125) {
    const DiffusionSurfaces now = ripened_to(r, fruit, drawn);
    for (const std::size_t v : vertices_of(drawn, "skin")) {
      const OnWay way = on_way(now.back_color[v], green, red);
      EXPECT_GE(way.share, before[v] - 1e-5);
      EXPECT_LE(way.share, 1 + 1e-5);
      EXPECT_LT(way.beside, 1e-4);
      before[v] = way.share;
    }
  }
}

TEST(Ripening, at_the_ends_both_sides_have_their_targets) {
  const DiffusionSurfaces drawn = nested_fruit();
  for (const auto& [ripeness, target] : {std::pair{0.0, green}, {2.0, brown}}) {
    const DiffusionSurfaces now = ripened_to(ripeness, ripening_fruit(), drawn);
    for (std::size_t t = 0; t < drawn.triangle_count(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = drawn.triangle[t][k];
        const auto ripens = [&](std::int32_t part) {
          return drawn.part_names[static_cast<std::size_t>(part)] != "stone";
        };
        if (ripens(drawn.front_part[t])) {
          EXPECT_LT(glm::distance(now.front_color[v], target), 1e-4) << ripeness;
        }
        if (ripens(drawn.back_part[t])) {
          EXPECT_LT(glm::distance(now.back_color[v], target), 1e-4) << ripeness;
        }
      }
    }
  }
}

TEST(Ripening, parts_that_are_not_named_keep_their_bits) {
  const DiffusionSurfaces drawn = nested_fruit();
  const DiffusionSurfaces unripe = ripened_to(0, ripening_fruit(), drawn);
  for (const std::size_t v : vertices_of(drawn, "stone")) {
    EXPECT_EQ(unripe.back_color[v], red);
    EXPECT_NE(unripe.front_color[v], red);  // flesh
  }
}

TEST(Ripening, deeper_flesh_of_the_same_colour_ripens_as_declared) {
  Template fruit = ripening_fruit();
  fruit.ripeness.depth = {{{0, 1.0}, {0.02, 0.0}}};  // from the inside outwards
  const DiffusionSurfaces drawn = nested_fruit();
  const DiffusionSurfaces half = ripened_to(0.5, fruit, drawn);
  const auto share_of = [&](const std::string& surface) {
    double min = 2, max = -1;
    for (const std::size_t v : vertices_of(drawn, surface)) {
      const double share = on_way(half.front_color[v], green, red).share;
      min = std::min(min, share), max = std::max(max, share);
    }
    EXPECT_LT(max - min, 0.06) << surface;  // equal depth, up to the flatness of triangles
    return 0.5 * (min + max);
  };
  // u = 1/2, s = 1: x = 1 - clamp(l) with l = 1, 1/2, 0 at depths of 0, 10 and 20 mm.
  EXPECT_NEAR(share_of("skin"), 0, 1e-4);
  EXPECT_NEAR(share_of("flesh"), 0.5, 0.05);
  EXPECT_NEAR(share_of("stone"), 1, 0.05);
}

TEST(Ripening, stops_between_are_passed_through) {
  Template fruit = ripening_fruit();
  fruit.ripeness.spread = 0;
  fruit.ripeness.parts[0].stops = {{0, green}, {0.5, cream}};
  const DiffusionSurfaces drawn = nested_fruit();
  const std::size_t v = vertices_of(drawn, "skin").front();
  EXPECT_LT(glm::distance(ripened_to(0.5, fruit, drawn).front_color[v], cream), 1e-4);
  EXPECT_LT(glm::distance(ripened_to(0, fruit, drawn).front_color[v], green), 1e-4);
  EXPECT_EQ(ripened_to(1.5, fruit, drawn).front_color[v], red);  // nothing is defined beyond 1
}

TEST(Ripening, a_share_of_what_was_painted_is_kept) {
  Template fruit = ripening_fruit();
  fruit.ripeness.spread = 0;
  DiffusionSurfaces drawn = nested_fruit();
  const std::vector<std::size_t> skin = vertices_of(drawn, "skin");
  for (std::size_t k = 0; k < skin.size(); k += 2) drawn.front_color[skin[k]] = drawn.back_color[skin[k]] = cream;
  const auto contrast = [&](const DiffusionSurfaces& surfaces) {
    return glm::distance(to_oklab(surfaces.front_color[skin[0]]), to_oklab(surfaces.front_color[skin[1]]));
  };
  fruit.ripeness.parts[0].keep = 0;
  EXPECT_LT(contrast(ripened_to(0, fruit, drawn)), 1e-5);
  fruit.ripeness.parts[0].keep = 0.25;
  EXPECT_NEAR(contrast(ripened_to(0, fruit, drawn)), 0.25 * contrast(drawn), 0.02);  // the gamut may reduce it
}

TEST(Ripening, stays_within_the_gamut) {
  Template fruit = ripening_fruit();
  fruit.individual.shifts.assign(3, {.lightness = 0.5, .chroma = 3, .hue = 1});
  for (const Color& color : {red, green, cream, Color(0), Color(1)}) {
    for (const double ripeness : {0.0, 0.7, 1.0, 2.0}) {
      const DiffusionSurfaces now = ripened_to(ripeness, fruit, nested_fruit(color));
      for (std::size_t v = 0; v < now.vertex_count(); ++v)
        for (int k = 0; k < 3; ++k) {
          EXPECT_GE(now.front_color[v][k], 0);
          EXPECT_LE(now.front_color[v][k], 1);
        }
    }
  }
}

TEST(Ripening, surfaces_without_a_boundary_have_no_depth) {
  shapes::Paint open;
  const DiffusionSurfaces drawn = shapes::open_sheet(0.05, 0, 2, open);
  EXPECT_EQ(SkinDepth(drawn).depth({0, 0.1, 0}), 0);
  Template fruit = ripening_fruit();
  EXPECT_NO_THROW(ripened_to(0.3, fruit, drawn));
  EXPECT_EQ(ripened_to(0.3, fruit, DiffusionSurfaces{}).vertex_count(), 0u);
}

TEST(SkinDepth, is_the_distance_to_the_outermost_boundary) {
  const SkinDepth ball(shapes::hollow_ball(0.03, 0.01, 24));
  EXPECT_NEAR(ball.depth({0, 0.02, 0}), 0.01, 1e-4);  // not to the wall of the hollow
  EXPECT_NEAR(ball.depth({0.012, 0, 0}), 0.018, 1e-4);
  EXPECT_NEAR(ball.height({0, 0, 0}), 0.5, 1e-6);
  EXPECT_EQ(ball.height({0, 1, 0}), 1);
}

/// The difference between the stone's two sides, sRGB in 255ths.
glm::dvec3 difference_across(const DiffusionSurfaces& surfaces, std::size_t vertex) {
  return glm::dvec3(to_srgb8(surfaces.front_color[vertex])) - glm::dvec3(to_srgb8(surfaces.back_color[vertex]));
}

TEST(Tissues, stay_as_unlike_as_they_are_drawn) {
  DiffusionSurfaces surfaces = nested_fruit();
  const std::size_t stone = vertices_of(surfaces, "stone").front();
  surfaces.back_color[stone] = Color(0.5f, 0.12f, 0.1f);
  Template fruit = ripening_fruit();
  fruit.variation.color = {.all = 0, .parts = {0, 0.04, 0}, .ripeness = 0.2, .tissues = {{1, 2}}};
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Template one = fruit;
    one.individual = drawn_individual(fruit, {seed, 0});
    one.parts = surfaces.part_names;
    const DiffusionSurfaces varied = ripened(surfaces, one, SkinDepth(surfaces), tissue_colors(surfaces, {}, one));
    EXPECT_NE(varied.back_color[stone], surfaces.back_color[stone]) << seed;
    const glm::dvec3 moved = difference_across(varied, stone) - difference_across(surfaces, stone);
    for (int c = 0; c < 3; ++c) EXPECT_LE(std::fabs(moved[c]), 5) << seed;
  }
}

/// Flesh of an apple is much paler than the mean of its part, to which its bundles belong. Before, it went as far as
/// that mean and became one flat white.
TEST(Tissues, keep_their_shades_at_every_ripeness_and_deviation) {
  const Color pale(0.85f, 0.8f, 0.6f), paler(0.95f, 0.9f, 0.75f), dark(0.03f, 0.02f, 0.04f);
  DiffusionSurfaces surfaces = nested_fruit(Color(0.3f, 0.25f, 0.1f));
  const std::vector<std::size_t> flesh = vertices_of(surfaces, "flesh");
  for (std::size_t i = 0; i < 6; ++i)
    surfaces.front_color[flesh[i]] = surfaces.back_color[flesh[i]] = std::array{pale, paler, dark}[i % 3];
  Template fruit = ripening_fruit();
  for (RipenessSketch::Part& part : fruit.ripeness.parts) part.stops = {{0, Color(0.9f, 0.9f, 0.9f)}, {2, Color(0)}};
  fruit.variation.color.ripeness = 0.25;
  fruit.variation.color.tissues = {{1, 2}};
  for (const double lightness : {-0.3, 0.0, 0.3}) {
    fruit.individual.shifts.assign(3, {.lightness = lightness, .chroma = 1, .hue = 0});
    for (const double ripeness : {0.5, 0.8, 1.0, 1.2, 1.5}) {
      const DiffusionSurfaces now = ripened_to(ripeness, fruit, surfaces);
      const auto shade = [&](std::size_t i) { return glm::ivec3(to_srgb8(now.front_color[flesh[i]])); };
      for (int c = 0; c < 3; ++c) {
        EXPECT_LT(shade(0)[c], shade(1)[c]) << ripeness << ' ' << lightness;
        EXPECT_LT(shade(1)[c], 255) << ripeness << ' ' << lightness;
        EXPECT_GT(shade(2)[c], 0) << ripeness << ' ' << lightness;
      }
    }
  }
}

/// The core of a tomato: red as its flesh is while it ripens by itself, green if it is asked to be far from ripe.
TEST(Tissues, follow_their_first_part_within_strays_and_their_own_colours_beyond) {
  const DiffusionSurfaces surfaces = nested_fruit();
  const std::size_t stone = vertices_of(surfaces, "stone").front();
  Template fruit = ripening_fruit();
  fruit.ripeness.parts.push_back({.part = 2, .stops = {{0, cream}}});
  fruit.variation.color.ripeness = 0.1;
  fruit.variation.color.tissues = {{1, 2}};
  const DiffusionSurfaces astray = ripened_to(0.9, fruit, surfaces);
  EXPECT_EQ(to_srgb8(astray.back_color[stone]), to_srgb8(astray.front_color[stone]));
  EXPECT_LT(glm::distance(ripened_to(0, fruit, surfaces).back_color[stone], cream), 0.01f);
}

TEST(Tissues, keep_their_bits_in_the_fruit_as_drawn) {
  const DiffusionSurfaces surfaces = nested_fruit();
  Template fruit = ripening_fruit();
  fruit.variation.color.tissues = {{1, 2}};
  const DiffusionSurfaces same = ripened_to(1, fruit, surfaces);
  EXPECT_EQ(same.front_color, surfaces.front_color);
  EXPECT_EQ(same.back_color, surfaces.back_color);
}

TEST(Tissues, ripen_each_by_itself_farther_than_variants_stray) {
  // Flesh turns green, and the pale stone, which does not ripen, stays as it is drawn.
  const Color pale(0.9f, 0.75f, 0.6f);
  DiffusionSurfaces surfaces = nested_fruit();
  const std::size_t stone = vertices_of(surfaces, "stone").front();
  for (const std::size_t v : vertices_of(surfaces, "stone")) surfaces.back_color[v] = pale;
  Template fruit = ripening_fruit();
  fruit.variation.color.ripeness = 0.1;
  fruit.variation.color.tissues = {{1, 2}};
  const DiffusionSurfaces unripe = ripened_to(0, fruit, surfaces);
  EXPECT_LT(glm::distance(unripe.front_color[stone], green), 0.01f);
  EXPECT_LT(glm::distance(unripe.back_color[stone], pale), 0.01f);
  const DiffusionSurfaces half = ripened_to(0.5, fruit, surfaces);
  EXPECT_LT(glm::distance(half.back_color[stone], pale), 0.01f);
}

TEST(Individuals, differ_as_far_as_declared_and_never_more_than_two_deviations) {
  Template fruit = ripening_fruit();
  fruit.variation.color = {.all = 0.01, .parts = {0.03, 0, 0}, .ripeness = 0.2};
  double sum = 0, squares = 0, max = 0;
  constexpr int count = 2000;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const Individual one = drawn_individual(fruit, {seed, 0});
    ASSERT_EQ(one.shifts.size(), 3u);
    EXPECT_EQ(one.shifts[1].lightness, one.shifts[2].lightness);  // the draw for all
    const double own = one.shifts[0].lightness - one.shifts[1].lightness;
    sum += own, squares += own * own, max = std::max(max, std::fabs(own));
    EXPECT_LE(std::fabs(one.ripeness - 1), 0.4 + 1e-12);
  }
  EXPECT_NEAR(sum / count, 0, 0.003);
  EXPECT_NEAR(std::sqrt(squares / count), 0.03 * 0.96, 0.002);  // clipping removes 4 %
  EXPECT_LE(max, 0.06 + 1e-12);
}

TEST(Individuals, chroma_and_hue_differ_as_much_as_lightness_of_a_typical_colour) {
  Template fruit = ripening_fruit();
  fruit.variation.color = {.all = 0, .parts = {0.03, 0, 0}, .ripeness = 0};
  constexpr int count = 2000;
  constexpr double deviation = 0.03 / 0.25;
  double chroma = 0, hue = 0;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const ColorShift shift = drawn_individual(fruit, {seed, 0}).shifts.at(0);
    ASSERT_LE(std::fabs(shift.chroma - 1), 2 * deviation + 1e-12);
    ASSERT_LE(std::fabs(shift.hue), 2 * deviation + 1e-12);
    chroma += (shift.chroma - 1) * (shift.chroma - 1), hue += shift.hue * shift.hue;
  }
  EXPECT_NEAR(std::sqrt(chroma / count), 0.96 * deviation, 0.008);
  EXPECT_NEAR(std::sqrt(hue / count), 0.96 * deviation, 0.008);
}

TEST(Individuals, draws_of_one_part_do_not_depend_on_another) {
  Template fruit = ripening_fruit();
  fruit.variation.color.parts = {0.03, 0, 0};
  const Individual one = drawn_individual(fruit, {7, 0});
  fruit.variation.color.parts = {0.03, 0.05, 0.01};
  const Individual other = drawn_individual(fruit, {7, 0});
  EXPECT_EQ(one.shifts[0].hue, other.shifts[0].hue);
  EXPECT_EQ(one.ripeness, other.ripeness);
}

TEST(Individuals, are_as_drawn_without_variation) {
  Template fruit = ripening_fruit();
  EXPECT_TRUE(drawn_individual(fruit, {3, 0}).shifts.empty());
  EXPECT_EQ(drawn_individual(fruit, {3, 0}).ripeness, 1);
  fruit.variation.color = {.all = 0.05, .parts = {}, .ripeness = 0.3};
  EXPECT_TRUE(drawn_individual(fruit, {3, 0}, {.amount = 0}).shifts.empty());
  EXPECT_EQ(drawn_individual(fruit, {3, 0}, {.amount = 0}).ripeness, 1);
}

TEST(Individuals, refuse_what_the_template_does_not_declare) {
  Template fruit;
  EXPECT_THROW(drawn_individual(fruit, {}, {.ripeness = 0.5}), Error);
  EXPECT_THROW(drawn_individual(fruit, {}, {.browning = 0.5}), Error);
  EXPECT_THROW(drawn_individual(ripening_fruit(), {}, {.ripeness = 2.5}), Error);
}

}  // namespace
}  // namespace pomona
