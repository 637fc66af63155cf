// A peel in a strip hangs with its turns apart; other pieces do not change.
#include "generator/scene/hanging_peel.h"
#include "generator/mesh/moments.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/knife/parse_knife.h"
#include "generator/mesh/box.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "generator/scene/lay_out.h"
#include "tests/shapes/shapes.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

std::vector<Solid> pieces_of(const std::vector<std::string>& words) {
  std::vector<Knife> knives;
  for (const std::string& word : words) knives.push_back(parse_knife(word));
  return shapes::sliced(shapes::moved(shapes::sphere(0.03, 8, shapes::skin_paint()), {0, 0.03, 0}), knives).pieces;
}

double volume_of(const Solid& solid) { return moments_of(solid.mesh.position, solid.mesh.triangle, {}).mass; }

Box<double> bounds_of(const Solid& solid) {
  Box<double> box;
  for (const glm::vec3& p : solid.mesh.position) box.add(glm::dvec3(p));
  return box;
}

/// The piece of a ball that hangs.
struct Peel {
  Solid lying, hanging;
  int count = 0;  ///< number of pieces that hang
};
/// Peeled once for all tests, because a strip takes seconds.
const std::vector<Solid>& peeled_ball() {
  static const std::vector<Solid> pieces = pieces_of({"peel:2mm,spiral=16mm"});
  return pieces;
}

Peel peel_of_ball() {
  Peel peel;
  for (const Solid& piece : peeled_ball()) {
    const std::optional<Solid> hung = hanging_peel(piece);
    if (!hung) continue;
    peel.lying = piece, peel.hanging = *hung;
    ++peel.count;
  }
  return peel;
}

TEST(HangingPeel, IsTheStripAlone) {
  EXPECT_EQ(peel_of_ball().count, 1);
  for (const char* other : {"half", "slices:8mm", "core:12mm", "peel:2mm", "ball:30mm,at=0,6cm,0"}) {
    for (const Solid& piece : pieces_of({other})) EXPECT_FALSE(hanging_peel(piece)) << other << ' ' << piece.name;
  }
}

/// A ball with a chamber beside its axis, as in an apple: a half-plane through the chamber cuts it into two areas.
DiffusionSurfaces ball_with_a_chamber(const glm::dvec3& chamber) {
  DiffusionSurfaces ball = shapes::hollow_ball(0.03, 0.005, 8);
  for (glm::vec3& p : ball.position) {
    const bool is_wall = glm::length(p) < 0.01f;
    p += glm::vec3(glm::dvec3(0, 0.03, 0) + (is_wall ? chamber : glm::dvec3(0)));
  }
  return ball;
}

/// Two areas in a half-plane do not yet mean that a piece winds about the axis twice.
TEST(HangingPeel, IsNothingThatIsOnlyParted) {
  for (const glm::dvec3& chamber :
       {glm::dvec3(0.01, 0, 0), glm::dvec3(0.003, 0.006, 0.009), glm::dvec3(0, 0.01, -0.01)}) {
    const DiffusionSurfaces ball = ball_with_a_chamber(chamber);
    for (const char* knife : {"bite:30mm", "ball:20mm,at=0,3cm,3cm", "core:12mm", "peel:2mm"}) {
      const std::vector<Knife> knives{parse_knife(knife)};
      for (const Solid& piece : shapes::sliced(ball, knives).pieces)
        EXPECT_FALSE(hanging_peel(piece)) << knife << ' ' << piece.name << ", chamber at " << chamber.x;
    }
  }
}

TEST(HangingPeel, IsLongerAndStaysClosedAndAsLarge) {
  const auto [lying, hanging, count] = peel_of_ball();
  ASSERT_EQ(count, 1);
  EXPECT_GT(bounds_of(hanging).size().y, 1.4 * bounds_of(lying).size().y);
  EXPECT_NEAR(volume_of(hanging), volume_of(lying), 0.03 * volume_of(lying));
  EXPECT_TRUE(is_closed(welded_triangles(weld(lying.mesh.position), lying.mesh.triangle)));
  EXPECT_TRUE(is_closed(welded_triangles(weld(hanging.mesh.position), hanging.mesh.triangle)));
}

/// Edges keep their lengths, apart from the small stretch of a longer helix.
TEST(HangingPeel, IsHardlyStretched) {
  const auto [lying, hanging, count] = peel_of_ball();
  ASSERT_EQ(count, 1);
  double before = 0, after = 0;
  for (const glm::uvec3& t : lying.mesh.triangle) {
    before += glm::distance(lying.mesh.position[t.x], lying.mesh.position[t.y]);
    after += glm::distance(hanging.mesh.position[t.x], hanging.mesh.position[t.y]);
  }
  EXPECT_NEAR(after, before, 0.05 * before);
}

TEST(HangingPeel, HasTheNormalsOfItsSurface) {
  const Solid hanging = peel_of_ball().hanging;
  double wrong = 0, all = 0;
  for (const glm::uvec3& t : hanging.mesh.triangle) {
    const glm::dvec3 a(hanging.mesh.position[t.x]), b(hanging.mesh.position[t.y]), c(hanging.mesh.position[t.z]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const glm::dvec3 mean(hanging.mesh.normal[t.x] + hanging.mesh.normal[t.y] + hanging.mesh.normal[t.z]);
    all += glm::length(area);
    if (glm::dot(area, mean) < 0.9 * glm::length(area) * glm::length(mean)) wrong += glm::length(area);
  }
  EXPECT_GT(all, 0);
  EXPECT_LT(wrong, 0.03 * all);
}

/// In a picture it hangs upright on the table beside the ball.
TEST(HangingPeel, HangsInPictures) {
  const Scene in_place = gathered(peeled_ball());
  const Scene table = laid_out(in_place);
  ASSERT_EQ(table.instances.size(), 2u);
  double tallest = 0;
  for (const Instance& instance : table.instances) {
    const Solid& solid = table.solids[static_cast<std::size_t>(instance.solid)];
    Box<double> box;
    for (const glm::vec3& p : solid.mesh.position)
      box.add(instance.pose.rotation * glm::dvec3(p) + instance.pose.translation);
    EXPECT_NEAR(box.low.y, 0, 1e-9);
    tallest = std::max(tallest, box.size().y);
    EXPECT_NEAR((instance.pose.rotation * glm::dvec3(0, 1, 0)).y, 1, 1e-6) << "as it grew";
  }
  EXPECT_GT(tallest, 1.4 * 0.06);
}

}  // namespace
}  // namespace pomona
