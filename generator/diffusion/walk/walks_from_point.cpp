#include "generator/diffusion/walk/walks_from_point.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/diffusion/walk/walk_draws.h"
#include "generator/diffusion/walk/walk_end.h"
#include "generator/diffusion/walk/walk_tally.h"

namespace pomona {

namespace {

/// A walk ends this near to a surface; normalised, so 1e-4 of the surfaces' size.
constexpr double widest_stop = 2e-4;

/// Next to a surface walks begin within that: they end nearer by this factor, so that a gap between sheets, however
/// narrow, keeps its field.
constexpr double stop_per_start = 0.1;

/// A point nearer than this to a surface is on it; normalised.
constexpr double on_surface = 2e-5;

/// Around all surfaces. What leaves it comes back to it, or never.
constexpr double outer_radius = 1.02;

/// Far beyond any walk there is.
constexpr int max_steps = 1 << 20;

/// Batches that each half begins with, at least.
constexpr double min_batches = 4;

/// Walks that begin together, towards the corners of an icosahedron.
constexpr std::uint64_t batch_size = 12;

/// A stream of its own for each place, whatever other points there are.
RandomStream stream_at(std::uint64_t seed, const glm::vec3& point) {
  const glm::vec3 place = point + 0.0f;  // -0 and 0 are one place
  const std::uint64_t x = std::bit_cast<std::uint32_t>(place.x), y = std::bit_cast<std::uint32_t>(place.y);
  const std::uint64_t z = std::bit_cast<std::uint32_t>(place.z);
  return {{seed, RandomStream({seed, x << 32 | y}, "walk/place").bits(z)}, "walk"};
}

/// A walk on its way, normalised.
struct Walker {
  glm::dvec3 place{0};
  Draws draws;
  enum class State { under_way, arrived, escaped } state = State::under_way;
};

/// One jump; or the end, within `stop` of a surface.
void step(const EmptyBalls& balls, double stop, Walker& walker) {
  const double from_middle = glm::length(walker.place);
  if (from_middle > outer_radius) {
    if (walker.draws.uniform() * from_middle >= outer_radius) {
      walker.state = Walker::State::escaped;
      return;
    }
    walker.place = random_return(walker.place, outer_radius, walker.draws);
  }
  const double radius = balls.radius_at(walker.place);
  if (radius <= stop) {
    walker.state = Walker::State::arrived;
  } else {
    walker.place += radius * random_direction(walker.draws);
  }
}

/// Takes all walkers to their ends, in turn: a processor can prepare one's step while it waits for another's.
void walk_to_end(const EmptyBalls& balls, double stop, std::vector<Walker>& walkers) {
  std::vector<Walker*> under_way;
  for (Walker& walker : walkers) under_way.push_back(&walker);
  for (int steps = 0; !under_way.empty() && steps < max_steps; ++steps) {
    for (Walker* walker : under_way) step(balls, stop, *walker);
    std::erase_if(under_way, [](const Walker* walker) { return walker->state != Walker::State::under_way; });
  }
}

double mean_square(const glm::dvec3& v) { return (v.x * v.x + v.y * v.y + v.z * v.z) / 3; }

class PointWalks {
 public:
  PointWalks(const WalkGround& ground, const glm::vec3& point, const WalkOptions& options)
      : ground_(ground),
        point_(point),
        options_(options),
        stream_(stream_at(options.seed, point)),
        target_(options.standard_error / 255),
        contrast_(std::sqrt(mean_square(glm::dvec3(ground.hull.high - ground.hull.low)))),
        start_(ground.balls.frames().normalized(glm::dvec3(point))),
        is_outside_(glm::length(start_) > outer_radius),
        hits_of_part_(ground.parts.part.size()) {}

  WalkedColor run() {
    if (!is_outside_) {
      first_radius_ = ground_.balls.radius_at(start_);
      if (first_radius_ <= on_surface) return on_nearest_side();
      stop_ = std::clamp(stop_per_start * first_radius_, 0.5 * on_surface, widest_stop);
    }

    // So many that what is too rare to be met could not change the mean by more than the target.
    const double pilot =
        std::max(min_batches, std::ceil(std::min(max_batches(), 1.5 * contrast_ / target_ / batch_size)));
    grow(pilot, pilot);
    while (!is_known() && walks() < options_.max_walks) grow(wanted(0), wanted(1));
    return half_[0].hits() + half_[1].hits() > 0 ? mean() : on_nearest_side();
  }

 private:
  /// The tally of each half.
  double max_batches() const { return options_.max_walks / (2.0 * batch_size) + 1; }

  double walks() const { return batch_size * (half_[0].batches() + half_[1].batches()); }

  bool is_known() const { return half_[0].hits() > 0 && half_[1].hits() > 0 && variance() <= target_ * target_; }

