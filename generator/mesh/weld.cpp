#include "generator/mesh/weld.h"

#include <algorithm>

namespace pomona {

namespace {

/// A vertex as it is sorted; keys beside each other sort several times faster than keys looked up.
template <typename Vec>
struct Place {
  Vec position;
  std::uint32_t vertex;

  bool operator<(const Place& other) const {
    if (position.x != other.position.x) return position.x < other.position.x;
    if (position.y != other.position.y) return position.y < other.position.y;
    if (position.z != other.position.z) return position.z < other.position.z;
    return vertex < other.vertex;
  }
};

template <typename Vec>
std::vector<std::uint32_t> first_at_place(std::span<const Vec> positions) {
  std::vector<Place<Vec>> places;
  places.reserve(positions.size());
  for (const Vec& p : positions) places.push_back({p, static_cast<std::uint32_t>(places.size())});
  std::sort(places.begin(), places.end());

  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool same = i > 0 && places[i].position == places[i - 1].position;
    first[places[i].vertex] = same ? first[places[i - 1].vertex] : places[i].vertex;
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
