#include "generator/variation/fold_pca.h"

#include <algorithm>
#include <cmath>

namespace pomona {

namespace {

/// The distance from the mean, in standard deviations, that 95 % of draws along `components` axes do not exceed (chi
/// distribution by Wilson and Hilferty's approximation, within 1.5 %).
double radial_limit(double components) {
  const double spread = 2 / (9 * components);
  const double root = 1 - spread + 1.645 * std::sqrt(spread);
  return std::sqrt(components * root * root * root);
}

}  // namespace

std::vector<double> principal_weights(std::span<const double> z) {
  const auto n = static_cast<double>(z.size());
  if (z.size() < 2) return std::vector<double>(z.size(), 0.0);
  double mean = 0;
  for (const double value : z) mean += value / n;
  std::vector<double> weights;
  for (const double value : z) weights.push_back((value - mean) / std::sqrt(n - 1));
  return weights;
}

std::vector<double> clipped(std::vector<double> weights, const ClipOptions& options) {
  const auto n = static_cast<double>(weights.size());
  if (weights.size() < 2) return weights;

  // Scale down unlikely draws.
  double squares = 0;
  for (double& w : weights) {
    w *= options.gain;
    squares += w * w * (n - 1);
  }
  const double distance = std::sqrt(squares), limit = radial_limit(n - 1);
  double scale = distance > limit ? limit / distance : 1;

  // Stay near the convex hull of the samples.
  for (const double w : weights) {
    if (w < 0) scale = std::min(scale, (1 / n + options.extrapolation) / -w);
  }
  for (double& w : weights) w *= scale;
  return weights;
}

PolarCurve blended(const std::vector<PolarCurve>& samples, std::span<const double> coefficients) {
  PolarCurve sum;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (coefficients[s] == 0 || samples[s].size() == 0) continue;
    sum.azimuth.resize(samples[s].size(), 0.0);
    sum.radius.resize(samples[s].size(), 0.0);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum.azimuth[i] += coefficients[s] * samples[s].azimuth[i];
      sum.radius[i] += coefficients[s] * samples[s].radius[i];
    }
  }
  return sum;
}

void join(std::vector<PolarCurve>& folds) {
  std::vector<double> meeting;
  for (std::size_t k = 0; k < folds.size(); ++k) {
    const PolarCurve& before = folds[(k + folds.size() - 1) % folds.size()];
    meeting.push_back(0.5 * (before.radius.back() + folds[k].radius.front()));
  }
  for (std::size_t k = 0; k < folds.size(); ++k) {
    PolarCurve& fold = folds[k];
    const double first = meeting[k] / fold.radius.front();
    const double last = meeting[(k + 1) % folds.size()] / fold.radius.back();
    for (std::size_t i = 0; i < fold.size(); ++i) {
      const double share = std::clamp(fold.azimuth[i], 0.0, 1.0);
      fold.radius[i] *= (1 - share) * first + share * last;
    }
  }
}

}  // namespace pomona
