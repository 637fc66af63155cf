#include "generator/mesh/meeting_boxes.h"

#include <algorithm>
#include <array>
#include <span>

#include "generator/base/morton.h"

namespace pomona {

namespace {

/// Neighbouring boxes, coordinate by coordinate, for comparing one box with all of them at once.
struct Leaf {
  static constexpr std::size_t size = 8;

  std::array<std::array<float, size>, 3> low{}, high{};
  std::array<std::uint32_t, size> index{};
  std::size_t count = 0;
  Box<float> box;

  void add(std::uint32_t i, const Box<float>& added) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis][count] = added.low[axis];
      high[axis][count] = added.high[axis];
    }
    index[count++] = i;
    box.add(added);
  }

  Box<float> box_at(std::size_t i) const {
    return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
  }

  /// Which of its boxes meet this one, as 0 or 1.
  std::array<std::uint32_t, size> meeting(const Box<float>& other) const {
    std::array<std::uint32_t, size> meets{};
    for (std::size_t i = 0; i < size; ++i) {
      meets[i] = static_cast<std::uint32_t>(low[0][i] <= other.high.x) &
                 static_cast<std::uint32_t>(other.low.x <= high[0][i]) &
                 static_cast<std::uint32_t>(low[1][i] <= other.high.y) &
                 static_cast<std::uint32_t>(other.low.y <= high[1][i]) &
                 static_cast<std::uint32_t>(low[2][i] <= other.high.z) &
                 static_cast<std::uint32_t>(other.low.z <= high[2][i]);
    }
    return meets;
  }
};

/// Along a Morton curve: what follows each other is near each other.
std::vector<Leaf> leaves_of(const std::vector<Box<float>>& boxes) {
  std::vector<glm::dvec3> middles;
  for (const Box<float>& box : boxes) middles.push_back(0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high)));
  std::vector<Leaf> leaves;
  for (const std::uint32_t i : morton_order(middles)) {
    if (leaves.empty() || leaves.back().count == Leaf::size) leaves.emplace_back();
    leaves.back().add(i, boxes[i]);
  }
  return leaves;
}

/// A tree of boxes that is met with itself: leaves halved by their order, again and again.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box<float>>& boxes) : leaves_(leaves_of(boxes)) {
    if (!leaves_.empty()) build(0, static_cast<std::uint32_t>(leaves_.size()));
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> meetings() {
    if (!nodes_.empty()) meet_within(0);
    return std::move(found_);
  }

 private:
  struct Node {
    Box<float> box;
    std::uint32_t leaf = 0, count = 0;  ///< the first of its leaves, and how many
    std::uint32_t left = 0, right = 0;  ///< 0 where there is one leaf
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({leaves_[first].box, first, count, 0, 0});
    if (count == 1) return index;
    const std::uint32_t left = build(first, count / 2), right = build(first + count / 2, count - count / 2);
    Box<float> box = nodes_[left].box;
    box.add(nodes_[right].box);
    nodes_[index] = {box, first, count, left, right};
    return index;
  }

  void meet_within(std::uint32_t index) {
    const Node& node = nodes_[index];
    if (node.count == 1) return meet_inside(leaves_[node.leaf]);
    meet_within(node.left);
    meet_within(node.right);
    meet_between(node.left, node.right);
  }

  void meet_between(std::uint32_t a, std::uint32_t b) {
    if (!nodes_[a].box.meets(nodes_[b].box)) return;
    if (nodes_[a].count == 1 && nodes_[b].count == 1)
      return meet_leaves(leaves_[nodes_[a].leaf], leaves_[nodes_[b].leaf]);
    // Take the larger one apart.
    if (nodes_[b].count > nodes_[a].count) std::swap(a, b);
    meet_between(nodes_[a].left, b);
    meet_between(nodes_[a].right, b);
  }

  void meet_inside(const Leaf& leaf) {
    for (std::size_t i = 0; i < leaf.count; ++i) add(leaf.index[i], leaf, leaf.meeting(leaf.box_at(i)), i + 1);
  }

  void meet_leaves(const Leaf& a, const Leaf& b) {
    for (std::size_t i = 0; i < a.count; ++i) {
      const Box<float> box = a.box_at(i);
      if (box.meets(b.box)) add(a.index[i], b, b.meeting(box), 0);
    }
  }

  void add(std::uint32_t one, const Leaf& leaf, const std::array<std::uint32_t, Leaf::size>& meets, std::size_t from) {
    for (std::size_t i = from; i < leaf.count; ++i) {
      if (meets[i] != 0) found_.emplace_back(std::min(one, leaf.index[i]), std::max(one, leaf.index[i]));
    }
  }

  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found_;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_boxes(const std::vector<Box<float>>& boxes) {
  return BoxTree(boxes).meetings();
}

}  // namespace pomona
