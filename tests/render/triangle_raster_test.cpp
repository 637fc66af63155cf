#include "render/image/triangle_raster.h"

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include "generator/base/random.h"

namespace pomona {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Corners = std::array<glm::dvec2, 3>;

/// The exact barycentric coordinates of a point, for a triangle with an area.
std::array<Rational, 3> exact_shares(const Corners& corner, const glm::dvec2& point) {
  const auto area = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const Rational ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
    return Rational(ax * (by - cy) + bx * (cy - ay) + cx * (ay - by));
  };
  const Rational whole = area(corner[0], corner[1], corner[2]);
  return {area(point, corner[1], corner[2]) / whole, area(corner[0], point, corner[2]) / whole,
          area(corner[0], corner[1], point) / whole};
}

bool has_area(const Corners& c) {
  return (c[1].x - c[0].x) * (c[2].y - c[0].y) != (c[1].y - c[0].y) * (c[2].x - c[0].x);
}

constexpr PixelBox picture{0, 0, 15, 15};
constexpr std::int64_t unit = 8;                                            // fixed-point steps per pixel
constexpr RasterSamples<std::int64_t> fixed_samples{2, 4, {0, 0, 31, 31}};  // two by two samples per pixel
constexpr RasterSamples<double> middles{0.5, 1, picture};

TriangleRaster<std::int64_t> fixed_raster(const Corners& c) {
  const auto fixed = [](const glm::dvec2& p) { return glm::i64vec2(p * double{unit}); };
  return {fixed(c[0]), fixed(c[1]), fixed(c[2])};
}
TriangleRaster<double> real_raster(const Corners& c) { return {c[0], c[1], c[2]}; }

/// Triangles with corners on the fixed points, many of them beyond the picture, and many with edges through samples.
std::vector<Corners> some_triangles(std::uint64_t count) {
  const RandomStream random({4, 0}, "triangles");
  std::vector<Corners> triangles;
  for (std::uint64_t i = 0; i < count; ++i) {
    Corners corner;
    for (std::uint64_t k = 0; k < 3; ++k) {
      const auto at = [&](std::uint64_t axis) {
        return (static_cast<double>(random.below(6 * i + 2 * k + axis, 20 * unit)) - 2 * unit) / unit;
      };
      corner[k] = {at(0), at(1)};
    }
    if (has_area(corner)) triangles.push_back(corner);
  }
  return triangles;
}

/// A square of `side` by `side` cells, each cut in two along either diagonal, its inner corners moved at random.
std::vector<Corners> tiles(std::uint64_t seed) {
  constexpr std::uint64_t side = 5;
  const RandomStream random({seed, 0}, "tiles");
  std::array<std::array<glm::dvec2, side + 1>, side + 1> place;
  for (std::uint64_t y = 0; y <= side; ++y) {
    for (std::uint64_t x = 0; x <= side; ++x) {
      const auto moved = [&](std::uint64_t i, std::uint64_t axis) {
        const std::uint64_t draw = 2 * (y * (side + 1) + x) + axis;
        const bool inner = x > 0 && x < side && y > 0 && y < side;
        return 3.0 * static_cast<double>(i) +
               (inner ? (static_cast<double>(random.below(draw, unit + 1)) - unit / 2) / unit : 0);
      };
      place[y][x] = {moved(x, 0), moved(y, 1)};
    }
  }
  std::vector<Corners> triangles;
  for (std::uint64_t y = 0; y < side; ++y) {
    for (std::uint64_t x = 0; x < side; ++x) {
      const glm::dvec2 &a = place[y][x], &b = place[y][x + 1], &c = place[y + 1][x + 1], &d = place[y + 1][x];
      const bool other = random.below(1000 + y * side + x, 2) == 1;
      // Every second one has the opposite orientation.
      triangles.push_back(other ? Corners{a, b, d} : Corners{a, b, c});
      triangles.push_back(other ? Corners{b, d, c} : Corners{a, d, c});
    }
  }
  return triangles;
}

