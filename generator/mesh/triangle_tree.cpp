#include "generator/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/bounding_volume_hierarchy.h"
#include "generator/mesh/ray_passes.h"
#include "generator/mesh/triangle_distance.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

constexpr std::uint32_t leaf_size = 4;

using Corners = TriangleTree::Corners;
using Node = TriangleTree::Node;

/// Nodes still to be visited. Halving 2^32 triangles makes 32 levels, each of which leaves one node behind.
class NodeStack {
 public:
  bool empty() const { return size_ == 0; }
  void push(std::uint32_t node) { nodes_[size_++] = node; }
  std::uint32_t pop() { return nodes_[--size_]; }

 private:
  std::array<std::uint32_t, 64> nodes_;
  std::size_t size_ = 0;
};

Box<double> box_of(const Corners& t) { return box_around(t[0], t[1], t[2]); }

Corners moved(Corners corners, const glm::dvec3& offset) {
  for (glm::dvec3& corner : corners) corner += offset;
  return corners;
}

/// Sorts the triangles along the axis on which their centres spread most; the first half is the left one.
std::uint32_t halve(std::span<Corners> triangles) {
  const auto center = [](const Corners& c) { return c[0] + c[1] + c[2]; };
  Box<double> centers;
  for (const Corners& corners : triangles) centers.add(center(corners));

  // Keys are sorted, which are smaller than triangles; of equal ones the first stays first.
  const int axis = longest_axis(centers.size());
  std::vector<std::pair<double, std::uint32_t>> keys;
  keys.reserve(triangles.size());
  for (const Corners& corners : triangles)
    keys.emplace_back(center(corners)[axis], static_cast<std::uint32_t>(keys.size()));
  std::sort(keys.begin(), keys.end());
  const std::vector<Corners> before(triangles.begin(), triangles.end());
  for (std::size_t i = 0; i < keys.size(); ++i) triangles[i] = before[keys[i].second];
  return static_cast<std::uint32_t>(triangles.size() / 2);
}

/// Coordinate `along` of the triangle's plane over the point.
double plane_at(const Corners& t, const glm::dvec3& normal, const glm::dvec3& point, int along) {
  const glm::dvec3 away = point - t[0];
  const double rest = glm::dot(normal, away) - normal[along] * away[along];
  return t[0][along] - rest / normal[along];
}

}  // namespace

TriangleTree::TriangleTree(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangle) {
  corners_.reserve(triangle.size());
  for (const glm::uvec3& t : triangle) {
    const Corners corners{glm::dvec3(position[t.x]), glm::dvec3(position[t.y]), glm::dvec3(position[t.z])};
    corners_.push_back(corners);
  }
  nodes_ = bounding_volume_hierarchy<Node>(static_cast<std::uint32_t>(corners_.size()), leaf_size,
                                           [&](std::uint32_t first, std::uint32_t count) {
                                             return halve({corners_.data() + first, count});
                                           });
  for (std::size_t i = nodes_.size(); i-- > 0;) fit(static_cast<std::uint32_t>(i));
  own_corners();
}

void TriangleTree::own_corners() {
  std::vector<glm::dvec3> corners;
  corners.reserve(3 * corners_.size());
  for (const Corners& triangle : corners_) corners.insert(corners.end(), triangle.begin(), triangle.end());
  const std::vector<std::uint32_t> first = weld(corners);
  owned_.assign(corners_.size(), 0);
  for (std::size_t i = 0; i < first.size(); ++i)
    if (first[i] == i) owned_[i / 3] = static_cast<std::uint8_t>(owned_[i / 3] | (1u << i % 3));
}

TriangleTree TriangleTree::rotated(const glm::dquat& rotation) const {
  TriangleTree turned = *this;
  const glm::dmat3 matrix = glm::mat3_cast(rotation);
  for (Corners& corners : turned.corners_)
    for (glm::dvec3& corner : corners) corner = matrix * corner;
  for (std::size_t i = nodes_.size(); i-- > 0;) turned.fit(static_cast<std::uint32_t>(i));
  return turned;
}

void TriangleTree::fit(std::uint32_t index) {
  Node& node = nodes_[index];
  node.box = {};
  if (node.count == 0 && !corners_.empty()) {
    node.box.add(nodes_[node.first].box);
    node.box.add(nodes_[node.first + 1].box);
  }
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) node.box.add(box_of(corners_[i]));
}

TriangleTree::Nearest TriangleTree::nearest(const glm::dvec3& point, double within) const {
  Nearest best;
  double best_squared = within * within;
  NodeStack stack;
  if (!empty()) stack.push(0);
  while (!stack.empty()) {
    const Node& node = nodes_[stack.pop()];
    if (squared_distance(node.box, point) >= best_squared) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const glm::dvec3 on = nearest_on_triangle(point, corners_[i]);
      const double d = glm::dot(on - point, on - point);
      if (d < best_squared) best_squared = d, best = {std::sqrt(d), on};
    }
    if (node.count > 0) continue;

    // Look into the nearer child first.
    const double left = squared_distance(nodes_[node.first].box, point);
    const double right = squared_distance(nodes_[node.first + 1].box, point);
    stack.push(left < right ? node.first + 1 : node.first);
    stack.push(left < right ? node.first : node.first + 1);
  }
  return best;
}

