#include "generator/mesh/distance_tree.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/mesh/triangle_distance.h"

namespace pomona {

namespace {

/// Boxes that are still to be visited, nearest on top. 2^31 triangles make at most 31 levels, and each leaves three
/// boxes.
struct Waiting {
  std::uint32_t child;
  float squared;
};

/// The number of points that share a guess; threads take such spans in turn, and no result depends on them.
constexpr std::size_t points_at_once = 512;

/// The children of a node, and their children while there is room: up to four nodes.
std::vector<const TriangleTree::Node*> four_below(const TriangleTree& tree, const TriangleTree::Node& node) {
  std::vector<const TriangleTree::Node*> below{&tree.nodes()[node.first], &tree.nodes()[node.first + 1]};
  for (std::size_t i = 0; i < below.size() && below.size() < 4;) {
    const TriangleTree::Node* const open = below[i];
    if (open->count > 0) {
      ++i;
      continue;
    }
    below[i] = &tree.nodes()[open->first];
    below.push_back(&tree.nodes()[open->first + 1]);
    if (i + 1 < below.size()) ++i;
  }
  return below;
}

}  // namespace

DistanceTree::DistanceTree(const TriangleTree& tree) : corners_(tree.triangles()) {
  if (empty()) return;
  center_ = tree.box().center();
  slack_ = 8 * static_cast<double>(std::numeric_limits<float>::epsilon()) * glm::length(tree.box().size());
  pack(tree, tree.nodes().front());
}

DistanceTree::Boxes DistanceTree::empty_boxes() {
  Boxes boxes{};
  for (Lanes& low : boxes.low) low = Lanes{} + std::numeric_limits<float>::max();
  for (Lanes& high : boxes.high) high = Lanes{} + std::numeric_limits<float>::lowest();
  return boxes;
}

void DistanceTree::put(Boxes& boxes, std::size_t lane, const Below& below) const {
  const std::span<const TriangleTree::Corners> triangles(corners_.data() + below.first, below.count);
  Box<double> box;
  for (const TriangleTree::Corners& t : triangles) box.add(box_around(t[0], t[1], t[2]));
  for (int k = 0; k < 3; ++k) {
    boxes.low[static_cast<std::size_t>(k)][lane] = static_cast<float>(box.low[k] - center_[k] - slack_);
    boxes.high[static_cast<std::size_t>(k)][lane] = static_cast<float>(box.high[k] - center_[k] + slack_);
  }
  put_slab(boxes, lane, triangles);
  boxes.child[lane] = below.child;
}

void DistanceTree::put_slab(Boxes& boxes, std::size_t lane, std::span<const TriangleTree::Corners> triangles) const {
  glm::dvec3 sum(0);
  for (const TriangleTree::Corners& t : triangles) sum += glm::cross(t[1] - t[0], t[2] - t[0]);
  const double size = glm::length(sum);
  if (!(size > 0)) return;  // a slab without a normal is near everything

  // Measure along the normal as rounded to single precision.
  const glm::vec3 normal(sum / size);
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const TriangleTree::Corners& t : triangles) {
    for (const glm::dvec3& corner : t) {
      const double at = glm::dot(glm::dvec3(normal), corner - center_);
      low = std::min(low, at), high = std::max(high, at);
    }
  }
  for (int k = 0; k < 3; ++k) boxes.normal[static_cast<std::size_t>(k)][lane] = normal[k];
  boxes.slab_low[lane] = static_cast<float>(low - slack_);
  boxes.slab_high[lane] = static_cast<float>(high + slack_);
}

DistanceTree::Below DistanceTree::pack_leaf(const TriangleTree::Node& leaf) {
  Boxes boxes = empty_boxes();
  for (std::uint32_t i = 0; i < leaf.count; ++i) put(boxes, i, {leaf.first + i, 1, (leaf.first + i) | is_triangle});
  boxes_.push_back(boxes);
  return {leaf.first, leaf.count, static_cast<std::uint32_t>(boxes_.size() - 1)};
}

