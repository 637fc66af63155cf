#include "generator/diffusion/walk/walk_tally.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pomona {

void WalkTally::add(const WalkBatch& batch) {
  batches_ += 1;
  hits_ += batch.hits;
  hits_squared_ += batch.hits * batch.hits;
  color_ += batch.color;
  color_squared_ += batch.color * batch.color;
  color_hits_ += batch.hits * batch.color;
}

double WalkTally::variance_of_batch() const {
  // Sum over batches of (color - mean * hits)^2, multiplied out.
  const glm::dvec3 m = mean(), residuals = color_squared_ - 2.0 * m * color_hits_ + m * m * hits_squared_;
  const double of_channels = std::max(0.0, (residuals.x + residuals.y + residuals.z) / 3);
  return of_channels * batches_ / (batches_ - 1) * batches_ / (hits_ * hits_);
}

}  // namespace pomona
