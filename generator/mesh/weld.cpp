#include "generator/mesh/weld.h"

#include <bit>
#include <cstddef>

namespace pomona {

namespace {

/// Adding zero makes -0 and 0 the same.
std::uint64_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value + 0.0f); }
std::uint64_t bits_of(double value) { return std::bit_cast<std::uint64_t>(value + 0.0); }

template <typename Vec>
std::size_t hash_of(const Vec& position) {
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) {
    hash = (hash ^ bits_of(position[k])) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

/// Looks every vertex up in a table of at least twice as many places, of which the first free one from its hash on is
/// its own.
template <typename Vec>
std::vector<std::uint32_t> first_at_place(std::span<const Vec> positions) {
  constexpr std::uint32_t free = 0xffffffffu;
  std::vector<std::uint32_t> table(std::bit_ceil(2 * positions.size() + 1), free);
  const std::size_t mask = table.size() - 1;
  std::vector<std::uint32_t> first(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    std::size_t at = hash_of(positions[v]) & mask;
    while (table[at] != free && positions[table[at]] != positions[v]) at = (at + 1) & mask;
    if (table[at] == free) table[at] = v;
    first[v] = table[at];
  }
  return first;
}

}  // namespace

std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions) { return first_at_place(positions); }
std::vector<std::uint32_t> weld(std::span<const glm::dvec3> positions) { return first_at_place(positions); }

std::vector<glm::uvec3> welded_triangles(std::span<const std::uint32_t> first, std::span<const glm::uvec3> triangles) {
  std::vector<glm::uvec3> welded;
  welded.reserve(triangles.size());
  for (const glm::uvec3& t : triangles) welded.emplace_back(first[t.x], first[t.y], first[t.z]);
  return welded;
}

}  // namespace pomona
