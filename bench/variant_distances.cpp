#include "bench/variant_distances.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/parallel.h"

namespace pomona::bench {

namespace {

double distance_between(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const glm::vec3 difference = a[v] - b[v];
    sum += static_cast<double>(glm::dot(difference, difference));
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

struct Pair {
  double distance = 0;
  int first = 0, second = 0;
};

bool nearer(const Pair& a, const Pair& b) {
  return std::tie(a.distance, a.first, a.second) < std::tie(b.distance, b.first, b.second);
}

/// Distances of all pairs from `variant` to those before it.
std::vector<Pair> pairs_of(const std::vector<std::vector<glm::vec3>>& variants, std::size_t variant) {
  std::vector<Pair> pairs;
  for (std::size_t other = 0; other < variant; ++other) {
    pairs.push_back(
        {distance_between(variants[variant], variants[other]), static_cast<int>(other), static_cast<int>(variant)});
  }
  return pairs;
}

}  // namespace

VariantDistances distances_between(const std::vector<std::vector<glm::vec3>>& variants,
                                   const std::function<std::vector<glm::vec3>(int)>& all_of) {
  constexpr std::size_t looked_at_closely = 16;

  // Of each variant keep its nearest ones.
  std::vector<std::vector<Pair>> nearest(variants.size());
  std::vector<double> sums(variants.size(), 0.0);
  parallel_for(variants.size(), {}, [&](std::size_t i) {
    std::vector<Pair> pairs = pairs_of(variants, i);
    for (const Pair& pair : pairs) sums[i] += pair.distance;
    std::sort(pairs.begin(), pairs.end(), nearer);
    pairs.resize(std::min(pairs.size(), looked_at_closely));
    nearest[i] = std::move(pairs);
  });
  std::vector<Pair> all;
  VariantDistances result;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    all.insert(all.end(), nearest[i].begin(), nearest[i].end());
    result.mean += sums[i];
  }
  const auto n = static_cast<double>(variants.size());
  result.mean /= n * (n - 1) / 2;

  // Look closely at the nearest of all.
  std::sort(all.begin(), all.end(), nearer);
  all.resize(std::min(all.size(), looked_at_closely));
  parallel_for(all.size(), {},
               [&](std::size_t i) { all[i].distance = distance_between(all_of(all[i].first), all_of(all[i].second)); });
  const auto min = std::min_element(all.begin(), all.end(), nearer);
  if (min != all.end()) {
    result.min = min->distance;
    result.first = min->first;
    result.second = min->second;
  }
  return result;
}

}  // namespace pomona::bench
