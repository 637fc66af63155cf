// Whether species vary independently: the correlation of their sizes and proportions at equal seeds.
#pragma once

#include <string>
#include <vector>

namespace pomona::bench {

/// The same quantity of the variants of one species, by seed.
struct SpeciesSeries {
  std::string species;
  std::vector<double> values;
};

/// Two species, and Pearson's correlation between their series.
struct SpeciesPair {
  std::string first, second;
  double correlation = 0;
};

/// For each species the pair with the greatest correlation, in absolute value. Species that do not vary in it have
/// none. Series must be equally long.
std::vector<SpeciesPair> max_correlated(const std::vector<SpeciesSeries>& species);

}  // namespace pomona::bench
