#include "generator/diffusion/walk/walk_tally.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"

namespace pomona {
namespace {

/// Batches of twelve walks, each of which meets white, black or nothing.
std::vector<WalkBatch> some_batches(std::uint64_t first, std::size_t count) {
  const RandomStream random({}, "tests/batches");
  std::vector<WalkBatch> batches(count);
  std::uint64_t n = first;
  for (WalkBatch& batch : batches) {
    for (int walk = 0; walk < 12; ++walk, ++n) {
      const double u = random.uniform(n);
      if (u > 0.8) continue;
      batch.hits += 1;
      if (u < 0.3) batch.color += glm::dvec3(1, 0.5, 0.2);
    }
  }
  return batches;
}

WalkTally tally_of(const std::vector<WalkBatch>& batches) {
  WalkTally tally;
  for (const WalkBatch& batch : batches) tally.add(batch);
  return tally;
}

TEST(WalkTally, MeanIsThatOfAllWalksThatMetSomething) {
  const std::vector<WalkBatch> batches = {{{3, 1, 0}, 4}, {{1, 1, 2}, 1}, {{0, 0, 0}, 0}};
  const WalkTally tally = tally_of(batches);
  EXPECT_EQ(tally.batches(), 3);
  EXPECT_EQ(tally.hits(), 5);
  EXPECT_LT(glm::distance(tally.mean(), glm::dvec3(0.8, 0.4, 0.4)), 1e-15);
}

TEST(WalkTally, VarianceIsThatOfTheBatchesResiduals) {
  const std::vector<WalkBatch> batches = some_batches(0, 40);
  const WalkTally tally = tally_of(batches);
  double squares = 0;
  for (const WalkBatch& batch : batches) {
    const glm::dvec3 residual = batch.color - tally.mean() * batch.hits;
    squares += glm::dot(residual, residual) / 3;
  }
  const double hits_per_batch = tally.hits() / tally.batches();
  EXPECT_NEAR(tally.variance_of_batch(), squares / 39 / (hits_per_batch * hits_per_batch), 1e-12);
}

TEST(WalkTally, SaysHowMuchMeansScatter) {
  // Many tallies of 30 batches each: their means scatter by the standard error that each states.
  glm::dvec3 sum(0), squares(0);
  double said = 0;
  constexpr int count = 400;
  for (int i = 0; i < count; ++i) {
    const WalkTally tally = tally_of(some_batches(static_cast<std::uint64_t>(i) * 1000, 30));
    sum += tally.mean();
    squares += tally.mean() * tally.mean();
    said += tally.variance_of_batch() / 30 / count;
  }
  const glm::dvec3 variance = (squares - sum * sum / static_cast<double>(count)) / (count - 1.0);
  EXPECT_NEAR((variance.x + variance.y + variance.z) / 3 / said, 1, 0.2);
}

TEST(WalkTally, HasNoVarianceWhereAllBatchesAreAlike) {
  EXPECT_NEAR(tally_of({{{6, 6, 6}, 12}, {{6, 6, 6}, 12}}).variance_of_batch(), 0, 1e-15);
}

}  // namespace
}  // namespace pomona
