// The tally of the walks from one point: what they have met, and the error of their mean.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace pomona {

/// Walks that began together: their colours summed over those that met a surface, and how many did.
struct WalkBatch {
  glm::dvec3 color{0};
  double hits = 0;
};

/// Sums over independent batches. The mean is the ratio of two sums; its variance that of the ratio to first order.
class WalkTally {
 public:
  void add(const WalkBatch& batch);

  double batches() const { return batches_; }
  double hits() const { return hits_; }
  glm::dvec3 mean() const { return color_ / hits_; }

  /// The variance of one batch's part in the mean, averaged over channels: the mean's variance times the number of
  /// batches.
  double variance_of_batch() const;

 private:
  double batches_ = 0, hits_ = 0, hits_squared_ = 0;
  glm::dvec3 color_{0}, color_squared_{0}, color_hits_{0};
};

}  // namespace pomona
