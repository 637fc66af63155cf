// Texture detail: the patterns, and their use by Look.
#include "render/style/detail.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "render/style/look.h"

namespace pomona {
namespace {

constexpr std::array all_kinds = {DetailKind::fibres, DetailKind::cells, DetailKind::speckles, DetailKind::streaks,
                                  DetailKind::net};
constexpr std::array all_runs = {DetailRun::none, DetailRun::to_skin, DetailRun::along, DetailRun::around};

const RandomStream stream({11, 0}, "detail_test");
constexpr double ball_radius = 0.03;
const glm::dvec3 ball_center(0, ball_radius, 0);

DetailSketch some_detail(DetailKind kind, DetailRun run) {
  DetailSketch detail;
  detail.kind = kind;
  detail.run = run;
  detail.size = 1e-3;
  detail.smallest = 5e-4;
  detail.length = 12e-3;
  detail.density = 0.4;
  detail.amount = 0.6;
  detail.color = Color(0.9f, 0.9f, 0.8f);
  detail.parts = {0};
  detail.reach = detail.middle = ball_radius;
  return detail;
}

/// The guide in a ball that stands on the ground, whose layers are spheres.
DetailGuide guide_at(const glm::dvec3& p) {
  const glm::dvec3 out = p - ball_center;
  const double radius = glm::length(out);
  return {glm::vec3(out * ((ball_radius - radius) / radius)), static_cast<float>(ball_radius - radius), glm::vec4(1)};
}

/// A place between 12 and 27 mm from the middle, at least 12 mm from the axis.
glm::dvec3 some_place(std::uint64_t i) {
  const double turn = 6.28 * stream.uniform(3 * i), up = 0.8 * stream.uniform(3 * i + 1) - 0.4;
  const double radius = 0.015 + 0.012 * stream.uniform(3 * i + 2);
  return ball_center + radius * glm::dvec3(std::cos(turn) * std::cos(up), std::sin(up), std::sin(turn) * std::cos(up));
}

/// The directions in which a detail runs, and two across it.
std::array<glm::dvec3, 3> frame_at(DetailRun run, const glm::dvec3& p) {
  const glm::dvec3 out = glm::normalize(p - ball_center);
  const glm::dvec3 around = glm::normalize(glm::cross(out, glm::dvec3(0, 1, 0)));
  const glm::dvec3 along = glm::cross(around, out);
  if (run == DetailRun::along) return {along, around, out};
  if (run == DetailRun::around) return {around, along, out};
  return {out, around, along};
}

double share_at(const Pattern& pattern, const glm::dvec3& p, double footprint = 0) {
  return pattern(p, guide_at(p), footprint).share;
}

TEST(Detail, patterns_stay_within_their_range_and_use_it) {
  for (const DetailKind kind : all_kinds) {
    const Pattern pattern(some_detail(kind, DetailRun::to_skin), 1);
    double min = 1, max = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const glm::dvec3 p = some_place(i);
      const PatternValue value = pattern(p, guide_at(p), 0);
      ASSERT_GE(value.share, 0.0);
      ASSERT_LE(value.share, 1.0);
      ASSERT_LE(std::fabs(value.tone), 1.0);
      min = std::min(min, value.share), max = std::max(max, value.share);
    }
    EXPECT_LT(min, 0.05);
    EXPECT_GT(max, 0.9);
  }
}

TEST(Detail, density_is_the_share_of_the_area) {
  for (const DetailKind kind : {DetailKind::fibres, DetailKind::streaks}) {
    for (const double density : {0.15, 0.4, 0.7}) {
      DetailSketch detail = some_detail(kind, DetailRun::none);
      detail.density = density;
      EXPECT_NEAR(Pattern(detail, 1).shape().mean.share, density, 0.09);
    }
  }
}

TEST(Detail, patterns_of_two_variants_have_nothing_in_common_but_their_look) {
  for (const DetailKind kind : all_kinds) {
    DetailSketch detail = some_detail(kind, DetailRun::to_skin);
    const Pattern drawn(detail, 1);
    detail.pattern = 77;
    const Pattern own(detail, 1), again(detail, 1);
    double both = 0, squares = 0;
    const double mean = own.shape().mean.share;
    EXPECT_NEAR(drawn.shape().mean.share, mean, 0.06);
    for (std::uint64_t i = 0; i < 4000; ++i) {
      const double a = share_at(drawn, some_place(i)) - mean, b = share_at(own, some_place(i)) - mean;
      EXPECT_EQ(share_at(again, some_place(i)), share_at(own, some_place(i)));
      both += a * b, squares += 0.5 * (a * a + b * b);
    }
    EXPECT_LT(std::fabs(both), 0.2 * squares) << int(kind);
  }
}

TEST(Detail, runs_where_the_guide_says) {
  // The mean square of differences along the run, and across it: a structure tensor's diagonal.
  for (const DetailKind kind : {DetailKind::fibres, DetailKind::streaks, DetailKind::cells, DetailKind::net}) {
    for (const DetailRun run : {DetailRun::to_skin, DetailRun::along, DetailRun::around}) {
      const Pattern pattern(some_detail(kind, run), 3);
      glm::dvec3 change(0);
      for (std::uint64_t i = 0; i < 1500; ++i) {
        const glm::dvec3 p = some_place(i);
        const std::array<glm::dvec3, 3> frame = frame_at(run, p);
        for (int k = 0; k < 3; ++k) {
          const double d = share_at(pattern, p + 2e-5 * frame[k]) - share_at(pattern, p - 2e-5 * frame[k]);
          change[k] += d * d;
        }
      }
      EXPECT_LT(change[0], 0.05 * change[1]) << int(kind) << " " << int(run);
      EXPECT_LT(change[0], 0.05 * change[2]) << int(kind) << " " << int(run);
    }
  }
}

TEST(Detail, is_as_wide_far_from_the_origin_as_near_it) {
  // On a sphere of equal depth, differences do not depend on the place.
  const Pattern pattern(some_detail(DetailKind::fibres, DetailRun::to_skin), 3);
  std::array<double, 2> change{};
  for (std::uint64_t i = 0; i < 3000; ++i) {
    glm::dvec3 out = glm::normalize(some_place(i) - ball_center);
    const glm::dvec3 p = ball_center + 0.02 * out;
    const double d = share_at(pattern, p + 2e-5 * frame_at(DetailRun::to_skin, p)[2]) - share_at(pattern, p);
    change[out.y > 0 ? 1 : 0] += d * d;
  }
  EXPECT_NEAR(change[0] / change[1], 1.0, 0.25);
}

TEST(Detail, goes_over_into_its_mean_where_pixels_cannot_show_it) {
  for (const DetailKind kind : all_kinds) {
    const Pattern pattern(some_detail(kind, DetailRun::none), 2);
    double last = 1e9;
    for (const double footprint : {0.0, 3e-4, 4e-4, 5e-4}) {
      double sum = 0, squares = 0;
      for (std::uint64_t i = 0; i < 1500; ++i) {
        const double value = share_at(pattern, some_place(i), footprint);
        sum += value, squares += value * value;
      }
      const double variance = squares / 1500 - sum * sum / 1500 / 1500;
      EXPECT_LT(variance, last);
      EXPECT_NEAR(sum / 1500, pattern.shape().mean.share, 0.06);
      last = variance + 1e-12;
    }
    EXPECT_LT(last, 1e-9);
  }
}

TEST(Detail, is_continuous_wherever_the_guide_is) {
  for (const DetailKind kind : {DetailKind::fibres, DetailKind::cells, DetailKind::streaks, DetailKind::net}) {
    for (const DetailRun run : all_runs) {
      DetailSketch detail = some_detail(kind, run);
      detail.wander = 0.5;
      detail.softness = 0.5;
      const Pattern pattern(detail, 5);
      for (std::uint64_t i = 0; i < 500; ++i) {
        glm::dvec3 p = some_place(i);
        if (i % 4 == 0) p.z = 0, p.x = -std::fabs(p.x) - 0.01;  // the azimuth's seam
        ASSERT_NEAR(share_at(pattern, p - glm::dvec3(0, 0, 1e-8)), share_at(pattern, p + glm::dvec3(0, 0, 1e-8)), 2e-3);
      }
    }
  }
}

TEST(Look, like_another_is_what_it_would_be_alone) {
  // Equal patterns, one of another shape, and one of another seed.
  DetailSketch rays;
  rays.amount = 0.5;
  DetailSketch cells = rays;
  cells.kind = DetailKind::cells;
  DetailSketch other = rays;
  other.pattern = 4711;
  const Look first({}, {rays, cells});
  for (const std::vector<DetailSketch>& details : {std::vector{rays, cells}, std::vector{cells, rays},
                                                   std::vector{other, other}, std::vector{rays, rays, cells}}) {
    const Look alone({}, details), like({}, details, &first);
    ASSERT_EQ(like.details(DetailFace::cut).size(), details.size());
    for (std::size_t i = 0; i < details.size(); ++i) {
      const Pattern::Shape &a = alone.details(DetailFace::cut)[i].pattern.shape(),
                           &b = like.details(DetailFace::cut)[i].pattern.shape();
      EXPECT_EQ(a.threshold, b.threshold);
      EXPECT_EQ(a.ramp, b.ramp);
      EXPECT_EQ(a.seed, b.seed);
      EXPECT_EQ(a.mean.share, b.mean.share);
      EXPECT_EQ(a.mean.tone, b.mean.tone);
    }
  }
}

TEST(Look, without_amounts_or_shares_keeps_every_bit) {
  for (const DetailKind kind : all_kinds) {
    DetailSketch detail = some_detail(kind, DetailRun::to_skin);
    const Look with(NoiseStyle{}, {detail});
    detail.amount = 0;
    const Look without(NoiseStyle{}, {detail});
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Color color(0.3f + 1e-4f * static_cast<float>(i), 0.21f, 0.07f);
      const LookPlace place{.position = some_place(i), .guide = guide_at(some_place(i))};
      EXPECT_EQ(without(color, place), color);
      EXPECT_EQ(with(color, {.position = some_place(i)}), color);
      EXPECT_EQ(with(color, {.position = place.position, .face = DetailFace::skin, .guide = place.guide}), color);
    }
  }
}

