#include "tests/cut/carve/moved_knife.h"

#include <cstdint>

namespace pomona::shapes {

namespace {

constexpr std::int64_t steps_to_one = 64;  // 1 / e

Wide determinant(const WidePoint& u, const WidePoint& v, const WidePoint& w) {
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

WidePoint minus(const WidePoint& a, const WidePoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

std::vector<Corners> triangles_of(const std::vector<glm::dvec3>& place, const std::vector<std::array<int, 3>>& corner) {
  std::vector<Corners> all;
  for (const auto& t : corner) {
    all.push_back({place[static_cast<std::size_t>(t[0])], place[static_cast<std::size_t>(t[1])],
                   place[static_cast<std::size_t>(t[2])]});
  }
  return all;
}

}  // namespace

WidePoint at_rest(const glm::dvec3& place) {
  constexpr std::int64_t one = steps_to_one * steps_to_one * steps_to_one;
  return {one * static_cast<Wide>(place.x), one * static_cast<Wide>(place.y), one * static_cast<Wide>(place.z)};
}

WidePoint moved(const glm::dvec3& place) {
  WidePoint p = at_rest(place);
  p[0] += steps_to_one * steps_to_one;
  p[1] += steps_to_one;
  p[2] += 1;
  return p;
}

int sign_of_volume(const WidePoint& a, const WidePoint& b, const WidePoint& c, const WidePoint& d) {
  const Wide volume = determinant(minus(b, a), minus(c, a), minus(d, a));
  return (volume > 0) - (volume < 0);
}

std::vector<std::vector<Corners>> convex_shapes() {
  const std::vector<std::array<int, 3>> of_box = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const std::vector<std::array<int, 3>> of_octahedron = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                         {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const std::vector<std::array<int, 3>> of_prism = {{0, 1, 2}, {3, 5, 4}, {0, 4, 1}, {0, 3, 4},
                                                    {1, 5, 2}, {1, 4, 5}, {2, 3, 0}, {2, 5, 3}};
  return {
      triangles_of({{1, 1, 1}, {3, 1, 1}, {1, 3, 1}, {3, 3, 1}, {1, 1, 3}, {3, 1, 3}, {1, 3, 3}, {3, 3, 3}}, of_box),
      triangles_of({{4, 2, 2}, {0, 2, 2}, {2, 4, 2}, {2, 0, 2}, {2, 2, 4}, {2, 2, 0}}, of_octahedron),
      triangles_of({{0, 0, 0}, {4, 1, 0}, {1, 4, 1}, {1, 1, 4}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}),
      triangles_of({{1, 0, 1}, {3, 0, 1}, {1, 0, 4}, {1, 4, 1}, {3, 4, 1}, {1, 4, 4}}, of_prism),
  };
}

std::vector<glm::dvec3> whole_places(int low, int high) {
  std::vector<glm::dvec3> places;
  for (int x = low; x <= high; ++x) {
    for (int y = low; y <= high; ++y) {
      for (int z = low; z <= high; ++z) places.emplace_back(x, y, z);
    }
  }
  return places;
}

}  // namespace pomona::shapes
