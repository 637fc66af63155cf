#include "render/diffusion/ray_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace pomona {

namespace {

/// Boxes are this much larger than their content, normalised: more than a crossing's error of rounding.
constexpr float slack = 0x1p-19f;

/// A box of four lanes, the last unused: one instruction for all.
struct alignas(16) WideBox {
  std::array<float, 4> low, high;

  static WideBox empty() {
    WideBox box;
    box.low.fill(std::numeric_limits<float>::max());
    box.high.fill(std::numeric_limits<float>::lowest());
    return box;
  }
  void add(const WideBox& box) {
    for (std::size_t k = 0; k < 4; ++k) low[k] = box.low[k] < low[k] ? box.low[k] : low[k];
    for (std::size_t k = 0; k < 4; ++k) high[k] = box.high[k] > high[k] ? box.high[k] : high[k];
  }
  void add(const glm::vec3& point) { add(WideBox{{point.x, point.y, point.z, 0}, {point.x, point.y, point.z, 0}}); }
  float size(std::size_t axis) const { return high[axis] - low[axis]; }
  float half_area() const { return size(0) * size(1) + size(1) * size(2) + size(2) * size(0); }
  std::size_t longest_axis() const {
    if (size(0) >= size(1) && size(0) >= size(2)) return 0;
    return size(1) >= size(2) ? 1 : 2;
  }
};

/// One triangle, or two that share an edge, on the way into the tree.
struct Patch {
  WideBox box;
  std::uint32_t first = 0, count = 1;  ///< of the triangles

  float doubled_middle(std::size_t axis) const { return box.low[axis] + box.high[axis]; }
};

constexpr std::size_t max_in_leaf = 2;  // patches: at most four triangles

bool share_an_edge(const glm::uvec3& one, const glm::uvec3& other) {
  int shared = 0;
  for (int k = 0; k < 3; ++k) shared += one[k] == other.x || one[k] == other.y || one[k] == other.z ? 1 : 0;
  return shared == 2;
}

std::vector<Patch> patches_of(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangle,
                              std::span<const std::uint32_t> chosen) {
  std::vector<Patch> patches;
  patches.reserve(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    Patch patch{WideBox::empty(), chosen[i], 1};
    const bool next_follows = i + 1 < chosen.size() && chosen[i + 1] == chosen[i] + 1;
    if (next_follows && share_an_edge(triangle[chosen[i]], triangle[chosen[i + 1]])) patch.count = 2, ++i;
    for (std::uint32_t t = patch.first; t < patch.first + patch.count; ++t) {
      for (int k = 0; k < 3; ++k) patch.box.add(position[triangle[t][k]]);
    }
    patches.push_back(patch);
  }
  return patches;
}

/// The levels that halving `count` patches needs.
int levels_for(std::size_t count) { return static_cast<int>(std::bit_width((count + max_in_leaf - 1) / max_in_leaf)); }

WideBox bounds(std::span<const Patch> part) {
  WideBox box = WideBox::empty();
  for (const Patch& p : part) box.add(p.box);
  return box;
}

/// Two parts of some patches, the first `count` and the rest, with their boxes.
struct Split {
  std::size_t count = 0;
  WideBox one, other;
};

/// Equal slices of a box, and the patches whose middle lies in each.
class Bins {
 public:
  Bins(const WideBox& box, std::size_t axis, std::span<const Patch> part)
      : axis_(axis), low_(2 * box.low[axis]), per_length_(bins * 0.4999f / box.size(axis)) {
    box_.fill(WideBox::empty());
    for (const Patch& p : part) {
      const auto bin = static_cast<std::size_t>(bin_of(p));
      box_[bin].add(p.box);
      ++count_[bin];
    }
  }

  int bin_of(const Patch& p) const { return static_cast<int>((p.doubled_middle(axis_) - low_) * per_length_); }

