// Where laws seat grains and spots: on named lattices, as many on every variant, and where the drawing says.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/surface/grains/grains.h"
#include "generator/surface/sweep/grid_place.h"
#include "generator/surface/sweep/law_seats.h"
#include "generator/surface/sweep/spots.h"
#include "generator/surface/sweep/surface_grids.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;
using Kind = LawSketch::Kind;

constexpr double golden = 2.39996322972865332;

/// A cylinder without ends: 20 cm high, 4 cm thick.
Curve wall() { return {{{0.02, 0}, {0.02, 0.1}, {0.02, 0.2}}, false}; }

LawSketch law(Kind kind, double spacing = 0.005) {
  LawSketch made;
  made.name = "seats";
  made.kind = kind;
  made.spacing = Ramp<double>::constant(spacing);
  return made;
}

std::vector<LawSeat> seats_of(const LawSketch& law, VariantKey key = {}) {
  return law_seats(law, wall(), law_draws(law, key));
}

double beside(double angle) { return std::fabs(beside_whole_turns(angle)); }

/// On the unrolled cylinder.
double distance(const LawSeat& a, const LawSeat& b) {
  return glm::length(glm::dvec2(0.2 * (a.along - b.along), 0.02 * beside(a.azimuth - b.azimuth)));
}

TEST(LawSeats, ASpiralTurnsByItsDivergenceAndSharesTheArea) {
  const std::vector<LawSeat> seats = seats_of(law(Kind::spiral));
  const double area = 2 * pi * 0.02 * 0.2, each = 0.005 * 0.005 * std::sqrt(3) / 2;
  EXPECT_NEAR(static_cast<double>(seats.size()), area / each, 1);
  for (std::size_t k = 1; k < seats.size(); ++k) {
    EXPECT_NEAR(beside(seats[k].azimuth - seats[k - 1].azimuth - golden), 0, 1e-9);
    EXPECT_NEAR((seats[k].along - seats[k - 1].along) * area, each, 1e-6 * each);
  }
}

TEST(LawSeats, ALatticeHasStepsOfOneLengthInBothItsFamilies) {
  for (const auto& [low, high] : {std::pair(5, 8), {8, 13}, {13, 21}}) {
    LawSketch made = law(Kind::parastichies);
    made.low_pair = low, made.high_pair = high;
    const std::vector<LawSeat> seats = seats_of(made);
    ASSERT_GT(seats.size(), 40u);
    const auto m = static_cast<std::size_t>(low), n = static_cast<std::size_t>(high);
    const double step = distance(seats[0], seats[m]);
    EXPECT_NEAR(distance(seats[0], seats[n]), step, 1e-6);
    EXPECT_NEAR(seats[0].spacing, step, 1e-6);
    // None is nearer.
    for (std::size_t k = 1; k < seats.size(); ++k) EXPECT_GT(distance(seats[0], seats[k]), step - 1e-6) << k;
  }
}

TEST(LawSeats, RowsRunUpAndEverySecondIsShifted) {
  LawSketch made = law(Kind::rows, 0.01);
  made.count = 6;
  made.start = 0.3;
  const std::vector<LawSeat> seats = seats_of(made);
  std::vector<std::vector<double>> row(6);
  for (const LawSeat& seat : seats) {
    const double place = beside_whole_turns(seat.azimuth - made.start) / (2 * pi / 6);
    EXPECT_NEAR(place, std::round(place), 1e-9);
    row[static_cast<std::size_t>(static_cast<int>(std::lround(place) + 6) % 6)].push_back(0.2 * seat.along);
  }
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(row[k][0], k % 2 == 0 ? 0.005 : 0.01, 1e-5);
    for (std::size_t i = 1; i < row[k].size(); ++i) EXPECT_NEAR(row[k][i] - row[k][i - 1], 0.01, 1e-5);
  }
}

TEST(LawSeats, RowsTwistOverTheirBand) {
  LawSketch made = law(Kind::rows, 0.01);
  made.from = 0.25, made.to = 0.75;
  made.twist = pi;
  for (const LawSeat& seat : seats_of(made)) {
    EXPECT_GE(seat.along, 0.25);
    EXPECT_LE(seat.along, 0.75);
    EXPECT_NEAR(seat.azimuth, 2 * pi * (seat.along - 0.25), 1e-9);
  }
}

TEST(LawSeats, WhorlsTurnEachFurther) {
  LawSketch made = law(Kind::whorls, 0.02);
  made.count = 2;
  made.turn = pi / 2;  // decussate, as a nettle's leaves
  const std::vector<LawSeat> seats = seats_of(made);
  ASSERT_EQ(seats.size(), 20u);
  for (std::size_t k = 0; k < seats.size(); ++k) {
    EXPECT_NEAR(seats[k].along, 0.1 * static_cast<double>(k / 2) + 0.05, 1e-4);
    EXPECT_NEAR(beside(seats[k].azimuth - pi * static_cast<double>(k % 2) - pi / 2 * static_cast<double>(k / 2)), 0,
                1e-9);
  }
}

TEST(LawSeats, JitterMovesSeatsByItsShareAtMostAndKeepsTheirNumber) {
  LawSketch made = law(Kind::spiral);
  const std::vector<LawSeat> even = seats_of(made);
  made.jitter = 0.3;
  const std::vector<LawSeat> one = seats_of(made, {1, 0}), two = seats_of(made, {2, 0});
  ASSERT_EQ(one.size(), even.size());
  ASSERT_EQ(two.size(), even.size());
  double farthest = 0, apart = 0;
  for (std::size_t k = 0; k < even.size(); ++k) {
    farthest = std::max(farthest, distance(one[k], even[k]));
    apart = std::max(apart, distance(one[k], two[k]));
  }
  EXPECT_LE(farthest, std::sqrt(2) * 0.3 * 0.005 + 1e-9);
  EXPECT_GT(apart, 0.001);
}

