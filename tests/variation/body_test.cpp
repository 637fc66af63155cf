// Size, proportions and bend of variants (beyond the paper).
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/mesh/moments.h"
#include "generator/surface/bodies.h"
#include "generator/surface/crossings.h"
#include "generator/surface/grains/grains.h"
#include "generator/surface/sheets.h"
#include "generator/surface/sweep/body_map.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/bend_strain.h"
#include "generator/template/read/read_template.h"
#include "generator/variation/scaled.h"
#include "generator/variation/variation.h"
#include "generator/variation/vary.h"
#include "generator/variation/vary_body.h"
#include "tests/variation/fruits.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

/// Much larger deviations than those of any fruit.
const VariationSketch wild{.size = 0.25, .profile = 0.2, .bend = {.angle = 0.7, .swing = 0.7, .around = true}};

Template varying(Template fruit, const VariationSketch& variation = wild) {
  fruit.variation = variation;
  return fruit;
}

Template shipped(const std::string& name) {
  return read_template(fs::path(POMONA_SOURCE_DIR) / "templates" / (name + ".toml"));
}

/// A straight tube of 0.02 m radius and 0.2 m height.
Template tube() {
  Template fruit;
  fruit.parts = {"flesh"};
  SurfaceSketch skin;
  skin.name = "skin";
  skin.vertical = {{{0, 0}, {0.02, 0}, {0.02, 0.2}, {0, 0.2}}, false};
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * pi * i / 64;
    skin.horizontal.resize(1);
    skin.horizontal[0].points.emplace_back(0.02 * std::cos(angle), 0.02 * std::sin(angle));
  }
  skin.horizontal[0].closed = true;
  skin.reference = ReferenceRadii{0, 0.02};
  skin.front.hidden = true;
  skin.front.color.along = skin.back.color.along = Ramp<Color>::constant(Color(0.5f));
  skin.along = 120;
  fruit.surfaces = {skin};
  return fruit;
}

/// The enclosed volume, by the divergence theorem.
double volume(const DiffusionSurfaces& surfaces) { return moments_of(surfaces.position, surfaces.triangle, {}).mass; }

/// The determinant of the map's derivative, by differences over a hundredth of a millimetre.
double jacobian(const BodyMap& map, const glm::dvec3& p) {
  constexpr double h = 1e-5;
  const auto along = [&](const glm::dvec3& d) { return (map(p + d * h) - map(p - d * h)) / (2 * h); };
  return glm::dot(along({1, 0, 0}), glm::cross(along({0, 1, 0}), along({0, 0, 1})));
}

TEST(Body, is_the_same_every_time_and_for_each_index_its_own) {
  const Template fruit = varying(fruits::tomato());
  for (const bool curves_only : {false, true}) {
    const VariationOptions options{.curves_only = curves_only};
    const DiffusionSurfaces first = sweep(vary(fruit, {5, 6}, options));
    EXPECT_EQ(first.position, sweep(vary(fruit, {5, 6}, options)).position);
    EXPECT_NE(first.position, sweep(vary(fruit, {5, 7}, options)).position);
    EXPECT_NE(first.position, sweep(vary(fruit, {6, 6}, options)).position);
  }
  for (std::uint64_t index = 0; index < 5; ++index) {
    const Template a = vary_body(fruit, {3, index}, 1), b = vary_body(fruit, {3, index + 1}, 1);
    EXPECT_NE(a.bend.angle, b.bend.angle);
    EXPECT_NE(a.proportions.slenderness, b.proportions.slenderness);
    EXPECT_NE(a.surfaces[0].vertical.points, b.surfaces[0].vertical.points);
  }
}

TEST(Body, no_draw_depends_on_another) {
  const Template fruit = fruits::tomato();
  const auto with = [&](const VariationSketch& variation) { return vary_body(varying(fruit, variation), {4, 1}, 1); };
  const Template all = with({.size = 0.1, .profile = 0.1, .bend = {.angle = 0.2, .swing = 0.1}});
  const Template no_size = with({.size = 0, .profile = 0.1, .bend = {.angle = 0.2, .swing = 0.1}});
  const Template no_swing = with({.size = 0.1, .profile = 0, .bend = {.angle = 0.2, .swing = 0}});
  EXPECT_EQ(all.proportions.slenderness, no_size.proportions.slenderness);
  EXPECT_EQ(all.bend.angle, no_size.bend.angle);
  EXPECT_EQ(all.bend.swing, no_size.bend.swing);
  EXPECT_EQ(all.bend.angle, no_swing.bend.angle);
  EXPECT_EQ(all.surfaces[0].vertical.points, no_swing.surfaces[0].vertical.points);
  EXPECT_EQ(no_swing.bend.swing, 0);
  EXPECT_TRUE(no_swing.proportions.are_as_drawn());

  // The random numbers of curves do not change either.
  const Template curves = vary(fruit, {4, 1}), more = vary(varying(fruit, {.profile = 0.1}), {4, 1});
  EXPECT_EQ(curves.surfaces[0].horizontal[0].points, more.surfaces[0].horizontal[0].points);
}

