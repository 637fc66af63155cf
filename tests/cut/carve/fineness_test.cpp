#include "generator/cut/carve/fineness.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"

namespace pomona {
namespace {

constexpr double grading = 0.35;

glm::dvec3 place_in_cube(const RandomStream& random, std::uint64_t n) {
  return {random.uniform(3 * n), random.uniform(3 * n + 1), random.uniform(3 * n + 2)};
}

std::vector<FinenessSource> sources(std::size_t count) {
  const RandomStream place({}, "tests/fineness place"), size({}, "tests/fineness size");
  std::vector<FinenessSource> all;
  for (std::uint64_t n = 0; n < count; ++n) all.push_back({place_in_cube(place, n), 0.01 + 0.2 * size.uniform(n)});
  return all;
}

TEST(Fineness, IsTheLeastOverAllSources) {
  // 8 fit into one leaf of its tree, 9 make two.
  for (const std::size_t count : {1u, 8u, 9u, 500u}) {
    const std::vector<FinenessSource> all = sources(count);
    const Fineness fineness(all, grading);
    const RandomStream random({}, "tests/fineness asked");
    for (std::uint64_t n = 0; n < 300; ++n) {
      const glm::dvec3 p = 3.0 * place_in_cube(random, n) - 1.0;
      double min = 10;
      for (const FinenessSource& s : all) min = std::min(min, s.size + grading * glm::distance(p, s.place));
      ASSERT_EQ(fineness.at(p, 10), min) << count << " sources, " << n;
      ASSERT_EQ(fineness.at(p, 0.05), std::min(min, 0.05));
    }
  }
}

TEST(Fineness, DoesNotDependOnTheOrderOfItsSources) {
  std::vector<FinenessSource> all = sources(200);
  const Fineness forwards(all, grading);
  std::reverse(all.begin(), all.end());
  const Fineness backwards(all, grading);
  const RandomStream random({}, "tests/fineness asked");
  for (std::uint64_t n = 0; n < 300; ++n) {
    const glm::dvec3 p = place_in_cube(random, n);
    EXPECT_EQ(forwards.at(p, 1), backwards.at(p, 1));
  }
}

TEST(Fineness, IsTheMostWithoutSources) { EXPECT_EQ(Fineness({}, grading).at({1, 2, 3}, 0.7), 0.7); }

}  // namespace
}  // namespace pomona