TEST(Look, weighs_by_the_unmodulated_color) {
  DetailSketch detail = some_detail(DetailKind::fibres, DetailRun::none);
  detail.near = Color(0.6f, 0.02f, 0.02f);
  const Look look(NoiseStyle{}, {detail});
  double near = 0, far = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const LookPlace place{.position = some_place(i), .guide = guide_at(some_place(i))};
    near += glm::distance(look(*detail.near, place), *detail.near);
    far += glm::distance(look(Color(0.05f, 0.4f, 0.05f), place), Color(0.05f, 0.4f, 0.05f));
  }
  EXPECT_GT(near, 50.0);
  EXPECT_LT(far, 0.02 * near);
}

TEST(Look, stays_a_color_whatever_a_template_says) {
  for (const DetailKind kind : all_kinds) {
    for (const DetailRun run : all_runs) {
      DetailSketch detail = some_detail(kind, run);
      detail.color = {};
      detail.axis = {1, -1, 1};
      detail.amount = -1;
      detail.size = 5e-5, detail.smallest = 5e-5, detail.length = 10;
      detail.wander = 2, detail.width = 1, detail.softness = 0, detail.density = 0.99, detail.variety = 1;
      const Look look(NoiseStyle{}, {detail, detail, detail, detail, detail, detail});
      for (const glm::dvec3& p : {glm::dvec3(0), glm::dvec3(0, 0.03, 0), glm::dvec3(1e6, -1e6, 1e6), some_place(1)}) {
        const Color color = look(Color(0.5f), {.position = p, .guide = {glm::vec3(p), 0.01f, glm::vec4(1)}});
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(color[k] >= 0 && color[k] <= 1) << int(kind) << " " << int(run);
      }
    }
  }
}

}  // namespace
}  // namespace pomona
