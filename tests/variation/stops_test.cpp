// Loops as stops along the axis vary together.
#include <cmath>

#include <gtest/gtest.h>

#include "generator/base/units.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/bend_strain.h"
#include "generator/variation/vary.h"
#include "generator/variation/vary_body.h"
#include "tests/variation/fruits.h"

namespace pomona {
namespace {

/// The drawing's first surface with its loop, drawn rounder, as a second stop.
Template with_stops(Template fruit) {
  SurfaceSketch& skin = fruit.surfaces.front();
  const double radius = reference_radii(skin).outer;
  Curve rounder = skin.horizontal.front();
  for (glm::dvec2& p : rounder.points) p += 0.5 * (p * (radius / glm::length(p)) - p);
  skin.horizontal.push_back(rounder);
  skin.stops = {0.2, 0.8};
  return fruit;
}

TEST(Stops, vary_by_one_map) {
  for (const Template& drawn : {with_stops(fruits::onion(3)), with_stops(fruits::tomato())}) {
    const DiffusionSurfaces before = sweep(drawn);
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
      const Template variant = vary(drawn, {seed, 0});
      const SurfaceSketch& skin = variant.surfaces.front();
      ASSERT_EQ(skin.horizontal.size(), 2u);
      EXPECT_NE(skin.horizontal[0].points, drawn.surfaces.front().horizontal[0].points);
      EXPECT_NE(skin.horizontal[0].points, skin.horizontal[1].points);
      EXPECT_EQ(sweep(variant).triangle, before.triangle);

      // The rounder one stays the rounder one: their radii swing together.
      const double reference = reference_radii(skin).outer;
      double together = 0;
      for (std::size_t i = 0; i < skin.horizontal[0].points.size(); ++i) {
        const double first = glm::length(skin.horizontal[0].points[i]) - reference;
        const double second = glm::length(skin.horizontal[1].points[i]) - reference;
        together += first * second;
      }
      EXPECT_GT(together, 0) << seed;
    }
  }
}

TEST(Stops, a_drawn_axis_keeps_its_line) {
  Template drawn = fruits::onion(3);
  for (int i = 0; i <= 64; ++i) drawn.bend.line.push_back(-0.2 + 0.4 * i / 64);
  drawn.variation.bend = {.angle = 0.6, .swing = 0.4};
  bool bends = false;
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    const Template variant = vary(drawn, {seed, 0});
    EXPECT_EQ(variant.bend.line, drawn.bend.line);
    EXPECT_LE(bend_strain(variant).pressing, max_strain.pressing);
    bends = bends || variant.bend.angle != 0;
  }
  EXPECT_TRUE(bends);
  Template strained = drawn;
  strained.bend.angle = 6;
  EXPECT_LE(bend_strain(gently_bent(strained, drawn)).pressing, 0.6);
  EXPECT_EQ(gently_bent(strained, drawn).bend.line, drawn.bend.line);
}

}  // namespace
}  // namespace pomona
