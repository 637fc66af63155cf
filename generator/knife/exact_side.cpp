#include "generator/knife/exact_side.h"

#include <array>
#include <cmath>
#include <limits>

namespace pomona {

namespace {

/// An exact sum: its rounded value, and the rounding error.
struct ExactSum {
  double value = 0, rest = 0;
};

ExactSum sum_of(double a, double b) {
  const double sum = a + b;
  const double from_b = sum - a, from_a = sum - from_b;
  return {sum, (a - from_a) + (b - from_b)};
}

/// High and low half of a double's digits [Dekker 1971].
ExactSum halves_of(double a) {
  const double scaled = 134217729.0 * a;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

ExactSum product_of(double a, double b) {
  const double product = a * b;
  const ExactSum x = halves_of(a), y = halves_of(b);
  const double error = ((product - x.value * y.value) - x.rest * y.value) - x.value * y.rest;
  return {product, x.rest * y.rest - error};
}

/// Seven numbers without overlap, the smallest first, that add up to a sum.
class Expansion {
 public:
  void add(double term) {
    for (std::size_t i = 0; i < count_; ++i) {
      const ExactSum sum = sum_of(term, parts_[i]);
      parts_[i] = sum.rest;
      term = sum.value;
    }
    parts_[count_++] = term;
  }

  /// The parts do not overlap, so none changes the sign that the larger ones have given.
  double value() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += parts_[i];
    return sum;
  }

 private:
  std::array<double, 7> parts_{};
  std::size_t count_ = 0;
};

}  // namespace

double exact_distance(const CuttingPlane& plane, const glm::dvec3& point) {
  // Tries plain doubles first. Three products and three sums err by at most 4 roundings of the sum of magnitudes; a
  // distance a million times as large has its sign and six digits right.
  const glm::dvec3 terms = plane.normal * point;
  const double distance = terms.x + terms.y + terms.z - plane.offset;
  const double magnitude = std::fabs(terms.x) + std::fabs(terms.y) + std::fabs(terms.z) + std::fabs(plane.offset);
  const double error = 4 * std::numeric_limits<double>::epsilon() * magnitude;
  if (std::fabs(distance) > 1e6 * error) return distance;

  // Else adds up the products and their rounding errors exactly.
  Expansion sum;
  sum.add(-plane.offset);
  for (int axis = 0; axis < 3; ++axis) {
    const ExactSum product = product_of(plane.normal[axis], point[axis]);
    sum.add(product.rest);
    sum.add(product.value);
  }
  return sum.value();
}

}  // namespace pomona