TEST(TriangleRaster, CoversWhatExactArithmeticSaysLiesInTheTriangle) {
  for (const Corners& corner : some_triangles(40)) {
    std::map<std::pair<int, int>, glm::i64vec3> covered;
    const TriangleRaster<std::int64_t> raster = fixed_raster(corner);
    raster.for_covered(fixed_samples, [&](int x, int y, const glm::i64vec3& shares) {
      EXPECT_TRUE((covered.try_emplace({x, y}, shares).second)) << "once each";
    });
    for (int y = 0; y <= fixed_samples.box.bottom; ++y) {
      for (int x = 0; x <= fixed_samples.box.right; ++x) {
        const std::array<Rational, 3> exact = exact_shares(corner, {0.25 + 0.5 * x, 0.25 + 0.5 * y});
        const auto found = covered.find({x, y});
        ASSERT_EQ(found != covered.end(), exact[0] >= 0 && exact[1] >= 0 && exact[2] >= 0) << x << " " << y;
        for (int k = 0; k < 3 && found != covered.end(); ++k)
          EXPECT_EQ(Rational(found->second[k], raster.area()), exact[static_cast<std::size_t>(k)]);
      }
    }
  }
}

TEST(TriangleRaster, OfDoublesErrsOnlyAtEdges) {
  const RandomStream random({5, 0}, "shift");
  std::uint64_t draws = 0;
  for (Corners corner : some_triangles(60)) {
    for (glm::dvec2& p : corner) p += glm::dvec2(random.uniform(draws), random.uniform(draws + 1)), draws += 2;
    const TriangleRaster<double> raster = real_raster(corner);
    for (int y = 0; y <= picture.bottom; ++y) {
      for (int x = 0; x <= picture.right; ++x) {
        const glm::dvec2 sample(x + 0.5, y + 0.5);
        const std::array<Rational, 3> exact = exact_shares(corner, sample);
        const Rational min = std::min({exact[0], exact[1], exact[2]});
        if (abs(min) < Rational(1e-9)) continue;
        const auto shares = raster.shares(sample);
        ASSERT_EQ(shares.has_value(), min > 0) << x << " " << y;
        for (int k = 0; k < 3 && shares; ++k)
          EXPECT_NEAR((*shares)[k] / raster.area(), static_cast<double>(exact[static_cast<std::size_t>(k)]), 1e-9);
      }
    }
  }
}

TEST(TriangleRaster, CoversWhatNeighborsShareOnceByTheTopLeftRule) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::map<std::pair<int, int>, int> once, closed;
    int on_edges = 0;
    for (const Corners& corner : tiles(seed)) {
      ASSERT_TRUE(has_area(corner));
      const TriangleRaster<std::int64_t> raster = fixed_raster(corner);
      raster.for_covered(
          fixed_samples,
          [&](int x, int y, const auto&) {
            ++once[{x, y}];
          },
          EdgeRule::top_left);
      raster.for_covered(fixed_samples, [&](int x, int y, const glm::i64vec3& shares) {
        ++closed[{x, y}];
        on_edges += shares.x * shares.y * shares.z == 0 ? 1 : 0;
      });
    }
    EXPECT_GT(on_edges, 20) << "or the test asks nothing";
    int more = 0;
    for (int y = 0; y < 30; ++y) {  // the tiles end at 15
      for (int x = 0; x < 30; ++x) {
        EXPECT_EQ((once[{x, y}]), 1) << x << " " << y;
        EXPECT_GE((closed[{x, y}]), 1);
        more += closed[{x, y}] - 1;
      }
    }
    EXPECT_GT(more, 0);
    EXPECT_EQ(once.size(), 900u) << "none beyond them";
  }
}