TEST(Body, curves_alone_vary_as_if_nothing_else_had_been_said) {
  for (const Template& fruit : {fruits::onion(3), fruits::tomato()}) {
    const DiffusionSurfaces plain = sweep(vary(fruit, {7, 0}));
    EXPECT_EQ(plain.position, sweep(vary(varying(fruit), {7, 0}, {.curves_only = true})).position);
    EXPECT_EQ(sweep(vary(fruit, {7, 0}, {.amount = 0})).position,
              sweep(vary(varying(fruit), {7, 0}, {.amount = 0})).position);
  }
}

TEST(Body, a_bend_of_nothing_changes_no_bit) {
  Template fruit = fruits::tomato();
  const DiffusionSurfaces straight = sweep(fruit);
  fruit.bend = {.angle = 0, .swing = 0, .direction = 1};
  EXPECT_TRUE(BodyMap(fruit).is_identity());
  EXPECT_EQ(sweep(fruit).position, straight.position);
}

TEST(Body, all_draws_leave_space_one_to_one) {
  // A grid over the whole fruit, for a thousand variants with twice the deviations.
  for (const char* name : {"cucumber", "apple"}) {
    const Template fruit = varying(shipped(name));
    double widest = 0;
    for (const glm::dvec2& p : fruit.surfaces[0].vertical.points) widest = std::max(widest, p.x);
    double min = 1e9;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
      const Template variant = gently_bent(vary_body(fruit, {seed, 0}, 2), fruit);
      EXPECT_LE(bend_strain(variant).pressing, 0.6 + 1e-12);
      EXPECT_LE(bend_strain(variant).lean, radians(60) + 1e-12);
      const HeightRange range = drawn_heights(variant);
      const BodyMap map(variant);
      // Inside the skin, where the bend must be one-to-one.
      const double size = range.high / drawn_heights(fruit).high;
      const Curve& skin = variant.surfaces[0].vertical;
      for (std::size_t i = 0; i < skin.points.size(); i += 1 + skin.points.size() / 12) {
        for (int k = 0; k < 8; ++k) {
          const glm::dvec2 at = skin.points[i];
          const double angle = 2 * pi * k / 8;
          min = std::min(min, jacobian(map, {at.x * std::cos(angle), at.y, at.x * std::sin(angle)}));
        }
      }
      EXPECT_GT(size, std::exp(-2 * 2 * 0.25) * 0.999);
      EXPECT_LT(size, std::exp(2 * 2 * 0.25) * 1.001);
    }
    EXPECT_GT(min, 0.01) << name;
  }
}

TEST(Body, proportions_are_a_monotone_map_of_the_half_plane) {
  const Template fruit = varying(fruits::onion(1), {.profile = 0.25});
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Proportions proportions = vary_body(fruit, {seed, 0}, 2).proportions;
    EXPECT_NEAR(proportions.place(-1), -1, 1e-15);
    EXPECT_NEAR(proportions.place(1), 1, 1e-15);
    for (double u = -1.5; u < 1.5; u += 0.05) {
      EXPECT_GT(proportions.place(u + 0.05), proportions.place(u));
      EXPECT_GT(proportions.radius_factor(u), 0.05);
      EXPECT_LT(proportions.radius_factor(u), 20);
    }
  }
}

TEST(Body, no_two_proportions_go_together) {
  Template fruit = fruits::onion();
  fruit.variation.profile = 0.1;
  constexpr std::size_t count = 600;
  std::array<std::vector<double>, 5> drawn;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Proportions p = vary_body(fruit, {seed, 0}, 1).proportions;
    const std::array<double, 5> one{p.slenderness, p.pear, p.barrel, p.shoulders, p.stretch};
    for (std::size_t i = 0; i < one.size(); ++i) drawn[i].push_back(one[i]);
  }
  const auto product = [&](std::size_t i, std::size_t j) {
    return std::inner_product(drawn[i].begin(), drawn[i].end(), drawn[j].begin(), 0.0);
  };
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    ASSERT_GT(product(i, i), 0) << i;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_LT(std::fabs(product(i, j)) / std::sqrt(product(i, i) * product(j, j)), 0.2) << i << " " << j;
  }
}

