#include "bench/fold_statistics.h"

#include <cmath>
#include <numeric>

#include "generator/base/units.h"
#include "generator/variation/fold_draw.h"
#include "generator/variation/fold_pca.h"
#include "generator/variation/fold_samples.h"
#include "generator/variation/species_key.h"

namespace pomona::bench {

namespace {

using Vector = std::vector<double>;

/// A curve as a vector in metres: radii, and azimuths times the curve's mean radius.
Vector features_of(const PolarCurve& curve, double metres_per_azimuth) {
  Vector features = curve.radius;
  for (const double azimuth : curve.azimuth) features.push_back(azimuth * metres_per_azimuth);
  return features;
}

/// Mean and variance, summed over all features, of vectors given one by one.
class Spread {
 public:
  void add(const Vector& x) {
    if (sum_.empty()) {
      sum_ = squares_ = Vector(x.size(), 0.0);
      origin_ = x;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double d = x[i] - origin_[i];
      sum_[i] += d;
      squares_[i] += d * d;
    }
    count_ += 1;
  }
  double variance() const {
    double total = 0;
    for (std::size_t i = 0; i < sum_.size(); ++i) total += (squares_[i] - sum_[i] * sum_[i] / count_) / (count_ - 1);
    return total;
  }
  double squared_distance_of_mean(const Vector& mean) const {
    double total = 0;
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      const double d = origin_[i] + sum_[i] / count_ - mean[i];
      total += d * d;
    }
    return total;
  }

 private:
  Vector sum_, squares_, origin_;
  double count_ = 0;
};

/// The samples of one surface. A fold of a variant is a weighted sum of samples, so its mean and covariance follow from
/// those of the weights and from the scalar products of the samples.
class SampleSpace {
 public:
  explicit SampleSpace(const FoldSamples& samples) {
    double radius = 0, points = 0;
    for (const PolarCurve& fold : samples.fold) {
      present_.push_back(fold.size() > 0);
      points += static_cast<double>(fold.size());
      radius = std::accumulate(fold.radius.begin(), fold.radius.end(), radius);
    }
    scale_ = radius / points * 2 * pi / static_cast<double>(samples.fold.size());
    std::vector<Vector> x;
    for (const PolarCurve& fold : samples.fold) {
      if (fold.size() > 0) x.push_back(features_of(fold, scale_));
    }
    center(std::move(x));
  }

  const std::vector<bool>& present() const { return present_; }
  std::size_t count() const { return products_.size(); }
  double scale() const { return scale_; }
  const Vector& mean() const { return mean_; }
  double product(std::size_t a, std::size_t b) const {
    return products_[a][b];
  }  ///< the product of two samples less
     ///< their mean

  /// Squared length of a weighted sum of the samples less their mean.
  double squared_length(const Vector& weights) const {
    double total = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t j = 0; j < count(); ++j) total += weights[i] * weights[j] * products_[i][j];
    }
    return total;
  }

  double variance() const {
    double trace = 0;
    for (std::size_t i = 0; i < count(); ++i) trace += products_[i][i];
    return trace / static_cast<double>(count() - 1);
  }

  /// The Frobenius norm, squared, of X' M X where X holds the samples less their mean.
  double squared_norm(const std::vector<Vector>& m) const {
    const std::vector<Vector> mg = times(m, products_);
    double total = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t j = 0; j < count(); ++j) total += mg[i][j] * mg[j][i];
    }
    return total;
  }

 private:
  void center(std::vector<Vector> x) {
    mean_.assign(x.front().size(), 0.0);
    for (const Vector& row : x) {
      for (std::size_t i = 0; i < row.size(); ++i) mean_[i] += row[i] / static_cast<double>(x.size());
    }
    products_.assign(x.size(), Vector(x.size(), 0.0));
    for (std::size_t a = 0; a < x.size(); ++a) {
      for (std::size_t b = 0; b < x.size(); ++b) {
        for (std::size_t i = 0; i < mean_.size(); ++i) products_[a][b] += (x[a][i] - mean_[i]) * (x[b][i] - mean_[i]);
      }
    }
  }

  static std::vector<Vector> times(const std::vector<Vector>& a, const std::vector<Vector>& b) {
    std::vector<Vector> result(a.size(), Vector(b.size(), 0.0));
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        for (std::size_t k = 0; k < b.size(); ++k) result[i][j] += a[i][k] * b[k][j];
      }
    }
    return result;
  }

  std::vector<bool> present_;
  double scale_ = 1;  ///< metres for each share of a fold
  Vector mean_;
  std::vector<Vector> products_;
};

/// Mean and covariance of weights.
class WeightMoments {
 public:
  explicit WeightMoments(std::size_t n) : sum_(n, 0.0), products_(n, Vector(n, 0.0)) {}

  void add(const Vector& w) {
    count_ += 1;
    for (std::size_t i = 0; i < w.size(); ++i) {
      sum_[i] += w[i];
      for (std::size_t j = 0; j < w.size(); ++j) products_[i][j] += w[i] * w[j];
    }
  }
  double count() const { return count_; }
  Vector mean() const {
    Vector mean = sum_;
    for (double& m : mean) m /= count_;
    return mean;
  }
  std::vector<Vector> covariance() const {
    const Vector m = mean();
    std::vector<Vector> c = products_;
    for (std::size_t i = 0; i < m.size(); ++i) {
      for (std::size_t j = 0; j < m.size(); ++j) c[i][j] = (c[i][j] - count_ * m[i] * m[j]) / (count_ - 1);
    }
    return c;
  }

