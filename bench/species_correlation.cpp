#include "bench/species_correlation.h"

#include <cmath>
#include <numeric>
#include <optional>

namespace pomona::bench {

namespace {

/// The values less their mean, scaled to length 1; nothing if all are equal.
std::optional<std::vector<double>> normalized(std::vector<double> values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  double squares = 0;
  for (double& value : values) {
    value -= mean;
    squares += value * value;
  }
  if (!(squares > 0)) return {};
  for (double& value : values) value /= std::sqrt(squares);
  return values;
}

}  // namespace

std::vector<SpeciesPair> max_correlated(const std::vector<SpeciesSeries>& species) {
  std::vector<std::optional<std::vector<double>>> series;
  for (const SpeciesSeries& one : species) series.push_back(normalized(one.values));
  std::vector<SpeciesPair> max;
  for (std::size_t i = 0; i < species.size(); ++i) {
    if (!series[i]) continue;
    SpeciesPair pair{species[i].species, "", 0};
    for (std::size_t j = 0; j < species.size(); ++j) {
      if (j == i || !series[j]) continue;
      const double correlation = std::inner_product(series[i]->begin(), series[i]->end(), series[j]->begin(), 0.0);
      if (std::abs(correlation) > std::abs(pair.correlation)) pair = {pair.first, species[j].species, correlation};
    }
    max.push_back(pair);
  }
  return max;
}

}  // namespace pomona::bench