TEST(LawSeats, ADiscsLatticeEndsBeforeItsMiddle) {
  // Towards a pole seats shrink with the girth; without a least girth they would be without end.
  LawSketch made = law(Kind::parastichies);
  EXPECT_LT(law_room(made, meridian(0.04)), 5000);
  EXPECT_GT(law_room(made, meridian(0.04)), 50);
}

GrainSketch grains_of_law() {
  GrainSketch sketch;
  sketch.name = "seeds";
  sketch.spacing.law = 0;
  sketch.form.length = sketch.form.width = sketch.form.thickness = 0.002;
  sketch.front = {0, {Ramp<Color>::constant(Color(0.9f, 0.8f, 0.5f))}, false};
  sketch.back = {1, {Ramp<Color>::constant(Color(1))}, false};
  return sketch;
}

Template seeded_ball() {
  Template ball = fruit({around_axis(meridian(0.04), loop([](double a) { return 1 + 0.1 * std::cos(3 * a); }))});
  ball.laws = {law(Kind::spiral, 0.006)};
  ball.grains = {grains_of_law()};
  return ball;
}

TEST(GrainsOfALaw, SitOnTheSurfaceAtItsSeats) {
  const Template ball = seeded_ball();
  const SweptGrid grid = swept_grids(ball, ball.surfaces[0], {}).front();
  const std::vector<LawSeat> seats =
      law_seats(ball.laws[0], ball.surfaces[0].vertical, law_draws(ball.laws[0], {5, 0}));
  const std::vector<Dart> darts =
      seated_darts(ball.laws[0], ball.surfaces[0].vertical, grid, ball.grains[0], grain_draws({5, 0}, "seeds"), {5, 0});
  ASSERT_EQ(darts.size(), seats.size());
  for (std::size_t k = 0; k < darts.size(); ++k) {
    const GridPoint point = point_at(grid, seats[k].along, seats[k].azimuth);
    EXPECT_EQ(darts[k].center, point.position);
    EXPECT_EQ(darts[k].normal, point.normal);
    EXPECT_NEAR(glm::dot(darts[k].tangent, darts[k].normal), 0, 1e-9);
  }
}

TEST(GrainsOfALaw, AreAsManyOnEveryVariant) {
  Template ball = seeded_ball();
  ball.laws[0].jitter = 0.2;
  const std::size_t drawn = scatter_grains(ball, {}).triangle_count();
  EXPECT_GT(drawn, 0u);
  ball.surfaces[0].reference = reference_radii(ball.surfaces[0]);
  for (glm::dvec2& p : ball.surfaces[0].horizontal[0].points) p.x *= 1.15;
  for (std::uint64_t seed = 1; seed < 4; ++seed) EXPECT_EQ(scatter_grains(ball, {seed, 0}).triangle_count(), drawn);
}

TEST(GrainsOfALaw, TakeBandShareAndSizeAlong) {
  Template ball = seeded_ball();
  GrainSketch& seeds = ball.grains[0];
  const auto darts = [&] {
    const SweptGrid grid = swept_grids(ball, ball.surfaces[0], {}).front();
    return seated_darts(ball.laws[0], ball.surfaces[0].vertical, grid, seeds, grain_draws({5, 0}, "seeds"), {5, 0});
  };
  const std::size_t all = darts().size();
  seeds.ground.along_from = 0.5;
  seeds.form.size = {{{0.5, 1}, {1, 0.2}}};
  const std::vector<Dart> upper = darts();
  EXPECT_NEAR(static_cast<double>(upper.size()), 0.5 * static_cast<double>(all), 0.02 * static_cast<double>(all));
  for (const Dart& dart : upper) {
    EXPECT_GE(dart.along, 0.5);
    EXPECT_NEAR(glm::length(dart.pose.length), 0.001 * (1 - 1.6 * (dart.along - 0.5)), 1e-9);
  }
  seeds.ground.density_along = Ramp<double>::constant(0.25);
  EXPECT_NEAR(static_cast<double>(darts().size()), 0.25 * static_cast<double>(upper.size()),
              0.08 * static_cast<double>(upper.size()));
}

TEST(GrainsOfALaw, MoreThanTwentyThousandAreRefused) {
  Template ball = seeded_ball();
  ball.laws[0].spacing = Ramp<double>::constant(1e-4);
  EXPECT_THROW(scatter_grains(ball, {}), Error);
}

TEST(SpotsOfALaw, LieAtItsSeats) {
  Template ball = seeded_ball();
  SpotSketch spots;
  spots.law = 0;
  spots.size_min = spots.size_max = 0.004;
  ball.surfaces[0].front.spots = {spots};
  const std::vector<SweptGrid> grids = swept_grids(ball, ball.surfaces[0], {});
  const std::vector<Spot> placed = placed_spots(ball, ball.surfaces[0], SideOf::front, grids, {});
  const std::vector<LawSeat> seats = law_seats(ball.laws[0], ball.surfaces[0].vertical, law_draws(ball.laws[0], {}));
  ASSERT_EQ(placed.size(), seats.size());
  for (std::size_t k = 0; k < seats.size(); ++k)
    EXPECT_EQ(placed[k].center, point_at(grids.front(), seats[k].along, seats[k].azimuth).position);
}

}  // namespace
}  // namespace pomona
