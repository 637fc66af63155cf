// Cells of laws on a skin: where they begin and end, what they raise and paint, and that a skin stays one shell.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/surface/bodies.h"
#include "generator/surface/crossings.h"
#include "generator/surface/sweep/cells.h"
#include "generator/surface/sweep/grid_place.h"
#include "generator/surface/sweep/law_seats.h"
#include "generator/surface/sweep/surface_grids.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/variation/scaled.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;

const Color red(0.8f, 0.1f, 0.1f);

Template eyed_ball(double raise, double cover = 0) {
  Template ball = fruit({around_axis(meridian(0.04), circle(0.04))});
  LawSketch law;
  law.name = "eyes";
  law.kind = LawSketch::Kind::parastichies;
  law.low_pair = 5, law.high_pair = 8;
  ball.laws = {law};
  SurfaceSketch& skin = ball.surfaces[0];
  skin.around = 120, skin.along = 80;
  skin.front.hidden = true;
  CellSketch cells;
  cells.color = Ramp<Color>::constant(red);
  cells.cover = {{{0.0, 0.0}, {1.0, cover}}};
  cells.raise = {{{0.0, raise}, {0.7, 0.5 * raise}, {1.0, 0.0}}};
  skin.front.cells = cells;
  return ball;
}

Template without_cells(Template fruit) {
  fruit.surfaces[0].front.cells.reset();
  return fruit;
}

const SurfaceSketch& skin_of(const Template& ball) { return ball.surfaces[0]; }

TEST(Cells, APlaceIsZeroAtASeatAndOneBetweenTwo) {
  const std::vector<glm::dvec3> seats{{0, 0, 0}, {2, 0, 0}, {9, 0, 0}};
  const std::vector<glm::dvec3> places{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {1, 5, 3}};
  const std::vector<double> found = cell_places(places, seats);
  EXPECT_EQ(found, (std::vector<double>{0, 0, 1, 0.5, 1}));
}

TEST(Cells, TheTwoNearestSeatsAreThoseOfAllSeats) {
  const Template ball = eyed_ball(0);
  const SweptGrid grid = swept_grids(ball, skin_of(ball), {}).front();
  const GridPlaces places(grid);
  std::vector<glm::dvec3> seats;
  for (const LawSeat& seat : law_seats(ball.laws[0], skin_of(ball).vertical, law_draws(ball.laws[0], {})))
    seats.push_back(places.at(seat.along, seat.azimuth).position);
  ASSERT_GT(seats.size(), 40u);
  ASSERT_EQ(grid.front_cell.size(), grid.position.size());
  EXPECT_TRUE(grid.back_cell.empty());
  for (std::size_t v = 0; v < grid.position.size(); ++v) {
    std::vector<double> far;
    for (const glm::dvec3& seat : seats) far.push_back(glm::distance(seat, grid.position[v]));
    std::sort(far.begin(), far.end());
    EXPECT_NEAR(grid.front_cell[v], 2 * far[0] / (far[0] + far[1]), 1e-12);
  }
}

TEST(Cells, RaiseTheSkinAndLeaveItOneClosedShellWithoutCrossings) {
  for (const double raise : {0.003, -0.003}) {
    const DiffusionSurfaces plain = sweep(without_cells(eyed_ball(0))), raised = sweep(eyed_ball(raise));
    EXPECT_EQ(raised.triangle, plain.triangle);
    EXPECT_TRUE(crossing_triangles(raised).empty());
    const Bodies before = find_bodies(plain), after = find_bodies(raised);
    ASSERT_EQ(after.bodies.size(), 1u);
    EXPECT_TRUE(after.bodies[0].closed);
    EXPECT_EQ(after.bodies[0].shells, 1);
    EXPECT_GT((after.bodies[0].volume - before.bodies[0].volume) * raise, 0);
    double farthest = 0;
    for (std::size_t v = 0; v < plain.position.size(); ++v)
      farthest = std::max(farthest, static_cast<double>(glm::distance(plain.position[v], raised.position[v])));
    EXPECT_NEAR(farthest, 0.003, 2e-4) << "some vertex is near a seat";
    EXPECT_LE(farthest, 0.003 + 1e-8);
  }
}