TEST(Body, twice_the_size_is_eight_times_the_volume) {
  Template fruit = fruits::tomato();
  fruit.surfaces.resize(1);
  const double drawn = volume(sweep(fruit));
  for (const double size : {0.5, 0.8, 1.3, 2.0}) {
    const Template other = scaled(fruit, size);
    EXPECT_NEAR(volume(sweep(other)), drawn * size * size * size, 1e-6 * drawn * size * size * size);
    EXPECT_EQ(sweep(other).triangle, sweep(fruit).triangle);
  }
  // Slenderness keeps the volume.
  fruit.proportions.slenderness = 0.4;
  EXPECT_NEAR(volume(sweep(fruit)), drawn, 1e-6 * drawn);
}

TEST(Body, a_larger_fruit_has_larger_meshes) {
  const Template fruit = shipped("kidney");
  ASSERT_FALSE(fruit.meshes.empty());
  const DiffusionSurfaces drawn = sweep(fruit), larger = sweep(scaled(fruit, 1.5));
  ASSERT_EQ(drawn.vertex_count(), larger.vertex_count());
  for (std::size_t v = 0; v < drawn.vertex_count(); ++v) {
    ASSERT_LT(glm::distance(1.5f * drawn.position[v], larger.position[v]), 1e-6);
    ASSERT_NEAR(1.5f * drawn.blur[v], larger.blur[v], 1e-7);
    ASSERT_EQ(drawn.front_color[v], larger.front_color[v]) << "ramps go with the mesh";
  }
}

TEST(Body, a_larger_fruit_has_as_many_grains) {
  const Template fruit = shipped("strawberry"), large = scaled(fruit, 2);
  const DiffusionSurfaces small_grains = scatter_grains(fruit, {1, 0}), large_grains = scatter_grains(large, {1, 0});
  ASSERT_EQ(small_grains.vertex_count(), large_grains.vertex_count());
  for (std::size_t v = 0; v < small_grains.vertex_count(); ++v) {
    EXPECT_LT(glm::distance(2.0f * small_grains.position[v], large_grains.position[v]), 1e-6);
  }
}

TEST(Body, a_bent_axis_keeps_its_length_and_stands_in_the_middle) {
  Template fruit = tube();
  for (const AxisBend& bend : {AxisBend{1, 0, 0}, AxisBend{0.3, 1.1, 2}, AxisBend{0, 1.5, -1}}) {
    fruit.bend = bend;
    const BodyMap map(fruit);
    double length = 0;
    glm::dvec3 mean(0), before = map({0, 0, 0});
    for (int i = 1; i <= 1000; ++i) {
      const glm::dvec3 here = map({0, 0.2 * i / 1000, 0});
      length += glm::distance(before, here);
      mean += 0.5 * (before + here) / 1000.0;
      before = here;
    }
    EXPECT_NEAR(length, 0.2, 1e-7);
    EXPECT_NEAR(mean.x, 0, 1e-7);
    EXPECT_NEAR(mean.z, 0, 1e-7);
    EXPECT_NEAR(map({0, 0, 0}).y, 0, 1e-12);
  }
}

TEST(Body, a_bend_keeps_volumes_and_sections) {
  // By Pappus' theorem the outer side gains what the inner side loses.
  Template fruit = tube();
  const double straight = volume(sweep(fruit));
  fruit.bend = {.angle = 1.2, .swing = 0.5, .direction = 0.4};
  EXPECT_NEAR(volume(sweep(fruit)), straight, 2e-3 * straight);

  // Points of a section keep their distances from each other; both ends turn towards the direction.
  const BodyMap map(fruit);
  EXPECT_NEAR(glm::distance(map({0.02, 0.11, 0}), map({-0.01, 0.11, 0.015})), glm::length(glm::dvec2(0.03, 0.015)),
              1e-12);
  const glm::dvec3 towards(std::cos(0.4), 0, -std::sin(0.4));
  EXPECT_GT(glm::dot(map({0, 0, 0}) - map({0, 0.1, 0}), towards), 0.005);
  EXPECT_GT(glm::dot(map({0, 0.2, 0}) - map({0, 0.1, 0}), towards), 0.005);
}

TEST(Body, an_arc_of_a_circle_is_one) {
  Template fruit = tube();
  fruit.bend = {.angle = pi / 2, .swing = 0, .direction = 0};
  const BodyMap map(fruit);
  const double radius = 0.2 / (pi / 2);
  const glm::dvec3 middle = map({0, 0.1, 0}), center = middle + glm::dvec3(radius, 0, 0);
  for (double y = 0; y <= 0.2; y += 0.01) {
    EXPECT_NEAR(glm::distance(map({0, y, 0}), center), radius, 1e-9);
    EXPECT_NEAR(glm::distance(map({0.02, y, 0}), center), radius - 0.02, 1e-9);
  }
}

