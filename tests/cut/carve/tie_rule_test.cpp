// Compares signs of the tie rule with those of a knife that is moved.
#include "generator/mesh/crossings/tie_rule.h"

#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "tests/cut/carve/moved_knife.h"

namespace pomona {
namespace {

using shapes::at_rest;
using shapes::moved;
using shapes::sign_of_volume;

/// Whole coordinates, so small that most draws are ties.
class SmallPlaces {
 public:
  glm::dvec3 next() {
    const glm::dvec3 place(coordinate(0), coordinate(1), coordinate(2));
    drawn_ += 3;
    return place;
  }

 private:
  double coordinate(std::uint64_t n) const { return static_cast<double>(random_.below(drawn_ + n, 3)); }
  RandomStream random_{{}, "tests/tie rule"};
  std::uint64_t drawn_ = 0;
};

bool has_area(const Corners& t) { return glm::cross(t[1] - t[0], t[2] - t[0]) != glm::dvec3(0); }

TEST(TieRule, GivesTheSidesOfAMovedKnife) {
  SmallPlaces places;
  int ties = 0;
  for (int i = 0; i < 5000; ++i) {
    const Corners t{places.next(), places.next(), places.next()};
    const glm::dvec3 p = places.next();
    if (!has_area(t)) continue;
    ties += sign_of_volume(at_rest(t[0]), at_rest(t[1]), at_rest(t[2]), at_rest(p)) == 0 ? 1 : 0;
    ASSERT_EQ(side_of_knife(t, p), sign_of_volume(moved(t[0]), moved(t[1]), moved(t[2]), at_rest(p))) << i;
    ASSERT_EQ(side_of_fruit(t, p), sign_of_volume(at_rest(t[0]), at_rest(t[1]), at_rest(t[2]), moved(p))) << i;
  }
  EXPECT_GT(ties, 1000);
}

TEST(TieRule, SeesTheFrontWhereCornersRunCounterClockwise) {
  const Corners triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_EQ(side_of_knife(triangle, {0.2, 0.2, 1e-300}), 1);
  EXPECT_EQ(side_of_fruit(triangle, {0.2, 0.2, -1e-300}), -1);
}

TEST(TieRule, HasASideForTrianglesWithoutArea) {
  const Corners line{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
  EXPECT_EQ(side_of_knife(line, {0, 1, 0}), 1);
  EXPECT_EQ(side_of_fruit(line, {0, 1, 0}), 1);
}

TEST(TieRule, TurnsAsAMovedKnifeDoes) {
  SmallPlaces places;
  int ties = 0, parallels = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 p = places.next(), q = places.next(), a = places.next(), b = places.next();
    const int sign = turn(p, q, a, b);
    if (glm::cross(q - p, b - a) == glm::dvec3(0)) {
      ASSERT_EQ(sign, 0) << i;
      ++parallels;
      continue;
    }
    ties += sign_of_volume(at_rest(p), at_rest(q), at_rest(a), at_rest(b)) == 0 ? 1 : 0;
    ASSERT_EQ(sign, sign_of_volume(at_rest(p), at_rest(q), moved(a), moved(b))) << i;
    ASSERT_EQ(turn(q, p, a, b), -sign) << i;
    ASSERT_EQ(turn(p, q, b, a), -sign) << i;
  }
  EXPECT_GT(ties, 1000);
  EXPECT_GT(parallels, 100);
}

/// Numbers that are multiples of 2^-30: the fourth corner of a parallelogram is known without rounding, while the
/// products of a determinant have some hundred bits.
TEST(TieRule, SeesTheLastBit) {
  const RandomStream random({}, "tests/last bit");
  const double bit = 0x1p-30;
  std::uint64_t n = 0;
  const auto place = [&] {
    const glm::dvec3 whole(static_cast<double>(random.bits(n) >> 33), static_cast<double>(random.bits(n + 1) >> 33),
                           static_cast<double>(random.bits(n + 2) >> 33));
    n += 3;
    return whole * bit;
  };
  for (int i = 0; i < 500; ++i) {
    const Corners t{place(), place(), place()};
    const glm::dvec3 in_plane = t[1] + t[2] - t[0], normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 off(0);
      off[axis] = bit;
      const int along = normal[axis] > 0 ? 1 : -1;
      ASSERT_EQ(side_of_knife(t, in_plane + off), along);
      ASSERT_EQ(side_of_fruit(t, in_plane - off), -along);
      ASSERT_EQ(turn(t[0], t[1], t[2], in_plane + off), along);
    }
    // A point in the plane is decided by the knife's first step, along x.
    ASSERT_EQ(side_of_fruit(t, in_plane), normal.x > 0 ? 1 : -1);
    ASSERT_EQ(side_of_knife(t, in_plane), normal.x > 0 ? -1 : 1);
  }
}

/// Inside a convex shape all its triangles are seen from behind.
bool is_inside(const std::vector<Corners>& shape, const glm::dvec3& p, bool shape_moves) {
  for (const Corners& t : shape) {
    const int side = shape_moves ? sign_of_volume(moved(t[0]), moved(t[1]), moved(t[2]), at_rest(p))
                                 : sign_of_volume(at_rest(t[0]), at_rest(t[1]), at_rest(t[2]), moved(p));
    if (side > 0) return false;
  }
  return true;
}

TEST(TieRule, WindsOnceAroundWhatAMovedKnifeHolds) {
  for (const std::vector<Corners>& shape : shapes::convex_shapes()) {
    int inside = 0;
    for (const glm::dvec3& p : shapes::whole_places(0, shapes::max_steps)) {
      int knife = 0, fruit = 0;
      for (const Corners& t : shape) {
        knife += winding_of_knife(t, p);
        fruit += winding_of_fruit(t, p);
      }
      EXPECT_EQ(knife, is_inside(shape, p, true) ? 1 : 0) << p.x << " " << p.y << " " << p.z;
      EXPECT_EQ(fruit, is_inside(shape, p, false) ? 1 : 0) << p.x << " " << p.y << " " << p.z;
      inside += knife;
    }
    EXPECT_GT(inside, 2);
  }
}

TEST(TieRule, CountsShapesInsideOutTheOtherWay) {
  for (const std::vector<Corners>& shape : shapes::convex_shapes()) {
    for (const glm::dvec3& p : shapes::whole_places(0, shapes::max_steps)) {
      for (const Corners& t : shape) {
        EXPECT_EQ(winding_of_knife({t[0], t[2], t[1]}, p), -winding_of_knife(t, p));
        EXPECT_EQ(winding_of_fruit({t[0], t[2], t[1]}, p), -winding_of_fruit(t, p));
      }
    }
  }
}

}  // namespace
}  // namespace pomona