TEST(Cells, OfTheBackRaiseInwards) {
  Template ball = eyed_ball(0.002);
  std::swap(ball.surfaces[0].front.cells, ball.surfaces[0].back.cells);
  const double plain = find_bodies(sweep(without_cells(eyed_ball(0)))).bodies[0].volume;
  EXPECT_LT(find_bodies(sweep(ball)).bodies[0].volume, plain);
}

TEST(Cells, PaintBordersAndLeaveMiddles) {
  const Template ball = eyed_ball(0, 1);
  const DiffusionSurfaces painted = sweep(ball), plain = sweep(without_cells(ball));
  const SweptGrid grid = swept_grids(ball, skin_of(ball), {}).front();
  for (std::size_t v = 0; v < painted.vertex_count(); ++v) {
    const Color expected = blended(plain.front_color[v], red, grid.front_cell[v]);
    EXPECT_LT(glm::distance(painted.front_color[v], expected), 1e-5f);
    EXPECT_EQ(painted.back_color[v], plain.back_color[v]);
  }
}

TEST(Cells, FadeAlong) {
  Template ball = eyed_ball(0.003, 1);
  ball.surfaces[0].front.cells->along = {{{0.0, 0.0}, {0.5, 0.0}, {0.6, 1.0}}};
  const DiffusionSurfaces faded = sweep(ball), plain = sweep(without_cells(ball));
  for (std::size_t v = 0; v < plain.vertex_count(); ++v) {
    if (plain.position[v].y > 0.0399f) continue;
    EXPECT_EQ(faded.position[v], plain.position[v]);
    EXPECT_EQ(faded.front_color[v], plain.front_color[v]);
  }
}

TEST(Cells, ThatDoNothingChangeNoBit) {
  const Template ball = eyed_ball(0, 0);
  const DiffusionSurfaces with = sweep(ball, {.key = {3, 1}}), without = sweep(without_cells(ball), {.key = {3, 1}});
  EXPECT_EQ(with.position, without.position);
  EXPECT_EQ(with.front_color, without.front_color);
  EXPECT_EQ(with.back_color, without.back_color);
  EXPECT_EQ(with.triangle, without.triangle);
}

TEST(Cells, FollowTheJitterOfTheirLawAndKeepTheTriangles) {
  Template ball = eyed_ball(0.002);
  ball.laws[0].jitter = 0.2;
  const DiffusionSurfaces one = sweep(ball, {.key = {1, 0}}), two = sweep(ball, {.key = {2, 0}});
  EXPECT_NE(one.position, two.position);
  EXPECT_EQ(one.triangle, two.triangle);
  EXPECT_EQ(sweep(ball, {.key = {1, 0}}).position, one.position);
}

TEST(Cells, GrowWithTheFruit) {
  const Template ball = eyed_ball(0.003);
  const DiffusionSurfaces one = sweep(ball), two = sweep(scaled(ball, 2));
  for (std::size_t v = 0; v < one.vertex_count(); ++v)
    EXPECT_LT(glm::distance(2.0f * one.position[v], two.position[v]), 1e-6f);
}

TEST(Cells, SeatsLieOnTheRaisedSkin) {
  const Template ball = eyed_ball(0.003);
  const SweptGrid grid = swept_grids(ball, skin_of(ball), {}).front();
  const std::vector<LawSeat> seats = law_seats(ball.laws[0], skin_of(ball).vertical, law_draws(ball.laws[0], {}));
  const LawSeat& seat = seats[seats.size() / 2];  // of the widest
  const glm::dvec3 place = point_at(grid, seat.along, seat.azimuth).position;
  EXPECT_NEAR(glm::distance(place, glm::dvec3(0, 0.04, 0)), 0.043, 4e-4);
}

TEST(Cells, NeedTwoSeats) {
  Template ball = eyed_ball(0.002);
  ball.laws[0].kind = LawSketch::Kind::spiral;
  ball.laws[0].spacing = Ramp<double>::constant(0.5);
  try {
    sweep(ball);
    FAIL() << "one cell is none";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("fewer than two seats"), std::string::npos) << error.what();
  }
  ball.laws[0].spacing = Ramp<double>::constant(0.0002);
  EXPECT_THROW(sweep(ball), Error) << "more than 20 000";
}

}  // namespace
}  // namespace pomona
