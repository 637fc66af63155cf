// Paint on swept surfaces: ramps over the turn, folds, coats, spots and blur.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/parallel.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/sweep/grid_place.h"
#include "generator/surface/sweep/spots.h"
#include "generator/surface/sweep/surface_grids.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/surface/sweep/swept_fruit.h"
#include "generator/variation/vary.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;

const Color ground(0.8f, 0.2f, 0.1f), paint(0.1f, 0.3f, 0.05f);

SurfaceSketch ball() { return around_axis(meridian(0.04), circle(1)); }

double azimuth(const glm::vec3& p) { return reproducible::atan2(-p.z, p.x); }

/// The vertices of one ring of ball(): `around` of them after the lower pole.
std::vector<Color> ring(const DiffusionSurfaces& swept, int j, std::size_t around = 96) {
  const auto first = swept.front_color.begin() + 1 + static_cast<std::ptrdiff_t>(around) * (j - 1);
  return {first, first + static_cast<std::ptrdiff_t>(around)};
}

double largest_step(const std::vector<Color>& ring) {
  double largest = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    largest = std::max<double>(largest, glm::distance(ring[i], ring[(i + 1) % ring.size()]));
  }
  return largest;
}

/// Whether a colour is a blend of the two.
bool is_between(const Color& c, const Color& a, const Color& b) {
  for (int k = 0; k < 3; ++k) {
    if (c[k] < std::min(a[k], b[k]) - 1e-6f || c[k] > std::max(a[k], b[k]) + 1e-6f) return false;
  }
  const double whole = glm::distance(a, b);
  return std::fabs(glm::distance(c, a) + glm::distance(c, b) - whole) < 1e-5;
}

TEST(Paint, what_changes_over_the_turn_follows_the_azimuth_and_has_no_seam) {
  for (const int folds : {0, 1, 5}) {
    SurfaceSketch sketch = ball();
    sketch.front.color.turn = {{{0, Color(0.5f)}, {0.25, Color(1)}, {0.5, Color(0.2f)}, {1, Color(0.5f)}}};
    const DiffusionSurfaces swept = sweep(fruit({sketch}, folds));
    const std::size_t around = folds == 5 ? 95 : 96;
    const std::vector<Color> middle = ring(swept, 20, around);
    EXPECT_LT(largest_step(middle), 0.04);  // the steepest ramp climbs 0.8 * 0.8 in a quarter turn of 24 steps
    for (std::size_t i = 0; i < around; ++i) {
      const double turn = turn_of(azimuth(swept.position[1 + around * 19 + i]));
      EXPECT_NEAR(middle[i].r, ground.r * sketch.front.color.turn(turn).r, 1e-4);
    }
    // A pole has all azimuths, so its colour is the mean.
    EXPECT_NEAR(swept.front_color.front().r, ground.r * (0.75 / 4 + 0.6 / 4 + 0.35 / 2), 1e-3);
  }
}

TEST(Paint, folds_take_their_tints_in_turn_and_share_their_lines) {
  SurfaceSketch sketch = ball();
  sketch.front.color.folds = {Color(1), Color(0.5f, 1, 1), Color(0.25f, 1, 1)};
  const Template drawn = fruit({sketch}, 3);
  const std::vector<Color> middle = ring(sweep(drawn), 20);
  for (std::size_t i = 0; i < 96; ++i) {
    const std::size_t fold = i / 32, before = (fold + 2) % 3;
    const auto& tint = sketch.front.color.folds;
    const float wanted = i % 32 == 0 ? (tint[fold].r + tint[before].r) / 2 : tint[fold].r;
    EXPECT_FLOAT_EQ(middle[i].r, ground.r * wanted);
    EXPECT_FLOAT_EQ(middle[i].g, ground.g);
  }

  // If there are more folds than tints, tints repeat in turn.
  const std::vector<Color> more = ring(sweep(with_folds(drawn, 4)), 20);
  EXPECT_FLOAT_EQ(more[12].r, ground.r);
  EXPECT_FLOAT_EQ(more[36].r, ground.r * 0.5f);
  EXPECT_FLOAT_EQ(more[60].r, ground.r * 0.25f);
  EXPECT_FLOAT_EQ(more[84].r, ground.r);
}

