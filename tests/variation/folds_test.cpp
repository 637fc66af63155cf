// N-fold variation.
#include <cmath>

#include <gmock/gmock.h>
#include <Eigen/Dense>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/surface/crossings.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/variation/fold_pca.h"
#include "generator/variation/fold_room.h"
#include "generator/variation/fold_samples.h"
#include "generator/variation/vary.h"
#include "generator/variation/vary_folds.h"
#include "tests/variation/fruits.h"

namespace pomona {
namespace {

const std::vector<double>& lines_of(const Template& fruit) {
  return std::get<FoldSymmetry>(fruit.symmetry).fold_angles;
}

/// Every loop has points, and every chamber stays strictly between its fold lines.
void expect_chambers_in_folds(const Template& fruit) {
  const std::vector<double>& lines = lines_of(fruit);
  const std::vector<double> widths = fold_widths(std::get<FoldSymmetry>(fruit.symmetry));
  for (const SurfaceSketch& surface : fruit.surfaces) {
    if (surface.type != SurfaceType::in_fold) continue;
    ASSERT_EQ(surface.horizontal.size(), lines.size());
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const PolarCurve polar = to_polar(surface.horizontal[k].points);
      for (const double azimuth : polar.azimuth) {
        double share = (azimuth - lines[k]) / (2 * pi);
        share = (share - std::floor(share)) * 2 * pi / widths[k];
        EXPECT_GT(share, 0);
        EXPECT_LT(share, 1);
      }
      EXPECT_TRUE(is_simple(surface.horizontal[k]));
    }
  }
}

TEST(PrincipalWeights, HaveTheCovarianceOfPrincipalComponents) {
  // Four samples of three numbers, with explicit principal components.
  constexpr int samples = 4, features = 3, draws = 20000;
  Eigen::MatrixXd x(samples, features);
  x << 1, 2, 0.5, 2, 0, 1, -1, 1, 3, 0.5, -2, 1;
  const Eigen::RowVectorXd mean = x.colwise().mean();
  const Eigen::MatrixXd centred = x.rowwise() - mean;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(centred, Eigen::ComputeThinV);
  const Eigen::MatrixXd v = svd.matrixV();
  const Eigen::VectorXd variances = svd.singularValues().array().square() / (samples - 1);
  const Eigen::MatrixXd expected = v * variances.asDiagonal() * v.transpose();

  Eigen::MatrixXd drawn(draws, features);
  for (int d = 0; d < draws; ++d) {
    const RandomStream stream({static_cast<std::uint64_t>(d), 0}, "test");
    std::vector<double> z;
    for (std::uint64_t i = 0; i < samples; ++i) z.push_back(stream.normal(i));
    const std::vector<double> w = principal_weights(z);
    drawn.row(d) = mean;
    for (int i = 0; i < samples; ++i) drawn.row(d) += w[static_cast<std::size_t>(i)] * centred.row(i);
  }
  const Eigen::RowVectorXd drawn_mean = drawn.colwise().mean();
  const Eigen::MatrixXd deviation = drawn.rowwise() - drawn_mean;
  const Eigen::MatrixXd covariance = deviation.transpose() * deviation / (draws - 1);
  EXPECT_LT((drawn_mean - mean).norm(), 0.03);
  EXPECT_LT((covariance - expected).norm(), 0.03 * expected.norm());
}

TEST(PrincipalWeights, StayNearTheHullWhenClipped) {
  for (const std::size_t n : {1u, 2u, 3u, 5u, 8u}) {
    for (const double beta : {0.0, 0.2}) {
      for (std::uint64_t seed = 0; seed < 500; ++seed) {
        std::vector<double> z;
        for (std::uint64_t i = 0; i < n; ++i) z.push_back(RandomStream({seed, 1}, "test").normal(i));
        double sum = 0;
        for (const double w : clipped(principal_weights(z), {.gain = 2, .extrapolation = beta})) {
          EXPECT_GE(1.0 / static_cast<double>(n) + w, -beta - 1e-12);
          sum += w;
        }
        EXPECT_NEAR(sum, 0, 1e-12);
      }
    }
  }
}

/// The likeliest 95 % of draws are not clipped, for any number of samples.
TEST(PrincipalWeights, OneInTwentyIsClipped) {
  for (const std::size_t n : {2u, 3u, 5u, 8u}) {
    constexpr std::uint64_t draws = 20000;
    int clipped_draws = 0;
    for (std::uint64_t seed = 0; seed < draws; ++seed) {
      const RandomStream stream({seed, 2}, "test");
      std::vector<double> z;
      for (std::uint64_t i = 0; i < n; ++i) z.push_back(stream.normal(i));
      const std::vector<double> drawn = principal_weights(z);
      if (clipped(drawn, {.gain = 1, .extrapolation = 100}) != drawn) ++clipped_draws;
    }
    // The limit is exact to 1.5 %, which is 0.4 % of the draws; their own scatter is 0.15 %.
    EXPECT_NEAR(clipped_draws / static_cast<double>(draws), 0.05, 0.008) << n << " samples";
  }
}

TEST(FoldSamples, FindAKnownRotation) {
  std::vector<glm::dvec2> loop;
  for (int i = 0; i < 64; ++i) {
    const double t = 2 * pi * i / 64;
    loop.push_back({std::cos(t) * (1 + 0.2 * std::cos(3 * t)), 0.7 * std::sin(t)});
  }
  for (const std::ptrdiff_t shift : {0, 1, 17, 63}) {
    std::vector<glm::dvec2> turned = loop;
    std::rotate(turned.begin(), turned.begin() + shift, turned.end());
    EXPECT_EQ(best_shift(turned, loop), static_cast<std::size_t>(shift));
  }
}

TEST(FoldSamples, RunFromLineToLine) {
  for (const int folds : {1, 2, 3, 5}) {
    for (const FoldSamples& samples : fold_samples(fruits::tomato(folds))) {
      for (const PolarCurve& fold : samples.fold) {
        if (samples.closed) continue;
        EXPECT_EQ(fold.azimuth.front(), 0);
        EXPECT_EQ(fold.azimuth.back(), 1);
        EXPECT_TRUE(std::is_sorted(fold.azimuth.begin(), fold.azimuth.end()));
      }
    }
  }
}

TEST(FoldVariation, MakesAnyNumberOfFolds) {
  for (const int drawn : {1, 2, 3, 5}) {
    const Template tomato = fruits::tomato(drawn);
    for (const int folds : {1, 2, 7, 64}) {
      for (const Template& variant : {vary(tomato, {3, 0}, {.amount = 1, .folds = folds}), with_folds(tomato, folds)}) {
        EXPECT_EQ(fold_count(variant), folds);
        expect_chambers_in_folds(variant);
        for (const SurfaceSketch& surface : variant.surfaces) {
          EXPECT_TRUE(surface.type == SurfaceType::in_fold || is_star_shaped(surface.horizontal.front()));
        }
        EXPECT_NO_THROW(sweep(variant, {.detail = 0.3})) << drawn << " to " << folds;
      }
    }
  }
}

TEST(FoldVariation, IsAsDrawnAtAmountZero) {
  const Template tomato = fruits::tomato();
  const Template variant = vary(tomato, {9, 0}, {.amount = 0});
  EXPECT_THAT(lines_of(variant), testing::Pointwise(testing::DoubleNear(1e-12), lines_of(tomato)));
  for (std::size_t s = 0; s < 3; ++s) {
    const RadiusOf drawn(tomato.surfaces[s].horizontal.front()), varied(variant.surfaces[s].horizontal.front());
    for (int i = 0; i < 500; ++i) EXPECT_NEAR(varied(i * 0.0126), drawn(i * 0.0126), 2e-3 * drawn(i * 0.0126));
  }
}

TEST(FoldVariation, JoinsAcrossFoldLines) {
  const Template tomato = fruits::tomato();
  const FoldVariation variation(tomato);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Template variant = variation.draw({seed, 0}, 1, 5).fruit;
    for (const SurfaceSketch& surface : variant.surfaces) {
      if (surface.type != SurfaceType::around_axis) continue;
      const RadiusOf radius(surface.horizontal.front());
      for (const double line : lines_of(variant)) {
        EXPECT_NEAR(radius(line - 1e-9), radius(line + 1e-9), 1e-9);
      }
    }
  }
}

