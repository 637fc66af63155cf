#include "generator/mesh/overlapping_boxes.h"

#include <algorithm>
#include <array>

#include "generator/base/morton.h"
#include "generator/mesh/bounding_volume_hierarchy.h"

namespace pomona {

namespace {

/// Neighbouring boxes, coordinate by coordinate, for comparing one box with all of them at once.
template <typename T>
struct Leaf {
  static constexpr std::size_t size = 8;

  std::array<std::array<T, size>, 3> low{}, high{};
  std::array<std::uint32_t, size> index{};
  std::size_t count = 0;
  Box<T> box;

  void add(std::uint32_t i, const Box<T>& added) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis][count] = added.low[axis];
      high[axis][count] = added.high[axis];
    }
    index[count++] = i;
    box.add(added);
  }

  Box<T> box_at(std::size_t i) const {
    return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
  }

  /// Which of its boxes meet this one, as 0 or 1.
  std::array<std::uint32_t, size> intersection(const Box<T>& other) const {
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
template <typename T>
std::vector<Leaf<T>> leaves_of(const std::vector<Box<T>>& boxes) {
  std::vector<glm::dvec3> middles;
  for (const Box<T>& box : boxes) middles.push_back(0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high)));
  std::vector<Leaf<T>> leaves;
  for (const std::uint32_t i : morton_order(middles)) {
    if (leaves.empty() || leaves.back().count == Leaf<T>::size) leaves.emplace_back();
    leaves.back().add(i, boxes[i]);
  }
  return leaves;
}

/// A hierarchy over leaves, halved by their order again and again.
template <typename T>
struct BoxTree {
  struct Node {
    Box<T> box;
    std::uint32_t first = 0;   ///< its leaf; else its left child, which the right one follows
    std::uint32_t count = 0;   ///< 1 where it is one leaf, else 0
    std::uint32_t leaves = 1;  ///< below it
  };

  explicit BoxTree(const std::vector<Box<T>>& boxes) : leaf(leaves_of(boxes)) {
    if (leaf.empty()) return;
    node = bounding_volume_hierarchy<Node>(static_cast<std::uint32_t>(leaf.size()), 1,
                                           [](std::uint32_t, std::uint32_t count) { return count / 2; });
    for (std::size_t i = node.size(); i-- > 0;) {
      Node& n = node[i];
      n.box = n.count == 1 ? leaf[n.first].box : node[n.first].box;
      if (n.count == 1) continue;
      n.box.add(node[n.first + 1].box);
      n.leaves = node[n.first].leaves + node[n.first + 1].leaves;
    }
  }

  std::vector<Leaf<T>> leaf;
  std::vector<Node> node;  ///< empty if there is no box
};

/// Meets the boxes of two trees, which may be one, and calls found(index of one, index of other) for each pair, until
/// it returns false. So do the functions here.
template <typename T, typename Found>
class Intersections {
 public:
  Intersections(const BoxTree<T>& one, const BoxTree<T>& other, const Found& found)
      : one_(one), other_(other), found_(found) {}

  /// Nodes of different trees, or different nodes of one tree.
  bool between(std::uint32_t a, std::uint32_t b) const {
    const auto &m = one_.node[a], &n = other_.node[b];
    if (!m.box.meets(n.box)) return true;
    if (m.count == 1 && n.count == 1) return leaves(one_.leaf[m.first], other_.leaf[n.first]);
    // Take the larger one apart.
    if (m.leaves >= n.leaves) return between(m.first, b) && between(m.first + 1, b);
    return between(a, n.first) && between(a, n.first + 1);
  }

  /// A node of one tree with itself.
  bool within(std::uint32_t a) const {
    const auto& node = one_.node[a];
    if (node.count == 1) return inside(one_.leaf[node.first]);
    return within(node.first) && within(node.first + 1) && between(node.first, node.first + 1);
  }

 private:
  bool leaves(const Leaf<T>& a, const Leaf<T>& b) const {
    for (std::size_t i = 0; i < a.count; ++i) {
      const Box<T> box = a.box_at(i);
      if (box.meets(b.box) && !add(a.index[i], b, b.intersection(box), 0)) return false;
    }
    return true;
  }

  bool inside(const Leaf<T>& leaf) const {
    for (std::size_t i = 0; i < leaf.count; ++i)
      if (!add(leaf.index[i], leaf, leaf.intersection(leaf.box_at(i)), i + 1)) return false;
    return true;
  }

  bool add(std::uint32_t index, const Leaf<T>& leaf, const std::array<std::uint32_t, Leaf<T>::size>& meets,
           std::size_t from) const {
    for (std::size_t i = from; i < leaf.count; ++i)
      if (meets[i] != 0 && !found_(index, leaf.index[i])) return false;
    return true;
  }

  const BoxTree<T>& one_;
  const BoxTree<T>& other_;
  const Found& found_;
};

/// Adds those pairs of children of the two nodes that meet, in the order in which Intersections takes them.
void add_children(const BoxTree<double>& one, std::uint32_t a, const BoxTree<double>& other, std::uint32_t b,
                  std::vector<BoxPair>& pairs) {
  const auto &m = one.node[a], &n = other.node[b];
  if (!m.box.meets(n.box)) return;
  if (m.count == 1 && n.count == 1)
    pairs.emplace_back(a, b);
  else if (m.leaves >= n.leaves)
    pairs.insert(pairs.end(), {{m.first, b}, {m.first + 1, b}});
  else
    pairs.insert(pairs.end(), {{a, n.first}, {a, n.first + 1}});
}

}  // namespace

void visit_overlapping_boxes(const std::vector<Box<float>>& boxes,
                             const std::function<bool(std::uint32_t, std::uint32_t)>& visit) {
  const BoxTree<float> tree(boxes);
  const auto found = [&](std::uint32_t i, std::uint32_t j) { return visit(std::min(i, j), std::max(i, j)); };
  if (!tree.node.empty()) Intersections(tree, tree, found).within(0);
}

std::vector<BoxPair> overlapping_boxes(const std::vector<Box<float>>& boxes) {
  std::vector<BoxPair> pairs;
  visit_overlapping_boxes(boxes, [&](std::uint32_t i, std::uint32_t j) {
    pairs.emplace_back(i, j);
    return true;
  });
  return pairs;
}

std::vector<BoxPair> overlapping_boxes(const std::vector<Box<double>>& one, const std::vector<Box<double>>& other,
                                       Threads threads) {
  const BoxTree<double> a(one), b(other);
  if (a.node.empty() || b.node.empty()) return {};
  constexpr std::size_t shares = 64;
  std::vector<BoxPair> top{{0, 0}};  // nodes
  while (top.size() < shares) {
    std::vector<BoxPair> lower;
    for (const auto& [m, n] : top) add_children(a, m, b, n, lower);
    if (lower == top) break;
    top = std::move(lower);
  }
  std::vector<std::vector<BoxPair>> found(top.size());
  parallel_for(top.size(), threads, [&](std::size_t share) {
    const auto take = [&](std::uint32_t i, std::uint32_t j) {
      found[share].emplace_back(i, j);
      return true;
    };
    Intersections(a, b, take).between(top[share].first, top[share].second);
  });
  std::vector<BoxPair> pairs;
  for (const std::vector<BoxPair>& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  return pairs;
}

}  // namespace pomona