TEST(Paint, chambers_have_the_tints_of_their_folds) {
  std::vector<Curve> loops;
  for (int k = 0; k < 3; ++k) {
    const double middle = 2 * pi * (k + 0.5) / 3;
    loops.push_back(circle_at(0.03 * glm::dvec2(reproducible::cos(middle), reproducible::sin(middle)), 0.012));
  }
  loops[0].points.clear();
  SurfaceSketch chamber = in_fold(circle_at({0.03, 0.04}, 0.012), loops);
  chamber.front.color.along = Ramp<Color>::constant(Color(1));
  chamber.front.color.folds = {Color(0.25f), Color(0.5f), Color(0.75f)};
  const DiffusionSurfaces swept = sweep(fruit({chamber}, 3));
  for (std::size_t v = 0; v < swept.vertex_count(); ++v) {
    const bool is_second = turn_of(azimuth(swept.position[v])) < 2.0 / 3;
    EXPECT_EQ(swept.front_color[v], Color(is_second ? 0.5f : 0.75f));
  }
}

TEST(Paint, a_coat_covers_the_product_of_its_shares) {
  SurfaceSketch sketch = ball();
  Coat coat;
  coat.color = Ramp<Color>::constant(paint);
  coat.along = {{{0.25, 0}, {0.5, 1}, {0.75, 0}}};
  coat.turn = {{{0, 0}, {0.5, 1}, {1, 0}}};
  sketch.front.coats = {coat};
  const DiffusionSurfaces swept = sweep(fruit({sketch}));
  EXPECT_EQ(swept.front_color.front(), ground);
  EXPECT_EQ(swept.front_color.back(), ground);
  EXPECT_EQ(ring(swept, 8)[48], ground);  // below the coat
  for (const Color& color : swept.front_color) EXPECT_TRUE(is_between(color, ground, paint));
  const std::vector<Color> middle = ring(swept, 23);
  EXPECT_EQ(middle[0], ground);
  EXPECT_LT(glm::distance(middle[48], paint), 0.05f);
  EXPECT_GT(glm::distance(middle[24], paint), 0.3f);
  EXPECT_LT(largest_step(middle), 0.03);

  // Later coats lie over earlier ones.
  Coat over;
  over.color = Ramp<Color>::constant(Color(1));
  sketch.front.coats = {coat, over};
  for (const Color& color : sweep(fruit({sketch})).front_color) EXPECT_EQ(color, Color(1));
}

TEST(Paint, blur_changes_around_too) {
  SurfaceSketch sketch = ball();
  sketch.blur.along = Ramp<double>::constant(0.002);
  sketch.blur.around = {{{0, 0}, {0.5, 1}, {1, 0}}};
  const DiffusionSurfaces swept = sweep(fruit({sketch}, 3));
  const std::size_t first = 1 + 96 * 20;
  EXPECT_EQ(swept.blur[first], 0);
  EXPECT_FLOAT_EQ(swept.blur[first + 16], 0.002f);
  EXPECT_EQ(swept.blur[first + 8], swept.blur[first + 40]);
  EXPECT_NEAR(swept.blur.front(), 0.001f, 1e-5);
}

// ---- Spots ----

SpotSketch patch(double along, double degrees, double size) {
  SpotSketch spot;
  spot.color = paint;
  spot.place = PatchPlace{along, radians(degrees)};
  spot.size_min = spot.size_max = size;
  return spot;
}

SpotSketch scattered(double spacing, double size) {
  SpotSketch spot;
  spot.color = paint;
  spot.spacing = spacing;
  spot.size_min = spot.size_max = size;
  return spot;
}

std::vector<Spot> spots_of(const SurfaceSketch& sketch, VariantKey key = {}) {
  const Template made = fruit({sketch});
  return placed_spots(made, sketch, SideOf::front, swept_grids(made, sketch, {}), {.key = key});
}

TEST(Spots, a_patch_lies_at_its_place) {
  for (const double degrees : {0.0, 3.0, 120.0, 359.5, -45.0}) {
    for (const double along : {0.0, 0.013, 0.5, 0.7, 1.0}) {
      SurfaceSketch sketch = ball();
      sketch.front.spots = {patch(along, degrees, 0.01)};
      const std::vector<Spot> spots = spots_of(sketch);
      ASSERT_EQ(spots.size(), 1u);
      const double angle = pi * along;
      const glm::dvec3 out(reproducible::sin(angle) * reproducible::cos(radians(degrees)), -reproducible::cos(angle),
                           -reproducible::sin(angle) * reproducible::sin(radians(degrees)));
      EXPECT_LT(glm::distance(spots[0].center, glm::dvec3(0, 0.04, 0) + 0.04 * out), 2e-4);
      EXPECT_GT(glm::dot(spots[0].normal, out), 0.999);
      EXPECT_NEAR(glm::dot(spots[0].normal, spots[0].tangent), 0, 1e-9);
      EXPECT_NEAR(glm::length(spots[0].tangent), 1, 1e-9);
      if (along > 0.1 && along < 0.9) {
        EXPECT_GT(spots[0].tangent.y, 0);
      }
    }
  }
}

