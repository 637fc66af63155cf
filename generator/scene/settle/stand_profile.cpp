#include "generator/scene/settle/stand_profile.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/curve.h"

namespace pomona {

namespace {

/// Appends the points that the stretch behind `first`, up to `last`, needs [Douglas & Peucker 1973].
void simplify(const std::vector<glm::dvec2>& samples, std::size_t first, std::size_t last, double tolerance,
              std::vector<glm::dvec2>& kept) {
  std::size_t farthest = first;
  double max_distance = tolerance;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double d = distance_to_segment(samples[i], samples[first], samples[last]);
    if (d > max_distance) max_distance = d, farthest = i;
  }
  if (farthest == first) {
    kept.push_back(samples[last]);
    return;
  }
  simplify(samples, first, farthest, tolerance, kept);
  simplify(samples, farthest, last, tolerance, kept);
}

}  // namespace

std::vector<glm::dvec2> stand_profile(const TriangleTree& stand, double radius, double tolerance) {
  constexpr int count = 1024;
  const double sky = stand.box().high.y + 1;
  std::vector<glm::dvec2> samples;
  for (int i = 0; i <= count; ++i) {
    // Along a direction that is no multiple of any usual step around, so as to meet no mesh edge end on.
    const double r = radius * i / count;
    samples.emplace_back(r, stand.height_below({0.99713 * r + 1e-7, sky, -0.07571 * r + 1e-7}));
  }
  std::vector<glm::dvec2> kept{samples.front()};
  simplify(samples, 0, samples.size() - 1, tolerance, kept);
  return kept;
}

}  // namespace pomona