TEST(FoldVariation, KeepsChambersInTheirFoldsAndNothingCrosses) {
  const Template tomato = fruits::tomato();
  ASSERT_TRUE(crossing_triangles(sweep(tomato)).empty());
  const FoldVariation variation(tomato);
  int stepped = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const double amount = seed % 3 == 0 ? 2 : 1;
    const FoldVariant variant = variation.draw({seed, 0}, amount, 5);
    expect_chambers_in_folds(variant.fruit);
    for (const FoldReport& fold : variant.folds) {
      EXPECT_TRUE(fold.sound);
      stepped += fold.rung > 0;
    }
    if (seed % 15 != 0) continue;
    EXPECT_TRUE(crossing_triangles(sweep(variant.fruit)).empty()) << seed;
  }
  EXPECT_LT(stepped, 120 * 5 / 4);
}

/// A wall with a different radius at each fold line, and just inside it, beside each fold's first line, a chamber.
Template chambers_beside_their_first_lines(const std::vector<double>& radius_at_line) {
  const std::size_t folds = radius_at_line.size();
  const double width = 2 * pi / static_cast<double>(folds);
  Template fruit = fruits::tomato(static_cast<int>(folds));
  SurfaceSketch wall = fruit.surfaces[1], chamber = fruit.surfaces[3];
  std::vector<double> lines;
  wall.front.hidden = true;
  wall.horizontal.front().points.clear();
  chamber.horizontal.clear();
  chamber.reference = ReferenceRadii{0.018, 0.032};
  for (glm::dvec2& p : chamber.vertical.points) p = {0.025 + (p.x - 0.0195), 0.028 + 0.25 * (p.y - 0.028)};
  for (std::size_t k = 0; k < folds; ++k) {
    const double line = width * static_cast<double>(k), here = radius_at_line[k],
                 next = radius_at_line[(k + 1) % folds];
    lines.push_back(line);
    for (int i = 0; i < 60; ++i)
      wall.horizontal.front().points.push_back(polar_point(line + width * i / 60, std::lerp(here, next, i / 60.0)));
    Curve loop{{}, true};
    for (int i = 0; i < 48; ++i) {
      const double angle = 2 * pi * i / 48, share = 0.27 + 0.22 * std::cos(angle);
      const double outside = 0.965 * std::lerp(here, next, share);
      loop.points.push_back(polar_point(line + width * share, outside - 0.001 + 0.001 * std::sin(angle)));
    }
    chamber.horizontal.push_back(loop);
  }
  fruit.symmetry = FoldSymmetry{lines};
  fruit.surfaces = {wall, chamber};
  return fruit;
}

