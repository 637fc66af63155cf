#include "generator/scene/settle/height_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pomona {

HeightMap::HeightMap(const Dish& dish, double half, double cell)
    : half_(static_cast<float>(half)), cell_(static_cast<float>(cell)), count_(static_cast<int>(2 * half / cell) + 2) {
  // The corner of a cell that is farthest out is the highest, as bowls go. Of other dishes all are asked.
  const auto farthest = [&](int i) { return std::fabs((i + 0.5) * cell - half) + 0.5 * cell; };
  const auto highest = [&](double x, double z) {
    double height = dish.height(x + 0.5 * cell, z + 0.5 * cell);
    for (const double s : {0.0, 1.0})
      for (const double t : {0.0, 1.0}) height = std::max(height, dish.height(x + s * cell, z + t * cell));
    return height;
  };
  height_.reserve(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_));
  for (int j = 0; j < count_; ++j) {
    for (int i = 0; i < count_; ++i) {
      const double height =
          dish.form() ? highest(i * cell - half, j * cell - half) : dish.height(farthest(i), farthest(j));
      height_.push_back(static_cast<float>(height));
    }
  }
}

std::size_t HeightMap::at(float x, float z) const {
  const auto cell = [&](float p) { return std::clamp(static_cast<int>((p + half_) / cell_), 0, count_ - 1); };
  return static_cast<std::size_t>(cell(z)) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(cell(x));
}

void HeightMap::raise(const RigidBody& body) {
  for (const glm::vec3& sample : body.shape->samples.point) {
    const glm::vec3 p = body.matrix * sample + glm::vec3(body.center);
    float& height = height_[at(p.x, p.z)];
    height = std::max(height, p.y);
  }
}

float HeightMap::resting_height(const RigidBody& body, float x, float z) const {
  float height = std::numeric_limits<float>::lowest();
  for (const glm::vec3& sample : body.shape->samples.point) {
    const glm::vec3 p = body.matrix * sample;
    height = std::max(height, height_[at(p.x + x, p.z + z)] - p.y);
  }
  return height;
}

}  // namespace pomona