DistanceTree::Below DistanceTree::pack(const TriangleTree& tree, const TriangleTree::Node& node) {
  if (node.count > 0) return pack_leaf(node);
  const auto own = static_cast<std::uint32_t>(boxes_.size());
  boxes_.push_back(empty_boxes());

  // The triangles below a node follow each other.
  std::uint32_t first = std::numeric_limits<std::uint32_t>::max(), count = 0;
  std::size_t lane = 0;
  for (const TriangleTree::Node* const child : four_below(tree, node)) {
    const Below below = pack(tree, *child);
    put(boxes_[own], lane++, below);
    first = std::min(first, below.first);
    count += below.count;
  }
  return {first, count, own};
}

DistanceTree::Lanes DistanceTree::Boxes::squared_distances(const std::array<float, 3>& point) const {
  const auto outside = [](Lanes below, Lanes above) {
    const Lanes farther = below > above ? below : above;
    return farther > 0.0f ? farther : Lanes{};
  };
  Lanes squared{}, along{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Lanes apart = outside(low[k] - point[k], point[k] - high[k]);
    squared += apart * apart;
    along += normal[k] * point[k];
  }
  const Lanes apart = outside(slab_low - along, along - slab_high);
  return apart * apart > squared ? apart * apart : squared;
}

TriangleTree::Nearest DistanceTree::nearest(const glm::dvec3& point, double within) const {
  TriangleTree::Nearest best;
  if (empty()) return best;
  double best_squared = within * within;
  const glm::dvec3 from_center = point - center_;
  const std::array<float, 3> single{static_cast<float>(from_center.x), static_cast<float>(from_center.y),
                                    static_cast<float>(from_center.z)};
  // Squares and sums in single precision are off by less than this share.
  constexpr double rounding = 1 + 4e-6;
  const auto in_single = [](double squared) { return static_cast<float>(std::min(squared * rounding, 1e30)); };
  float bound = in_single(best_squared);

  std::array<Waiting, 128> stack;
  std::size_t size = 0;
  stack[size++] = {0, 0};
  while (size > 0) {
    const Waiting next = stack[--size];
    if (next.squared > bound) continue;
    if ((next.child & is_triangle) != 0) {
      const glm::dvec3 on = nearest_on_triangle(point, corners_[next.child & ~is_triangle]);
      const double d = glm::dot(on - point, on - point);
      if (d < best_squared) best_squared = d, bound = in_single(d), best = {std::sqrt(d), on};
      if (best_squared == 0) break;
      continue;
    }

    // Keeps the boxes that may be nearer, the nearest on top.
    const Boxes& boxes = boxes_[next.child];
    const Lanes squared = boxes.squared_distances(single);
    const std::size_t first = size;
    for (std::size_t i = 0; i < width; ++i) {
      if (squared[i] > bound) continue;
      std::size_t at = size++;
      for (; at > first && stack[at - 1].squared < squared[i]; --at) stack[at] = stack[at - 1];
      stack[at] = {boxes.child[i], squared[i]};
    }
  }
  return best;
}

std::vector<double> DistanceTree::distances(std::span<const glm::dvec3> points, double reach, Threads threads) const {
  std::vector<double> distance(points.size(), reach);
  if (empty()) return distance;
  parallel_for((points.size() + points_at_once - 1) / points_at_once, threads, [&](std::size_t span) {
    const std::size_t begin = span * points_at_once, end = std::min(begin + points_at_once, points.size());
    TriangleTree::Nearest last;
    for (std::size_t i = begin; i < end; ++i) {
      // The last nearest point is on the mesh but for rounding, so nothing farther than it can be the nearest.
      const bool knows = std::isfinite(last.distance);
      const double guess = knows ? 1.000001 * glm::distance(last.point, points[i]) + slack_ : reach;
      const TriangleTree::Nearest found = nearest(points[i], std::min(guess, reach));
      if (!std::isfinite(found.distance)) continue;
      last = found;
      distance[i] = found.distance;
    }
  });
  return distance;
}

}  // namespace pomona