TEST(Body, beyond_its_ends_a_bent_fruit_goes_on_straight) {
  // Stems and grains stick out there: a part drawn upright beyond an end stands along the axis at that end.
  Template fruit = tube();
  fruit.bend = {.angle = 1.2, .swing = 0.5, .direction = 0.4};
  const BodyMap map(fruit);
  for (const glm::dvec3& aside : {glm::dvec3(0), glm::dvec3(0.015, 0, 0), glm::dvec3(-0.004, 0, 0.01)}) {
    for (const auto& [end, away] : {std::pair{0.2, 1.0}, {0.0, -1.0}}) {
      const auto at = [&, end = end, away = away](double distance) {
        return map(aside + glm::dvec3(0, end + away * distance, 0));
      };
      const glm::dvec3 way = at(0.01) - at(0);
      EXPECT_NEAR(glm::length(way), 0.01, 1e-12);
      for (const double distance : {0.001, 0.03, 0.1})
        EXPECT_NEAR(glm::distance(at(distance), at(0) + distance / 0.01 * way), 0, 1e-12) << distance;
    }
  }
}

TEST(Body, connectivity_and_colours_are_those_of_the_drawing) {
  for (const Template& fruit : {varying(fruits::onion(3)), varying(fruits::tomato())}) {
    const DiffusionSurfaces drawn = sweep(fruit);
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
      const DiffusionSurfaces variant = sweep(vary(fruit, {seed, 0}));
      EXPECT_EQ(variant.triangle, drawn.triangle);
      EXPECT_EQ(variant.front_color, drawn.front_color);
    }
  }
}

TEST(Body, nothing_crosses_that_does_not_in_the_curves_alone) {
  const Template tomato = varying(fruits::tomato(), {.size = 0.1, .profile = 0.1, .bend = {0.2, 0.1, true}});
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    if (!crossing_triangles(sweep(vary(tomato, {seed, 0}, {.curves_only = true}))).empty()) continue;
    EXPECT_TRUE(crossing_triangles(sweep(vary(tomato, {seed, 0}))).empty()) << seed;
  }
}

/// Two skins so close that their facets, different in number, nearly touch; the axis bends.
Template two_near_skins(double apart, int more_around, double angle) {
  Template fruit = fruits::onion(1);
  fruit.surfaces.front().along = 10;
  SurfaceSketch inner = fruit.surfaces.front();
  inner.name = "inner";
  inner.front.hidden = false;
  inner.along = 13;
  inner.around += more_around;
  for (glm::dvec2& p : inner.vertical.points) p = {(1 - apart) * p.x, 0.04 + (1 - apart) * (p.y - 0.04)};
  for (glm::dvec2& p : inner.horizontal.front().points) p *= 1 - apart;
  fruit.surfaces.push_back(inner);
  fruit.bend = {.angle = angle, .swing = 0.5 * angle, .direction = 0};
  return fruit;
}

TEST(Body, differs_from_the_drawing_though_facets_would_cross_if_it_differed_more) {
  for (const auto& [apart, angle] : {std::pair{0.035, 0.8}, {0.04, 1.2}}) {
    const Template fruit = varying(two_near_skins(apart, 0, angle));
    ASSERT_TRUE(crossing_triangles(sweep(fruit)).empty());
    const Variation variation(fruit);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Template variant = variation.draw({seed, 0}, {.amount = 2}).fruit;
      EXPECT_FALSE(variant.proportions.are_as_drawn()) << seed;
      EXPECT_TRUE(crossing_triangles(sweep(variant)).empty()) << seed;
    }
  }
}

TEST(Body, bends_less_but_in_the_same_shape_where_facets_would_cross) {
  const Template fruit = varying(two_near_skins(0.035, -3, 0.8), {});
  ASSERT_TRUE(crossing_triangles(sweep(fruit)).empty());
  const Variation variation(fruit);
  int straighter = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Template variant = variation.draw({seed, 0}, {.amount = 2}).fruit;
    EXPECT_NEAR(variant.bend.swing, 0.5 * variant.bend.angle, 1e-12) << seed;
    EXPECT_TRUE(crossing_triangles(sweep(variant)).empty()) << seed;
    straighter += !variant.bend.is_straight() && variant.bend.angle < 0.75 * fruit.bend.angle;
  }
  EXPECT_GT(straighter, 5);
}

TEST(Body, bent_fruits_are_closed_and_hold_their_grains) {
  Template okra = varying(shipped("okra"), {.size = 0.2, .profile = 0.1, .bend = {0.4, 0.3, false}});
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const Template variant = vary(okra, {seed, 0});
    EXPECT_FALSE(variant.bend.is_straight());
    const DiffusionSurfaces all = joined(sheets(sweep(variant)), sheets(scatter_grains(variant, {seed, 0})));
    EXPECT_TRUE(find_bodies(all).warnings.empty());
  }
}

}  // namespace
}  // namespace pomona
