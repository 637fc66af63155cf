#include "generator/cut/carve/intersections.h"

#include <algorithm>
#include <optional>

#include "generator/mesh/overlapping_boxes.h"

namespace pomona {

namespace {

std::vector<Box<double>> boxes_of(std::span<const Corners> triangles) {
  std::vector<Box<double>> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& t : triangles) boxes.push_back(box_around(t[0], t[1], t[2]));
  return boxes;
}

std::vector<BoxPair> near_pairs(std::span<const Corners> fruit, std::span<const Corners> knife) {
  std::vector<BoxPair> pairs = overlapping_boxes(boxes_of(fruit), boxes_of(knife));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool same_side(const std::array<int, 3>& side) { return side[0] == side[1] && side[1] == side[2]; }

/// True if the fruit's edge pq, which meets the knife triangle's plane, passes between its edges.
bool passes_within(const glm::dvec3& p, const glm::dvec3& q, const Corners& knife) {
  const int first = turn(p, q, knife[0], knife[1]);
  return turn(p, q, knife[1], knife[2]) == first && turn(p, q, knife[2], knife[0]) == first;
}

bool passes_within(const Corners& fruit, const glm::dvec3& a, const glm::dvec3& b) {
  const int first = turn(fruit[0], fruit[1], a, b);
  return turn(fruit[1], fruit[2], a, b) == first && turn(fruit[2], fruit[0], a, b) == first;
}

std::optional<Intersection> intersection_of(const Corners& fruit, const Corners& knife) {
  std::array<int, 3> of_fruit{}, of_knife{};
  for (std::size_t i = 0; i < 3; ++i) of_fruit[i] = side_of_knife(knife, fruit[i]);
  if (same_side(of_fruit)) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) of_knife[i] = side_of_fruit(fruit, knife[i]);

  std::optional<Crossing> from, to;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const auto edge = static_cast<std::uint8_t>(i);
    if (of_fruit[i] != of_fruit[j] && passes_within(fruit[i], fruit[j], knife)) {
      (of_fruit[i] < 0 ? from : to) = Crossing{true, edge};
    }
    if (of_knife[i] != of_knife[j] && passes_within(fruit, knife[i], knife[j])) {
      (of_knife[i] > 0 ? from : to) = Crossing{false, edge};
    }
  }
  if (!from || !to) return std::nullopt;
  return Intersection{0, 0, *from, *to};
}

}  // namespace

std::vector<Intersection> intersections(std::span<const Corners> fruit, std::span<const Corners> knife) {
  std::vector<Intersection> found;
  for (const auto& [f, k] : near_pairs(fruit, knife)) {
    std::optional<Intersection> intersection = intersection_of(fruit[f], knife[k]);
    if (!intersection) continue;
    intersection->fruit = f;
    intersection->knife = k;
    found.push_back(*intersection);
  }
  return found;
}

}  // namespace pomona