/// A neighbour may pull the wall inwards at the line between them. If a fold is already as drawn, the neighbour must
/// give way.
TEST(FoldVariation, FoldsThatAreAsDrawnAreMadeRoomForByTheirNeighbours) {
  for (const std::vector<double>& radii : {std::vector{0.033, 0.027, 0.030}, {0.033, 0.0265, 0.031, 0.028, 0.030}}) {
    const Template fruit = chambers_beside_their_first_lines(radii);
    ASSERT_TRUE(crossing_triangles(sweep(fruit)).empty());
    const FoldVariation variation(fruit);
    int as_drawn = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      for (const FoldReport& fold : variation.draw({seed, 0}, 2, static_cast<int>(radii.size())).folds) {
        EXPECT_TRUE(fold.sound) << seed;
        as_drawn += fold.rung == 12;
      }
    }
    EXPECT_GT(as_drawn, 10);
  }
}

TEST(FoldRoom, KnowsWhenAChamberLeavesItsLayer) {
  for (const double taper : {0.0, 1.0}) {
    Template tomato = fruits::tomato();
    tomato.surfaces[3].taper = taper;
    const FoldRoom room(tomato);
    EXPECT_EQ(room.is_sound(tomato), std::vector<bool>(tomato.surfaces[3].horizontal.size(), true)) << taper;
    for (std::size_t k = 0; k < tomato.surfaces[3].horizontal.size(); ++k) {
      Template out = tomato;
      for (glm::dvec2& p : out.surfaces[3].horizontal[k].points) p *= 1.6;
      const std::vector<bool> sound = room.is_sound(out);
      for (std::size_t j = 0; j < sound.size(); ++j) EXPECT_EQ(sound[j], j != k) << taper << " " << k << " " << j;
    }
  }
}

TEST(FoldVariation, LeavesAMissingChamberMissing) {
  Template tomato = fruits::tomato();
  tomato.surfaces[3].horizontal[2].points.clear();
  const Template variant = vary(tomato, {2, 2}, {.amount = 1, .folds = 10});
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_EQ(variant.surfaces[3].horizontal[k].points.empty(), k % 5 == 2);
  }
}

TEST(FoldVariation, KeepsTheConnectivityOfTheSweep) {
  for (const Template& fruit : {fruits::tomato(), fruits::onion()}) {
    const DiffusionSurfaces drawn = sweep(fruit);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const DiffusionSurfaces variant = sweep(vary(fruit, {seed, 0}));
      EXPECT_EQ(variant.triangle, drawn.triangle);
      EXPECT_EQ(variant.surface, drawn.surface);
      EXPECT_NE(variant.position, drawn.position);
    }
  }
}

TEST(FoldVariation, DependsOnTheKeyAlone) {
  const Template tomato = fruits::tomato();
  const Template first = vary(tomato, {5, 6}), again = vary(tomato, {5, 6}), other = vary(tomato, {5, 7});
  EXPECT_EQ(lines_of(first), lines_of(again));
  for (std::size_t s = 0; s < tomato.surfaces.size(); ++s) {
    for (std::size_t k = 0; k < first.surfaces[s].horizontal.size(); ++k) {
      EXPECT_EQ(first.surfaces[s].horizontal[k].points, again.surfaces[s].horizontal[k].points);
      EXPECT_NE(first.surfaces[s].horizontal[k].points, other.surfaces[s].horizontal[k].points);
    }
  }
}

TEST(FoldVariation, RefusesWhatItCannotDo) {
  EXPECT_THROW(with_folds(fruits::onion(), 5), Error);
  EXPECT_THROW(vary(fruits::onion(), {1, 0}, {.amount = 1, .folds = 5}), Error);
  EXPECT_THROW(with_folds(fruits::tomato(), 0), Error);
  EXPECT_THROW(with_folds(fruits::tomato(), 65), Error);
  EXPECT_THROW(vary(fruits::tomato(), {1, 0}, {.amount = 2.5}), Error);
  EXPECT_THROW(vary(fruits::tomato(), {1, 0}, {.amount = std::nan("")}), Error);
}

}  // namespace
}  // namespace pomona
