#include "generator/base/morton.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/common.hpp>

namespace pomona {

namespace {

constexpr int bits_per_axis = 10;

/// Spreads 21 bits so that two zeros follow each.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001f00000000ffffULL;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
  return (bits | bits << 2) & 0x1249249249249249ULL;
}

struct Keyed {
  std::uint32_t code = 0, index = 0;
};

std::vector<Keyed> codes_of(std::span<const glm::dvec3> points) {
  // Each side of the points' box has as many steps as the bits of one axis can count.
  glm::dvec3 low = points.front(), high = points.front();
  for (const glm::dvec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  constexpr double steps = (1 << bits_per_axis) - 1;
  glm::dvec3 per_length(0);
  for (int axis = 0; axis < 3; ++axis) {
    if (high[axis] > low[axis]) per_length[axis] = steps / (high[axis] - low[axis]);
  }

  // In a code the bits of the three coordinates take turns.
  std::vector<Keyed> keyed;
  keyed.reserve(points.size());
  for (const glm::dvec3& p : points) {
    const glm::dvec3 place = (p - low) * per_length;
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      code |= spread(static_cast<std::uint64_t>(std::min(std::max(place[axis], 0.0), steps))) << axis;
    }
    keyed.push_back({static_cast<std::uint32_t>(code), static_cast<std::uint32_t>(keyed.size())});
  }
  return keyed;
}

}  // namespace

std::uint64_t morton_code(const glm::dvec3& point, const glm::dvec3& low, const glm::dvec3& high) {
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = high[axis] - low[axis];
    const double place = extent > 0 ? (point[axis] - low[axis]) / extent : 0;
    code |= spread(static_cast<std::uint64_t>(place * 2097151.0)) << axis;  // 2^21 - 1
  }
  return code;
}

std::vector<std::uint32_t> morton_order(std::span<const glm::dvec3> points) {
  if (points.empty()) return {};
  std::vector<Keyed> keyed = codes_of(points), sorted(points.size());

  // Radix sort, ten bits at a time.
  for (int shift = 0; shift < 3 * bits_per_axis; shift += bits_per_axis) {
    const auto digit = [&](const Keyed& k) { return k.code >> shift & ((1U << bits_per_axis) - 1); };
    std::array<std::uint32_t, 1U << bits_per_axis> place{};
    for (const Keyed& k : keyed) ++place[digit(k)];
    std::uint32_t sum = 0;
    for (std::uint32_t& entry : place) sum += std::exchange(entry, sum);
    for (const Keyed& k : keyed) sorted[place[digit(k)]++] = k;
    keyed.swap(sorted);
  }

  std::vector<std::uint32_t> order;
  order.reserve(keyed.size());
  for (const Keyed& k : keyed) order.push_back(k.index);
  return order;
}

}  // namespace pomona
