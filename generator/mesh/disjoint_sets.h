// Disjoint sets (union-find with path halving).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pomona {

/// Sets of the numbers from 0 on. The smallest member represents its set, so that the result does not depend on the
/// order of joining.
class DisjointSets {
 public:
  /// `count` sets of one member each.
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::size_t count() const { return parent_.size(); }

  /// Adds a member in a set of its own.
  void add() { parent_.push_back(static_cast<std::uint32_t>(parent_.size())); }

  std::uint32_t root(std::uint32_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace pomona
