// Disjoint sets that know who is turned against whom.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pomona {

/// Sets of triangles, or of patches of them; each member knows whether it is turned against its set's root.
class TurnedSets {
 public:
  explicit TurnedSets(std::size_t count) : parent_(count), turned_(count, 0) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }

  struct Root {
    std::uint32_t root;
    std::uint8_t turned;
  };
  Root root(std::uint32_t i) {
    std::uint32_t top = i;
    std::uint8_t turned = 0;
    for (; parent_[top] != top; top = parent_[top]) turned ^= turned_[top];
    for (std::uint8_t left = turned; parent_[i] != i && parent_[i] != top;) {
      const std::uint32_t next = parent_[i];
      const std::uint8_t own = std::exchange(turned_[i], left);
      left ^= own;
      parent_[i] = top;
      i = next;
    }
    return {top, turned};
  }

  /// False if the two are in one set with the opposite orientation.
  bool join(std::uint32_t a, std::uint32_t b, bool against) {
    const Root x = root(a), y = root(b);
    const auto turned = static_cast<std::uint8_t>(x.turned ^ y.turned ^ (against ? 1 : 0));
    if (x.root == y.root) return turned == 0;
    parent_[std::max(x.root, y.root)] = std::min(x.root, y.root);
    turned_[std::max(x.root, y.root)] = turned;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> turned_;
};

}  // namespace pomona