 private:
  double count_ = 0;
  Vector sum_;
  std::vector<Vector> products_;
};

/// The sums over all surfaces, before they are made relative.
struct Sums {
  double variance = 0, squared_covariance = 0, chance_covariance = 0, chance_mean = 0;
  double mean_error = 0, covariance_error = 0, mean_shift = 0;
  double unclipped = 0, clipped = 0, stepped = 0, joined = 0;
};

/// The folds of one surface as the samples are drawn: unclipped weights of each fold that has the surface.
class SurfaceDraws {
 public:
  SurfaceDraws(const FoldSamples& samples) : samples_(samples), space_(samples), weights_(space_.count()) {}

  bool can_vary() const { return space_.count() > 1; }

  void add(const std::vector<FoldDraw>& draws) {
    std::vector<PolarCurve> folds;
    for (FoldDraw draw : draws) {
      if (!space_.present()[draw.source]) {
        folds.emplace_back();
        continue;
      }
      Vector z;
      for (std::size_t i = 0; i < draw.z.size(); ++i) {
        if (space_.present()[i]) z.push_back(draw.z[i]);
      }
      weights_.add(principal_weights(z));
      folds.push_back(blend_of(draw));
      stepped_.add(features_of(folds.back(), space_.scale()));
      draw.rung = 0;
      clipped_.add(features_of(blend_of(draw), space_.scale()));
    }
    if (!samples_.closed) join(folds);
    for (const PolarCurve& fold : folds) {
      if (fold.size() > 0) joined_.add(features_of(fold, space_.scale()));
    }
  }

  void add_to(Sums& sums) const {
    const auto n = static_cast<double>(space_.count());
    std::vector<Vector> exact(space_.count(), Vector(space_.count(), 0.0)), difference = weights_.covariance();
    for (std::size_t i = 0; i < space_.count(); ++i) {
      exact[i][i] = 1 / (n - 1);
      difference[i][i] -= 1 / (n - 1);
    }
    const double variance = space_.variance(), squared = space_.squared_norm(exact);
    sums.variance += variance;
    sums.squared_covariance += squared;
    sums.chance_covariance += (variance * variance + squared) / (weights_.count() - 1);
    sums.chance_mean += variance / weights_.count();
    sums.mean_error += space_.squared_length(weights_.mean());
    sums.covariance_error += space_.squared_norm(difference);
    sums.mean_shift += joined_.squared_distance_of_mean(space_.mean());
    for (std::size_t i = 0; i < space_.count(); ++i) difference[i][i] += 1 / (n - 1);
    sums.unclipped += variance_of(difference);
    sums.clipped += clipped_.variance();
    sums.stepped += stepped_.variance();
    sums.joined += joined_.variance();
  }

 private:
  PolarCurve blend_of(const FoldDraw& draw) const {
    return blended(samples_.fold, coefficients(draw, space_.present()));
  }

  /// The variance of sums of samples whose weights have this covariance.
  double variance_of(const std::vector<Vector>& covariance) const {
    double total = 0;
    for (std::size_t i = 0; i < space_.count(); ++i) {
      for (std::size_t j = 0; j < space_.count(); ++j) total += covariance[i][j] * space_.product(i, j);
    }
    return total;
  }

  const FoldSamples& samples_;
  SampleSpace space_;
  WeightMoments weights_;
  Spread clipped_, stepped_, joined_;
};

}  // namespace

FoldStatistics fold_statistics(const Template& fruit, const VariantSettings& settings,
                               const std::vector<VariantFacts>& variants) {
  const std::vector<FoldSamples> all = fold_samples(fruit);
  Sums sums;
  for (const FoldSamples& samples : all) {
    if (!fruit.surfaces[samples.surface].varies) continue;
    SurfaceDraws surface(samples);
    if (!surface.can_vary()) continue;
    for (std::size_t v = 0; v < variants.size(); ++v) {
      std::vector<FoldDraw> draws = drawn_folds(samples.fold.size(), species_key({v + 1, 0}, fruit.name),
                                                settings.how.amount, static_cast<int>(variants[v].folds.size()));
      for (std::size_t k = 0; k < draws.size(); ++k) draws[k].rung = variants[v].folds[k].rung;
      surface.add(draws);
    }
    surface.add_to(sums);
  }
  FoldStatistics result;
  result.mean_error = std::sqrt(sums.mean_error / sums.variance);
  result.expected_mean_error = std::sqrt(sums.chance_mean / sums.variance);
  result.covariance_error = std::sqrt(sums.covariance_error / sums.squared_covariance);
  result.expected_covariance_error = std::sqrt(sums.chance_covariance / sums.squared_covariance);
  result.unclipped = sums.unclipped / sums.variance;
  result.clipped = sums.clipped / sums.variance;
  result.stepped = sums.stepped / sums.variance;
  result.joined = sums.joined / sums.variance;
  result.mean_shift = std::sqrt(sums.mean_shift / sums.variance);
  return result;
}

}  // namespace pomona::bench