TEST(Spots, a_patch_covers_what_is_near_it_and_nothing_else) {
  SurfaceSketch sketch = ball();
  sketch.front.spots = {patch(0.5, 90, 0.04)};
  const DiffusionSurfaces swept = sweep(fruit({sketch}));
  const glm::vec3 center(0, 0.04f, -0.04f);
  for (std::size_t v = 0; v < swept.vertex_count(); ++v) {
    const double far = glm::distance(swept.position[v], center);
    EXPECT_TRUE(is_between(swept.front_color[v], ground, paint));
    if (far > 0.0201) {
      EXPECT_EQ(swept.front_color[v], ground);
    }
    if (far < 0.009) {
      EXPECT_EQ(swept.front_color[v], paint);
    }
    EXPECT_EQ(swept.back_color[v], Color(0.9f, 0.8f, 0.6f));
  }
}

TEST(Spots, distance_is_nearly_that_over_the_surface_and_does_not_reach_through) {
  Spot spot;
  spot.center = {0, 1, 0};
  spot.radius = pi / 3;
  spot.softness = 1;
  for (int i = 1; i < 18; ++i) {
    const double angle = pi / 36 * i;
    const glm::dvec3 at(reproducible::sin(angle), reproducible::cos(angle), 0);
    const double share = std::min(1.0, angle / spot.radius), left = 1 - share;
    EXPECT_NEAR(cover_of(spot, at, at), left * left * (3 - 2 * left), 0.08);
  }
  EXPECT_EQ(cover_of(spot, {0, 0.999, 0}, {0, -1, 0}), 0);
  EXPECT_EQ(cover_of(spot, {0, 0.999, 0}, {0, 1, 0}) > 0.99, true);
}

TEST(Spots, softness_strength_stretch_and_raggedness_do_what_they_say) {
  Spot spot;
  spot.radius = 1;
  spot.strength = 0.6;
  const auto cover = [&](double x, double z) { return cover_of(spot, {x, 0, z}, {0, 1, 0}); };
  EXPECT_DOUBLE_EQ(cover(0.99, 0), 0.6);
  EXPECT_EQ(cover(1.01, 0), 0);
  spot.softness = 0.5;
  EXPECT_DOUBLE_EQ(cover(0.49, 0), 0.6);
  EXPECT_NEAR(cover(0.75, 0), 0.3, 1e-12);
  spot.softness = 0;
  spot.stretch = 3;  // along the tangent, +X
  EXPECT_DOUBLE_EQ(cover(2.9, 0), 0.6);
  EXPECT_EQ(cover(0, 1.1), 0);
  spot.stretch = 1;

  // For every draw, the rim is as near to the circle as its raggedness allows.
  SurfaceSketch sketch = ball();
  SpotSketch ragged = scattered(0.008, 0.004);
  ragged.raggedness = 0.6;
  sketch.front.spots = {ragged};
  for (const Spot& drawn : spots_of(sketch)) {
    double sum = 0;
    for (const glm::dvec2& wave : drawn.waves) sum += glm::length(wave);
    EXPECT_NEAR(sum, 0.6, 1e-9);
    spot.waves = drawn.waves;
    EXPECT_GT(cover(0, 0), 0);
    int inside = 0;
    for (int i = 0; i < 90; ++i) {
      const double angle = 2 * pi * i / 90, x = reproducible::cos(angle), z = reproducible::sin(angle);
      EXPECT_GT(cover(0.39 * x, 0.39 * z), 0);
      EXPECT_EQ(cover(1.61 * x, 1.61 * z), 0);
      inside += cover(x, z) > 0 ? 1 : 0;
    }
    EXPECT_GT(inside, 5);
    EXPECT_LT(inside, 85);
  }
}

