#include "generator/variation/texture_synthesis.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace pomona {

namespace {

/// One value per position and feature: all features of a position lie side by side.
struct FeatureTable {
  std::size_t features = 0;
  std::vector<double> value;

  double squared_distance(std::size_t a, std::size_t b) const {
    double sum = 0;
    for (std::size_t f = 0; f < features; ++f) {
      const double difference = value[a * features + f] - value[b * features + f];
      sum += difference * difference;
    }
    return sum;
  }
};

/// Divides by the standard deviation; a constant feature becomes 0.
CyclicSignal normalised(CyclicSignal feature) {
  const auto n = static_cast<double>(feature.size());
  double mean = 0, variance = 0;
  for (const double v : feature) mean += v / n;
  for (const double v : feature) variance += (v - mean) * (v - mean) / n;
  const double scale = 1 / (std::sqrt(variance) + 1e-12);
  for (double& v : feature) v = (v - mean) * scale;
  return feature;
}

CyclicSignal slope(const CyclicSignal& band) {
  const std::size_t n = band.size();
  CyclicSignal result(n);
  for (std::size_t i = 0; i < n; ++i) result[i] = 0.5 * (band[(i + 1) % n] - band[(i + n - 1) % n]);
  return result;
}

/// The features of one level: value and slope of each channel's band. They stand for the oriented filters of
/// the two-dimensional original.
FeatureTable features_of(const std::vector<LaplacianPyramid>& pyramids, std::size_t level) {
  std::vector<CyclicSignal> columns;
  for (const LaplacianPyramid& pyramid : pyramids) {
    columns.push_back(normalised(pyramid[level]));
    columns.push_back(normalised(slope(pyramid[level])));
  }
  FeatureTable table{columns.size(), {}};
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    for (const CyclicSignal& column : columns) table.value.push_back(column[i]);
  }
  return table;
}

std::vector<std::size_t> shifted_identity(std::size_t n, std::size_t shift) {
  std::vector<std::size_t> map(n);
  for (std::size_t i = 0; i < n; ++i) map[i] = (i + shift) % n;
  return map;
}

/// Normal numbers of variance 1 / n: every frequency then keeps its power on average.
std::vector<double> mixture_of_turns(std::size_t n, const RandomStream& stream) {
  std::vector<double> turns(n);
  for (std::size_t i = 0; i < n; ++i) turns[i] = stream.normal(i) / std::sqrt(static_cast<double>(n));
  return turns;
}

/// For every value, the child on the same side of its parent.
std::vector<std::size_t> natural_children(const std::vector<std::size_t>& parents) {
  std::vector<std::size_t> map(2 * parents.size());
  for (std::size_t i = 0; i < map.size(); ++i) map[i] = 2 * parents[i / 2] + i % 2;
  return map;
}

/// Sums of squared distances between the parent structures of outputs (rows) and sources (columns).
class ParentDistances {
 public:
  explicit ParentDistances(std::size_t coarsest) : n_(coarsest), sum_(coarsest * coarsest, 0.0) {}

  /// Goes one level down: adds the `features` of the level whose map is `parents`.
  void descend(const FeatureTable& features, const std::vector<std::size_t>& parents) {
    std::vector<double> finer(4 * n_ * n_);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) {
        const double sum = sum_[i * n_ + j] + features.squared_distance(parents[i], j);
        for (const std::size_t row : {2 * i, 2 * i + 1}) {
          for (const std::size_t column : {2 * j, 2 * j + 1}) finer[row * 2 * n_ + column] = sum;
        }
      }
    }
    n_ *= 2;
    ++levels_;
    sum_ = std::move(finer);
  }

  /// Sources of the same parity whose parent structure is within the threshold, in order. The parity rule keeps
  /// siblings apart; without it a threshold of 0 would already scramble the curve.
  std::vector<std::size_t> candidates(std::size_t output, double threshold, std::size_t features) const {
    const double max = threshold * threshold * static_cast<double>(features * levels_);
    std::vector<std::size_t> found;
    for (std::size_t j = output % 2; j < n_; j += 2) {
      if (sum_[output * n_ + j] <= max) found.push_back(j);
    }
    return found;
  }

 private:
  std::size_t n_;
  std::size_t levels_ = 0;
  std::vector<double> sum_;
};

}  // namespace

SourceMap draw_source_map(const std::vector<CyclicSignal>& channels, VariantKey key, const SynthesisOptions& options) {
  std::vector<LaplacianPyramid> pyramids;
  for (const CyclicSignal& channel : channels) pyramids.push_back(decompose(channel));
  const std::size_t top = pyramids.front().size() - 1;
  const std::size_t coarsest = pyramids.front()[top].size();
  const auto stream = [&](std::size_t level) { return RandomStream(key, "vary/loop/level" + std::to_string(level)); };

  // Rotate the coarsest level.
  SourceMap map;
  map.level.resize(top + 1);
  const std::size_t shift = stream(top).below(0, coarsest);
  map.level[top] = shifted_identity(coarsest, shift);
  map.turns = options.mix_turns ? mixture_of_turns(coarsest, stream(top)) : std::vector<double>(coarsest, 0.0);
  if (!options.mix_turns) map.turns[shift] = 1;
  map.fewest_candidates = coarsest;

  // Fill each finer level from sources whose ancestors look like the output's.
  ParentDistances distances(coarsest);
  for (std::size_t level = top; level-- > 0;) {
    const std::vector<std::size_t>& parents = map.level[level + 1];
    std::vector<std::size_t>& chosen = map.level[level];
    chosen = natural_children(parents);
    if (level < static_cast<std::size_t>(options.smooth_levels)) continue;
    const FeatureTable features = features_of(pyramids, level + 1);
    distances.descend(features, parents);
    const RandomStream draws = stream(level);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const auto candidates = distances.candidates(i, options.threshold, features.features);
      map.fewest_candidates = std::min(map.fewest_candidates, candidates.size());
      if (!candidates.empty()) chosen[i] = candidates[draws.below(i, candidates.size())];
    }
  }
  return map;
}

CyclicSignal copied(const CyclicSignal& channel, const SourceMap& map) {
  const LaplacianPyramid source = decompose(channel);
  LaplacianPyramid target = source;
  for (std::size_t level = 0; level + 1 < source.size(); ++level) {
    for (std::size_t i = 0; i < source[level].size(); ++i) target[level][i] = source[level][map.level[level][i]];
  }
  const CyclicSignal& coarse = source.back();
  const std::size_t n = coarse.size();
  const double mean = std::accumulate(coarse.begin(), coarse.end(), 0.0) / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    target.back()[i] = mean;
    for (std::size_t s = 0; s < n; ++s) target.back()[i] += map.turns[s] * (coarse[(i + s) % n] - mean);
  }
  return compose(target);
}

}  // namespace pomona