  /// The variance of the mean over both halves. It includes what the walks may have missed: something that
  /// one in twice their number meets.
  double variance() const {
    double sum = 0, hits = 0;
    for (const WalkTally& half : half_) {
      sum += 0.25 * half.variance_of_batch() / half.batches();
      hits += half.hits();
    }
    const double unmet = 0.5 * contrast_ / hits;
    return sum + unmet * unmet;
  }

  /// How many batches a half should hold. The other half tells: if walks had a say in how many walks follow them,
  /// the mean would lean towards those that end it early.
  double wanted(int which) const {
    const WalkTally& half = half_[which];
    const WalkTally& other = half_[1 - which];
    const double max = max_batches();
    if (half.hits() == 0 || other.hits() == 0) return std::min(max, 2 * half.batches());

    // Half the variance of one batch over n, and the square of the unmet over n, shall make the target's square.
    const double squared = target_ * target_, unmet = 0.25 * contrast_ * other.batches() / other.hits();
    const double v = 0.5 * other.variance_of_batch();
    const double needed = (v + std::sqrt(v * v + 4 * squared * unmet * unmet)) / (2 * squared);
    constexpr double reserve = 1.04, min_growth = 1.02;
    return std::min(max, std::ceil(std::max(reserve * needed, min_growth * half.batches())));
  }

  void grow(double first, double second) {
    while (half_[0].batches() < first) add_batch(0);
    while (half_[1].batches() < second) add_batch(1);
  }

  void add_batch(int which) {
    // Each batch draws numbers of its own, however many batches the other half has.
    const auto index = 2 * static_cast<std::uint64_t>(half_[which].batches()) + static_cast<std::uint64_t>(which);
    Draws turn(stream_, index << 32 | batch_size << 28);
    const std::array<glm::dvec3, batch_size> direction = random_icosahedron(turn);

    // The walks set out together: towards the corners of an icosahedron or, from outside, back on the outer sphere.
    std::vector<Walker> walkers;
    for (std::size_t i = 0; i < batch_size; ++i) {
      Walker walker{.draws = Draws(stream_, index << 32 | i << 28)};
      walker.place =
          is_outside_ ? random_return(start_, outer_radius, walker.draws) : start_ + first_radius_ * direction[i];
      walkers.push_back(walker);
    }
    walk_to_end(ground_.balls, stop_, walkers);

    // Each walk that arrived brings the colour of the side it met; those that escaped bring nothing.
    WalkBatch batch;
    for (const Walker& walker : walkers) {
      if (walker.state != Walker::State::arrived) continue;
      const SurfaceSide side = side_next_to(ground_.surfaces, ground_.balls, walker.place);
      batch.color += color_of(ground_.surfaces, side);
      batch.hits += 1;
      ++hits_of_part_[(side.side == SideOf::front ? ground_.parts.front : ground_.parts.back)[side.triangle]];
    }
    half_[which].add(batch);
  }

  WalkedColor mean() const {
    const glm::dvec3 color = half_[0].hits() == 0   ? half_[1].mean()
                             : half_[1].hits() == 0 ? half_[0].mean()
                                                    : 0.5 * (half_[0].mean() + half_[1].mean());
    const auto max = std::max_element(hits_of_part_.begin(), hits_of_part_.end());
    const double hits = half_[0].hits() + half_[1].hits();
    return {glm::clamp(Color(color), ground_.hull.low, ground_.hull.high),
            ground_.parts.part[static_cast<std::size_t>(max - hits_of_part_.begin())], 255 * std::sqrt(variance()),
            static_cast<std::uint32_t>(walks()), static_cast<std::uint32_t>(walks() - hits)};
  }

  WalkedColor on_nearest_side() const {
    const SurfaceSide nearest = nearest_side(ground_.surfaces, ground_.tree, glm::dvec3(point_)).value();
    const auto all = static_cast<std::uint32_t>(walks());
    const Color color(color_of(ground_.surfaces, nearest));
    return {glm::clamp(color, ground_.hull.low, ground_.hull.high), part_of(ground_.surfaces, nearest), 0, all, all};
  }

  const WalkGround& ground_;
  const glm::vec3 point_;
  const WalkOptions& options_;
  const RandomStream stream_;
  const double target_;    ///< standard error
  const double contrast_;  ///< the surfaces' colours differ by no more; RMS over channels
  const glm::dvec3 start_;
  const bool is_outside_;
  double first_radius_ = 0, stop_ = widest_stop;
  std::array<WalkTally, 2> half_;
  std::vector<std::uint32_t> hits_of_part_;
};

}  // namespace

WalkGround::WalkGround(const DiffusionSurfaces& of, Threads threads)
    : surfaces(of),
      tree(make_surface_tree(of)),
      balls(make_triangle_frames(of, tree), threads),
      hull(hull_of(of, tree)),
      parts(used_parts(of)) {}

WalkedColor walks_from_point(const WalkGround& ground, const glm::vec3& point, const WalkOptions& options) {
  return PointWalks(ground, point, options).run();
}

}  // namespace pomona
