#include "generator/scene/settle/broad_phase.h"

#include <bit>

namespace pomona {

BroadPhase::BroadPhase(double cell, std::size_t expected) : width_(cell), buckets_(std::bit_ceil(2 * expected + 64)) {}

void BroadPhase::add(std::size_t body, const glm::dvec3& center) {
  const glm::i64vec3 cell = cell_of(center);
  buckets_[bucket(cell)].push_back({cell, body});
}

std::size_t BroadPhase::bucket(const glm::i64vec3& cell) const {
  // Large odd factors mix the three coordinates; the upper bits of the sum are mixed best.
  const std::uint64_t mixed = static_cast<std::uint64_t>(cell.x) * 0x9e3779b97f4a7c15u +
                              static_cast<std::uint64_t>(cell.y) * 0xc2b2ae3d27d4eb4fu +
                              static_cast<std::uint64_t>(cell.z) * 0x165667b19e3779f9u;
  return (mixed >> 32) & (buckets_.size() - 1);
}

}  // namespace pomona