TEST(Spots, scattered_ones_keep_their_spacing_and_band_and_count) {
  SurfaceSketch sketch = ball();
  SpotSketch spot = scattered(0.005, 0.002);
  spot.size_max = 0.003;
  sketch.front.spots = {spot};
  const std::vector<Spot> all = spots_of(sketch);
  // A full surface has between half and all of the spots of a hexagonal packing of the ball's surface.
  const double max = 4 * pi * 0.04 * 0.04 / (0.005 * 0.005 * std::sqrt(3.0) / 2);
  EXPECT_GT(static_cast<double>(all.size()), 0.5 * max);
  EXPECT_LT(static_cast<double>(all.size()), max);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_GE(all[i].radius, 0.001);
    EXPECT_LE(all[i].radius, 0.0015);
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE(glm::distance(all[i].center, all[j].center), 0.005);
  }

  sketch.front.spots[0].count = 12;
  EXPECT_EQ(spots_of(sketch).size(), 12u);
  sketch.front.spots[0].count = 0;
  sketch.front.spots[0].along_from = 0.5;
  sketch.front.spots[0].along_to = 0.75;
  for (const Spot& one : spots_of(sketch)) {
    EXPECT_GE(one.center.y, 0.04 - 1e-4);
    EXPECT_LE(one.center.y, 0.04 + 0.04 * std::sqrt(0.5) + 1e-4);
  }
}

TEST(Spots, colours_stay_between_ground_and_paint) {
  SurfaceSketch sketch = ball();
  sketch.front.spots = {scattered(0.006, 0.006), scattered(0.004, 0.005)};
  sketch.front.spots[0].raggedness = 0.9;
  sketch.front.spots[1].strength = 0.4;
  std::size_t touched = 0;
  for (const Color& color : sweep(fruit({sketch})).front_color) {
    EXPECT_TRUE(is_between(color, ground, paint));
    touched += color != ground ? 1 : 0;
  }
  EXPECT_GT(touched, 1000u);
}

TEST(Spots, they_lie_elsewhere_in_other_variants_and_nowhere_else_in_the_same) {
  SurfaceSketch sketch = ball();
  sketch.front.spots = {scattered(0.008, 0.004)};
  sketch.back.spots = sketch.front.spots;
  const Template made = fruit({sketch});
  const DiffusionSurfaces drawn = sweep(made), again = sweep(made, {.key = {0, 0}});
  EXPECT_EQ(drawn.front_color, again.front_color);
  EXPECT_NE(drawn.front_color, sweep(made, {.key = {1, 0}}).front_color);
  EXPECT_NE(drawn.front_color, sweep(made, {.key = {0, 1}}).front_color);

  // Front and back are strewn independently, and so are two kinds on one side.
  const auto centers = [&](SideOf side) {
    std::vector<glm::dvec3> found;
    for (const Spot& spot : placed_spots(made, sketch, side, swept_grids(made, sketch, {}), {})) {
      found.push_back(spot.center);
    }
    return found;
  };
  EXPECT_NE(centers(SideOf::front), centers(SideOf::back));
}

TEST(Spots, chambers_are_strewn_all_over) {
  std::vector<Curve> loops;
  for (int k = 0; k < 3; ++k) {
    const double middle = 2 * pi * (k + 0.5) / 3;
    loops.push_back(circle_at(0.03 * glm::dvec2(reproducible::cos(middle), reproducible::sin(middle)), 0.012));
  }
  SurfaceSketch chamber = in_fold(circle_at({0.03, 0.04}, 0.012), loops);
  chamber.front.spots = {scattered(0.005, 0.006)};
  const DiffusionSurfaces swept = sweep(fruit({chamber}, 3));
  const std::size_t each = swept.vertex_count() / 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto first = swept.front_color.begin() + static_cast<std::ptrdiff_t>(k * each);
    EXPECT_GT(std::count_if(first, first + static_cast<std::ptrdiff_t>(each),
                            [](const Color& c) { return glm::distance(c, paint) < 0.1f; }),
              10);
  }
}

std::string refusal(const SpotSketch& spots) {
  SurfaceSketch sketch = ball();
  sketch.front.spots = {spots};
  try {
    sweep(fruit({sketch}));
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    return error.what();
  }
  return "none";
}

