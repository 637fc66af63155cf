#include "generator/mesh/crossings/intersections.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "generator/mesh/box.h"

namespace pomona {

namespace {

std::vector<Box<double>> boxes_of(std::span<const Corners> triangles) {
  std::vector<Box<double>> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& t : triangles) boxes.push_back(box_around(t[0], t[1], t[2]));
  return boxes;
}

/// The plane of a triangle. In most cases it tells at once on which side of it a point lies.
class RoundedPlane {
 public:
  explicit RoundedPlane(const Corners& t) : at_(t[0]) {
    const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0];
    normal_ = glm::cross(u, v);
    const double longest = std::max(largest(u), largest(v));
    reach_ = rounding * longest * longest;
  }

  /// The side by the tie rule (tie_rule.h), or 0 where rounding hides it.
  int side(const glm::dvec3& point) const {
    const glm::dvec3 way = point - at_;
    const double height = glm::dot(normal_, way), error = reach_ * largest(way) + underflow;
    return height > error ? 1 : height < -error ? -1 : 0;
  }

 private:
  /// Error bound: six products of three factors, in nine rounded steps, make 6 x 9 x 2^-53; and some reserve.
  static constexpr double rounding = 1e-14;
  static constexpr double underflow = 1e-300;  ///< smaller products may have lost digits

  static double largest(const glm::dvec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

  glm::dvec3 at_, normal_{0};
  double reach_ = 0;
};

std::vector<RoundedPlane> planes_of(std::span<const Corners> triangles) {
  return std::vector<RoundedPlane>(triangles.begin(), triangles.end());
}

using Sides = std::array<int, 3>;  // of a triangle's corners

Sides rounded_sides(const RoundedPlane& plane, const Corners& t) {
  return {plane.side(t[0]), plane.side(t[1]), plane.side(t[2])};
}

bool is_certain(const Sides& side) { return side[0] != 0 && side[1] != 0 && side[2] != 0; }

bool same_side(const Sides& side) { return side[0] == side[1] && side[1] == side[2]; }

/// True if the fruit's edge pq, which meets the knife triangle's plane, passes between its edges.
bool passes_within(const glm::dvec3& p, const glm::dvec3& q, const Corners& knife) {
  const int first = turn(p, q, knife[0], knife[1]);
  return turn(p, q, knife[1], knife[2]) == first && turn(p, q, knife[2], knife[0]) == first;
}

bool passes_within(const Corners& fruit, const glm::dvec3& a, const glm::dvec3& b) {
  const int first = turn(fruit[0], fruit[1], a, b);
  return turn(fruit[1], fruit[2], a, b) == first && turn(fruit[2], fruit[0], a, b) == first;
}

/// \param fruit_plane, knife_plane those of the triangles.
std::optional<Intersection> intersection_of(const Corners& fruit, const RoundedPlane& fruit_plane, const Corners& knife,
                                            const RoundedPlane& knife_plane) {
  Sides of_fruit = rounded_sides(knife_plane, fruit);
  if (is_certain(of_fruit) && same_side(of_fruit)) return std::nullopt;
  Sides of_knife = rounded_sides(fruit_plane, knife);
  if (is_certain(of_knife) && same_side(of_knife)) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    if (of_fruit[i] == 0) of_fruit[i] = side_of_knife(knife, fruit[i]);
    if (of_knife[i] == 0) of_knife[i] = side_of_fruit(fruit, knife[i]);
  }
  if (same_side(of_fruit)) return std::nullopt;

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

std::vector<Intersection> intersections(std::span<const Corners> fruit, std::span<const Corners> knife,
                                        Threads threads) {
  return intersections(fruit, knife, overlapping_boxes(boxes_of(fruit), boxes_of(knife), threads), threads);
}

std::vector<Intersection> intersections(std::span<const Corners> fruit, std::span<const Corners> knife,
                                        std::span<const BoxPair> near, Threads threads) {
  const std::vector<RoundedPlane> fruit_plane = planes_of(fruit), knife_plane = planes_of(knife);
  constexpr std::size_t pairs_a_share = 4096;
  std::vector<std::vector<Intersection>> found(1 + near.size() / pairs_a_share);
  parallel_for(found.size(), threads, [&](std::size_t share) {
    const std::size_t end = std::min(near.size(), (share + 1) * pairs_a_share);
    for (std::size_t i = share * pairs_a_share; i < end; ++i) {
      const auto& [f, k] = near[i];
      std::optional<Intersection> one = intersection_of(fruit[f], fruit_plane[f], knife[k], knife_plane[k]);
      if (!one) continue;
      one->fruit = f;
      one->knife = k;
      found[share].push_back(*one);
    }
  });
  std::vector<Intersection> all;
  for (const std::vector<Intersection>& some : found) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end(), [](const Intersection& a, const Intersection& b) {
    return std::tie(a.fruit, a.knife) < std::tie(b.fruit, b.knife);
  });
  return all;
}

}  // namespace pomona