TEST(TriangleRaster, DoesNotMindWhichWayTheCornersFollowEachOther) {
  for (const Corners& c : some_triangles(400)) {
    const TriangleRaster<std::int64_t> one = fixed_raster(c), other = fixed_raster({c[0], c[2], c[1]});
    EXPECT_NE(one.is_clockwise(), other.is_clockwise());
    EXPECT_EQ(one.area(), other.area());
    for (const EdgeRule rule : {EdgeRule::closed, EdgeRule::top_left}) {
      std::vector<glm::i64vec3> shares;
      one.for_covered(
          fixed_samples, [&](int, int, const glm::i64vec3& s) { shares.push_back(s); }, rule);
      std::size_t next = 0;
      other.for_covered(
          fixed_samples,
          [&](int, int, const glm::i64vec3& s) {
            ASSERT_LT(next, shares.size());
            EXPECT_EQ(shares[next++], glm::i64vec3(s.x, s.z, s.y));
          },
          rule);
      EXPECT_EQ(next, shares.size());
    }
  }
}

TEST(TriangleRaster, MissesSquaresInWhichItCoversNothing) {
  int missed = 0, empty = 0;
  for (const Corners& corner : some_triangles(400)) {
    const TriangleRaster<std::int64_t> raster = fixed_raster(corner);
    for (int y = 0; y <= picture.bottom; ++y) {
      for (int x = 0; x <= picture.right; ++x) {
        bool covers = false;
        for (std::int64_t v = 0; v <= unit; ++v) {
          for (std::int64_t u = 0; u <= unit; ++u) covers = covers || raster.shares({x * unit + u, y * unit + v});
        }
        const bool misses = raster.misses({x * unit + unit / 2, y * unit + unit / 2}, unit / 2);
        EXPECT_FALSE(misses && covers) << x << " " << y;
        missed += misses ? 1 : 0;
        empty += covers ? 0 : 1;
      }
    }
  }
  EXPECT_GT(missed, empty / 2) << "a test that tells nothing is of no use";
}

TEST(TriangleRaster, BoxesHoldTheCoveredSamplesAndKeepToThePicture) {
  for (const Corners& corner : some_triangles(400)) {
    const PixelBox box = real_raster(corner).box(middles);
    real_raster(corner).for_covered(middles, [&](int x, int y, const glm::dvec3&) {
      EXPECT_TRUE(x >= box.left && x <= box.right && y >= box.top && y <= box.bottom);
    });
    const PixelBox fixed = fixed_raster(corner).box({unit / 2, unit, picture});
    EXPECT_EQ(box.width(), fixed.width());
    EXPECT_EQ(box.height(), fixed.height());
    if (box.empty()) continue;
    EXPECT_TRUE(box.left >= 0 && box.top >= 0 && box.right <= picture.right && box.bottom <= picture.bottom);
    EXPECT_EQ(box.left, fixed.left);
    EXPECT_EQ(box.bottom, fixed.bottom);
  }
  EXPECT_TRUE(TriangleRaster<double>({20, 20}, {30, 20}, {20, 30}).box(middles).empty());
  EXPECT_TRUE(TriangleRaster<double>({-9, 2}, {-1, 2}, {-1, 9}).box(middles).empty());
  EXPECT_EQ(TriangleRaster<double>({-1e300, 0}, {1e300, 0}, {0, 1e300}).box(middles).width(), 16);
}

TEST(TriangleRaster, CoversNothingWithoutArea) {
  const auto never = [](int, int, const auto&) { ADD_FAILURE(); };
  for (const EdgeRule rule : {EdgeRule::closed, EdgeRule::top_left}) {
    TriangleRaster<std::int64_t>({2, 2}, {50, 50}, {10, 10}).for_covered(fixed_samples, never, rule);
    TriangleRaster<std::int64_t>({6, 6}, {6, 6}, {6, 6}).for_covered(fixed_samples, never, rule);
    TriangleRaster<double>({0.5, 0.5}, {9.5, 0.5}, {3.5, 0.5}).for_covered(middles, never, rule);
  }
}

}  // namespace
}  // namespace pomona