bool TriangleTree::contains(const glm::dvec3& point) const {
  int winding = 0;
  NodeStack stack;
  if (!empty()) stack.push(0);
  while (!stack.empty()) {
    const Node& node = nodes_[stack.pop()];
    const Box<double>& b = node.box;
    if (b.high.x < point.x || b.high.y < point.y || b.low.y > point.y || b.high.z < point.z || b.low.z > point.z)
      continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (!ray_passes(corners_[i], point, 0)) continue;
      const glm::dvec3 normal = glm::cross(corners_[i][1] - corners_[i][0], corners_[i][2] - corners_[i][0]);
      if (normal.x != 0 && plane_at(corners_[i], normal, point, 0) > point.x) winding += normal.x > 0 ? 1 : -1;
    }
    if (node.count > 0) continue;
    stack.push(node.first);
    stack.push(node.first + 1);
  }
  return winding > 0;
}

bool TriangleTree::is_near(const Box<double>& box) const {
  NodeStack stack;
  if (!empty()) stack.push(0);
  while (!stack.empty()) {
    const Node& node = nodes_[stack.pop()];
    if (squared_distance(node.box, box) > 0) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (squared_distance(box_of(corners_[i]), box) <= 0) return true;
    if (node.count > 0) continue;
    stack.push(node.first);
    stack.push(node.first + 1);
  }
  return false;
}

double TriangleTree::height_below(const glm::dvec3& point) const {
  // Boxes that lie above the point, or beside the ray down from it, hold nothing that counts.
  double height = -std::numeric_limits<double>::infinity();
  NodeStack stack;
  if (!empty()) stack.push(0);
  while (!stack.empty()) {
    const Node& node = nodes_[stack.pop()];
    const Box<double>& b = node.box;
    if (b.low.y > point.y || b.high.x < point.x || b.low.x > point.x || b.high.z < point.z || b.low.z > point.z)
      continue;

    // Takes the highest crossing of a leaf's triangles that is not above the point.
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (!ray_passes(corners_[i], point, 1)) continue;
      const glm::dvec3 normal = glm::cross(corners_[i][1] - corners_[i][0], corners_[i][2] - corners_[i][0]);
      if (normal.y == 0) continue;
      const double y = plane_at(corners_[i], normal, point, 1);
      if (y <= point.y) height = std::max(height, y);
    }

    // A node that is no leaf has two children, side by side.
    if (node.count > 0) continue;
    stack.push(node.first);
    stack.push(node.first + 1);
  }
  return height;
}

ClosestPair closest(const TriangleTree& a, const TriangleTree& b, const glm::dvec3& offset, double within) {
  ClosestPair best;
  double best_squared = within * within;
  struct Task {
    std::uint32_t a, b;
    double bound;
  };
  std::vector<Task> stack;
  const auto push = [&](std::uint32_t i, std::uint32_t j) {
    const double bound = squared_distance(a.nodes()[i].box, b.nodes()[j].box.moved(offset));
    if (bound < best_squared || (bound == 0 && best_squared > 0)) stack.push_back({i, j, bound});
  };
  if (!a.empty() && !b.empty()) push(0, 0);

  while (!stack.empty() && best_squared > 0) {
    const Task task = stack.back();
    stack.pop_back();
    if (task.bound >= best_squared) continue;
    const Node& na = a.nodes()[task.a];
    const Node& nb = b.nodes()[task.b];

    // Two leaves: compare their triangles.
    if (na.count > 0 && nb.count > 0) {
      for (std::uint32_t j = nb.first; j < nb.first + nb.count; ++j) {
        const Corners other = moved(b.triangles()[j], offset);
        const Box<double> other_box = box_of(other);
        for (std::uint32_t i = na.first; i < na.first + na.count; ++i) {
          if (squared_distance(box_of(a.triangles()[i]), other_box) >= best_squared) continue;
          const auto pair = nearest_on_triangles(a.triangles()[i], other);
          const double d = glm::dot(pair[0] - pair[1], pair[0] - pair[1]);
          if (d < best_squared) best_squared = d, best = {std::sqrt(d), pair[0], pair[1]};
        }
      }
      continue;
    }

    // Open the larger of the two; the nearer child is looked at first.
    const glm::dvec3 size_a = na.box.size(), size_b = nb.box.size();
    const bool open_a = nb.count > 0 || (na.count == 0 && glm::dot(size_a, size_a) >= glm::dot(size_b, size_b));
    const std::size_t before = stack.size();
    for (std::uint32_t k = 0; k < 2; ++k) open_a ? push(na.first + k, task.b) : push(task.a, nb.first + k);
    if (stack.size() == before + 2 && stack[before].bound < stack[before + 1].bound)
      std::swap(stack[before], stack[before + 1]);
  }
  return best;
}

}  // namespace pomona