TEST(Spots, what_would_take_too_long_is_refused) {
  std::string said = refusal(scattered(0.0001, 0.001));
  EXPECT_NE(said.find("surface \"skin\": front has more than 20 000 spots"), std::string::npos) << said;
  said = refusal(scattered(0.002, 1));
  EXPECT_NE(said.find("surface \"skin\": front has more than 2 000 spots over one another"), std::string::npos) << said;
  EXPECT_EQ(refusal(scattered(0.002, 0.004)), "none");
}

TEST(Spots, what_is_smaller_than_the_cells_is_warned_of) {
  SurfaceSketch sketch = ball();
  sketch.front.spots = {scattered(0.01, 0.006)};
  EXPECT_TRUE(spot_warnings(fruit({sketch})).empty());
  sketch.front.spots[0].size_min = 0.001;
  const std::vector<std::string> warnings = spot_warnings(fruit({sketch}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "surface \"skin\": front has spots 1 mm wide, but up to 3.7 mm between vertices: some will be lost; raise "
            "\"around\" and \"along\"");
}

TEST(Spots, those_with_relief_lie_where_they_are_painted_and_look_to_the_air) {
  SurfaceSketch sketch = ball();
  SpotSketch flat = scattered(0.011, 0.004), raised = scattered(0.009, 0.005);
  raised.relief = 0.0003;
  raised.raggedness = 0.7;
  raised.softness = 0.1;
  raised.strength = 0.2;
  sketch.front.spots = {flat, raised};
  raised.relief = -0.0002;
  sketch.back.spots = {raised};
  const Template made = fruit({sketch});
  const std::vector<SweptGrid> grids = swept_grids(made, sketch, {});
  std::vector<Spot> painted;
  for (const SideOf side : {SideOf::front, SideOf::back}) {
    for (const Spot& spot : placed_spots(made, sketch, side, grids, {}))
      if (spot.relief != 0) painted.push_back(spot);
  }
  const std::vector<Spot> all = swept_fruit(made).raised;
  ASSERT_EQ(all.size(), painted.size());
  ASSERT_GT(all.size(), 100u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double side = all[i].relief > 0 ? 1 : -1;
    EXPECT_EQ(all[i].center, painted[i].center);
    EXPECT_EQ(all[i].normal, side * painted[i].normal);
    EXPECT_EQ(all[i].strength, 1);
    EXPECT_EQ(all[i].softness, 0.4) << "no cliffs";
    Spot as_painted = painted[i];
    as_painted.strength = 1;
    as_painted.softness = 0.4;
    for (int k = 0; k < 12; ++k) {
      const double angle = 2 * pi * k / 12;
      const glm::dvec3 beside =
          all[i].center + 0.002 * (reproducible::cos(angle) * painted[i].tangent +
                                   reproducible::sin(angle) * glm::cross(painted[i].normal, painted[i].tangent));
      EXPECT_DOUBLE_EQ(cover_of(all[i], beside, all[i].normal), cover_of(as_painted, beside, painted[i].normal));
    }
  }
  sketch.front.spots = {flat};
  sketch.back.spots = {};
  EXPECT_TRUE(swept_fruit(fruit({sketch})).raised.empty());
}

TEST(Spots, more_detail_shows_the_same_ones) {
  SurfaceSketch sketch = ball();
  sketch.front.spots = {scattered(0.009, 0.005)};
  sketch.front.spots[0].relief = 0.0003;
  const Template made = fruit({sketch});
  const std::vector<Spot> usual = swept_fruit(made).raised, fine = swept_fruit(made, {.detail = 2.5}).raised;
  ASSERT_EQ(fine.size(), usual.size());
  for (std::size_t i = 0; i < usual.size(); ++i) {
    EXPECT_EQ(fine[i].center, usual[i].center);
    EXPECT_EQ(fine[i].radius, usual[i].radius);
  }
}

TEST(Spots, any_thread_gives_the_same_bits) {
  SurfaceSketch sketch = ball();
  sketch.front.spots = {scattered(0.008, 0.004)};
  sketch.front.spots[0].raggedness = 0.5;
  const Template made = fruit({sketch});
  const DiffusionSurfaces one = sweep(made, {.key = {7, 3}});
  std::vector<DiffusionSurfaces> many(6);
  parallel_for(many.size(), {3}, [&](std::size_t i) { many[i] = sweep(made, {.key = {7, 3}}); });
  for (const DiffusionSurfaces& other : many) EXPECT_EQ(one.front_color, other.front_color);
}

}  // namespace
}  // namespace pomona
