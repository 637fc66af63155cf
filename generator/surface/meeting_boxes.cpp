#include "generator/surface/meeting_boxes.h"

#include <algorithm>
#include <numeric>

namespace pomona {

namespace {

/// A tree of boxes that is met with itself.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<FloatBox>& boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> meetings() {
    if (!nodes_.empty()) meet_within(0);
    return std::move(found_);
  }

 private:
  struct Node {
    FloatBox box;
    std::uint32_t first = 0, last = 0;  ///< in order_
    std::uint32_t left = 0, right = 0;  ///< 0 in leaves
    std::uint32_t count() const { return last - first; }
  };
  static constexpr std::uint32_t most_in_leaf = 12;

  std::uint32_t build(std::uint32_t first, std::uint32_t last) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, first, last, 0, 0});
    if (last - first <= most_in_leaf) {
      FloatBox& box = nodes_.back().box;
      for (std::uint32_t i = first; i < last; ++i) box.add(boxes_[order_[i]]);
      return index;
    }
    // Halve them along the longest side.
    FloatBox box;
    for (std::uint32_t i = first; i < last; ++i) box.add(boxes_[order_[i]]);
    const glm::vec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const float at_a = boxes_[a].low[axis] + boxes_[a].high[axis];
                       const float at_b = boxes_[b].low[axis] + boxes_[b].high[axis];
                       return at_a != at_b ? at_a < at_b : a < b;
                     });
    const std::uint32_t left = build(first, middle), right = build(middle, last);
    nodes_[index].left = left;
    nodes_[index].right = right;
    nodes_[index].box.add(nodes_[left].box);
    nodes_[index].box.add(nodes_[right].box);
    return index;
  }

  void meet_within(std::uint32_t index) {
    const Node& node = nodes_[index];
    if (node.left != 0) {
      meet_within(node.left);
      meet_within(node.right);
      meet_between(node.left, node.right);
      return;
    }
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      for (std::uint32_t j = i + 1; j < node.last; ++j) meet(order_[i], order_[j]);
    }
  }

  void meet_between(std::uint32_t a, std::uint32_t b) {
    if (!nodes_[a].box.meets(nodes_[b].box)) return;
    if (nodes_[a].left == 0 && nodes_[b].left == 0) {
      for (std::uint32_t i = nodes_[a].first; i < nodes_[a].last; ++i) {
        for (std::uint32_t j = nodes_[b].first; j < nodes_[b].last; ++j) meet(order_[i], order_[j]);
      }
      return;
    }
    // Take the larger one apart.
    if (nodes_[b].left != 0 && (nodes_[a].left == 0 || nodes_[b].count() > nodes_[a].count())) std::swap(a, b);
    meet_between(nodes_[a].left, b);
    meet_between(nodes_[a].right, b);
  }

  void meet(std::uint32_t i, std::uint32_t j) {
    if (boxes_[i].meets(boxes_[j])) found_.emplace_back(std::min(i, j), std::max(i, j));
  }

  const std::vector<FloatBox>& boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found_;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_boxes(const std::vector<FloatBox>& boxes) {
  return BoxTree(boxes).meetings();
}

}  // namespace pomona