  /// The border between the two parts, and the split there: where rays have least work, by surface areas times patches.
  /// A count of 0 if all patches are in one bin.
  std::pair<int, Split> best() const {
    // From the last bin backwards, find what lies behind each border.
    std::array<WideBox, bins> after;
    std::array<std::size_t, bins> count_after{};
    after[bins - 1] = box_[bins - 1];
    count_after[bins - 1] = count_[bins - 1];
    for (std::size_t border = bins - 1; border-- > 1;) {
      after[border] = after[border + 1];
      after[border].add(box_[border]);
      count_after[border] = count_after[border + 1] + count_[border];
    }

    // From the first bin onwards, find the border with the least work.
    std::pair<int, Split> best;
    float min = std::numeric_limits<float>::max();
    WideBox before = WideBox::empty();
    std::size_t count = 0;
    for (std::size_t border = 1; border < bins; ++border) {
      before.add(box_[border - 1]);
      count += count_[border - 1];
      if (count == 0 || count_after[border] == 0) continue;
      const float cost = before.half_area() * static_cast<float>(count) +
                         after[border].half_area() * static_cast<float>(count_after[border]);
      if (cost >= min) continue;
      min = cost;
      best = {static_cast<int>(border), {count, before, after[border]}};
    }
    return best;
  }

 private:
  static constexpr std::size_t bins = 16;
  std::size_t axis_;
  float low_, per_length_;
  std::array<WideBox, bins> box_;
  std::array<std::size_t, bins> count_{};
};

glm::uvec4 bits(const std::array<float, 4>& corner, float wider, std::uint32_t last) {
  return {std::bit_cast<std::uint32_t>(corner[0] + wider), std::bit_cast<std::uint32_t>(corner[1] + wider),
          std::bit_cast<std::uint32_t>(corner[2] + wider), last};
}

class RayTreeBuilder {
 public:
  explicit RayTreeBuilder(std::vector<Patch> patches, std::size_t triangles) : patch_(std::move(patches)) {
    tree_.node.reserve(patch_.size());
    tree_.order.reserve(triangles);
    const WideBox all = bounds(patch_);
    const int root = child(0, patch_.size(), all, 0);
    if (root == 0) return;

    // Few patches are one leaf: give it a root, with nothing beside it.
    tree_.node.emplace_back();
    set(0, root, all, ~0, WideBox::empty());
  }

  RayTree take() { return std::move(tree_); }

 private:
  /// Patches [first, first + count) as a child of a node, `depth` below the root.
  int child(std::size_t first, std::size_t count, const WideBox& box, int depth) {
    if (count <= max_in_leaf) return leaf({patch_.data() + first, count});
    const std::size_t index = tree_.node.size();
    tree_.node.emplace_back();
    const Split parts = split({patch_.data() + first, count}, box, depth);
    const int one = child(first, parts.count, parts.one, depth + 1);
    const int other = child(first + parts.count, count - parts.count, parts.other, depth + 1);
    set(index, one, parts.one, other, parts.other);
    return static_cast<int>(index);
  }

  int leaf(std::span<const Patch> part) {
    const std::size_t first = tree_.order.size();
    for (const Patch& p : part) {
      for (std::uint32_t t = p.first; t < p.first + p.count; ++t) tree_.order.push_back(t);
    }
    return ~static_cast<int>(8 * first + tree_.order.size() - first);
  }

  void set(std::size_t index, int one, const WideBox& box, int other, const WideBox& other_box) {
    tree_.node[index] = {bits(box.low, -slack, static_cast<std::uint32_t>(one)), bits(box.high, slack, 0),
                         bits(other_box.low, -slack, static_cast<std::uint32_t>(other)),
                         bits(other_box.high, slack, 0)};
  }

  /// Puts the patches of the first part first.
  static Split split(std::span<Patch> part, const WideBox& box, int depth) {
    const std::size_t axis = box.longest_axis();

    // Split by surface area, unless all middles are in one bin or the tree gets too deep for halving.
    if (box.size(axis) > 0 && depth + levels_for(part.size()) < RayTree::max_depth - 2) {
      const Bins bins(box, axis, part);
      const auto [border, found] = bins.best();
      if (found.count > 0) {
        std::partition(part.begin(), part.end(), [&, last = border](const Patch& p) { return bins.bin_of(p) < last; });
        return found;
      }
    }
    const std::size_t half = part.size() / 2;
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(half);
    std::nth_element(part.begin(), middle, part.end(), [&](const Patch& p, const Patch& q) {
      return std::pair(p.doubled_middle(axis), p.first) < std::pair(q.doubled_middle(axis), q.first);
    });
    return {half, bounds(part.first(half)), bounds(part.subspan(half))};
  }

  std::vector<Patch> patch_;
  RayTree tree_;
};

}  // namespace

RayTree make_ray_tree(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangle,
                      std::span<const std::uint32_t> chosen) {
  return RayTreeBuilder(patches_of(position, triangle, chosen), chosen.size()).take();
}

}  // namespace pomona
