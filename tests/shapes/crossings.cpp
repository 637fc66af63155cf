#include "tests/shapes/crossings.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <glm/common.hpp>

#include "generator/base/disjoint_sets.h"

namespace pomona {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Corners = std::array<Point, 3>;

/// On which side of the triangle a point lies: 1, 0 or -1. Corners are on it without being looked at, which exact
/// arithmetic would take long over.
int side_of(const Corners& t, const Point& p) {
  if (p == t[0] || p == t[1] || p == t[2]) return 0;
  return CGAL::orientation(t[0], t[1], t[2], p);
}

bool pierces(const Point& p, const Point& q, const Corners& t) {
  const int first = side_of({p, q, t[0]}, t[1]);
  return first != 0 && side_of({p, q, t[1]}, t[2]) == first && side_of({p, q, t[2]}, t[0]) == first;
}

std::array<int, 3> sides_of(const Corners& plane, const Corners& t) {
  return {side_of(plane, t[0]), side_of(plane, t[1]), side_of(plane, t[2])};
}

bool on_both(const std::array<int, 3>& sides) {
  return std::min({sides[0], sides[1], sides[2]}) < 0 && std::max({sides[0], sides[1], sides[2]}) > 0;
}

/// True if an edge of t, whose corners lie on these sides of s, goes through s.
bool edge_pierces(const Corners& t, const std::array<int, 3>& sides, const Corners& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (sides[i] * sides[j] < 0 && pierces(t[i], t[j], s)) return true;
  }
  return false;
}

bool cross(const Corners& s, const Corners& t) {
  const std::array<int, 3> sides_t = sides_of(s, t);
  if (!on_both(sides_t)) return false;
  const std::array<int, 3> sides_s = sides_of(t, s);
  if (!on_both(sides_s)) return false;
  return edge_pierces(t, sides_t, s) || edge_pierces(s, sides_s, t);
}

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};

  void add(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool meets(const Box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
           b.low.z <= high.z;
  }
};

/// A tree of boxes over triangles, met with itself.
class SelfMeetingTree {
 public:
  explicit SelfMeetingTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
  }

  /// Calls body(i, j) once for every two different boxes that meet.
  template <typename Body>
  void for_meeting(const Body& body) const {
    if (!nodes_.empty()) within(0, body);
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0, last = 0;  ///< in order_
    std::uint32_t left = 0, right = 0;  ///< 0 in leaves
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, first, last, 0, 0});
    Box box;
    for (std::uint32_t i = first; i < last; ++i) {
      box.add(boxes_[order_[i]].low);
      box.add(boxes_[order_[i]].high);
    }
    nodes_[index].box = box;
    if (last - first <= 4) return index;

    // Halve them along the longest side.
    const glm::vec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const auto middle = order_.begin() + (first + last) / 2;
    std::nth_element(order_.begin() + first, middle, order_.begin() + last, [&](std::uint32_t a, std::uint32_t b) {
      const float at_a = boxes_[a].low[axis] + boxes_[a].high[axis], at_b = boxes_[b].low[axis] + boxes_[b].high[axis];
      return at_a != at_b ? at_a < at_b : a < b;
    });
    const std::uint32_t left = build(first, (first + last) / 2), right = build((first + last) / 2, last);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  template <typename Body>
  void within(std::uint32_t index, const Body& body) const {
    const Node& node = nodes_[index];
    if (node.left == 0) {
      for (std::uint32_t i = node.first; i < node.last; ++i) {
        for (std::uint32_t j = i + 1; j < node.last; ++j) visit(order_[i], order_[j], body);
      }
      return;
    }
    within(node.left, body);
    within(node.right, body);
    between(node.left, node.right, body);
  }

  template <typename Body>
  void between(std::uint32_t a, std::uint32_t b, const Body& body) const {
    const Node &first = nodes_[a], &second = nodes_[b];
    if (!first.box.meets(second.box)) return;
    if (first.left == 0 && second.left == 0) {
      for (std::uint32_t i = first.first; i < first.last; ++i) {
        for (std::uint32_t j = second.first; j < second.last; ++j) visit(order_[i], order_[j], body);
      }
      return;
    }
    const bool split_first =
        second.left == 0 || (first.left != 0 && first.last - first.first > second.last - second.first);
    const Node& split = split_first ? first : second;
    const std::uint32_t rest = split_first ? b : a;
    between(split.left, rest, body);
    between(split.right, rest, body);
  }

  template <typename Body>
  void visit(std::uint32_t i, std::uint32_t j, const Body& body) const {
    if (boxes_[i].meets(boxes_[j])) body(std::min(i, j), std::max(i, j));
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

int common_corners(const glm::uvec3& a, const glm::uvec3& b) {
  int count = 0;
  for (int i = 0; i < 3; ++i) count += a[i] == b.x || a[i] == b.y || a[i] == b.z;
  return count;
}

}  // namespace

Crossings crossing_triangles(const DiffusionSurfaces& surfaces) {
  DisjointSets pieces(surfaces.vertex_count());
  std::vector<Corners> corners;
  std::vector<Box> boxes;
  for (const glm::uvec3& v : surfaces.triangle) {
    pieces.join(v.x, v.y);
    pieces.join(v.x, v.z);
    Box box;
    Corners triangle;
    for (int i = 0; i < 3; ++i) {
      const glm::vec3& p = surfaces.position[v[i]];
      box.add(p);
      triangle[static_cast<std::size_t>(i)] = Point(p.x, p.y, p.z);
    }
    boxes.push_back(box);
    corners.push_back(triangle);
  }

  Crossings found;
  SelfMeetingTree(std::move(boxes)).for_meeting([&](std::uint32_t s, std::uint32_t t) {
    if (common_corners(surfaces.triangle[s], surfaces.triangle[t]) > 1 || !cross(corners[s], corners[t])) return;
    if (pieces.root(surfaces.triangle[s].x) == pieces.root(surfaces.triangle[t].x)) {
      ++found.within[surfaces.surface[s]];
    } else {
      ++found.between[std::minmax(surfaces.surface[s], surfaces.surface[t])];
    }
  });
  return found;
}

}  // namespace pomona
