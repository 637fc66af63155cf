#include "generator/cut/carve/meetings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

namespace pomona {

namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

std::vector<Box> boxes_of(std::span<const Corners> triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Corners& t = triangles[i];
    CGAL::Bbox_3 box;
    for (const glm::dvec3& p : t) box += CGAL::Bbox_3(p.x, p.y, p.z, p.x, p.y, p.z);
    boxes.emplace_back(box, i);
  }
  return boxes;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::vector<Pair> near_pairs(std::span<const Corners> fruit, std::span<const Corners> knife) {
  std::vector<Pair> pairs;
  std::vector<Box> of_fruit = boxes_of(fruit), of_knife = boxes_of(knife);
  CGAL::box_intersection_d(of_fruit.begin(), of_fruit.end(), of_knife.begin(), of_knife.end(),
                           [&](const Box& f, const Box& k) { pairs.emplace_back(f.info(), k.info()); });
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

std::optional<Meeting> meeting_of(const Corners& fruit, const Corners& knife) {
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
  return Meeting{0, 0, *from, *to};
}

}  // namespace

std::vector<Meeting> meetings(std::span<const Corners> fruit, std::span<const Corners> knife) {
  std::vector<Meeting> found;
  for (const auto& [f, k] : near_pairs(fruit, knife)) {
    std::optional<Meeting> meeting = meeting_of(fruit[f], knife[k]);
    if (!meeting) continue;
    meeting->fruit = f;
    meeting->knife = k;
    found.push_back(*meeting);
  }
  return found;
}

}  // namespace pomona
