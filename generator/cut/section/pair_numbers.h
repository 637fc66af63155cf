// Numbers of pairs of indices, for few second indices per first index: a map without hashing.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace pomona {

class PairNumbers {
 public:
  /// \param firsts all first indices are below this.
  explicit PairNumbers(std::size_t firsts) : latest_(firsts, none) {}

  /// The pair's number, and whether the pair is new. A new pair gets `number`.
  std::pair<std::uint32_t, bool> try_emplace(std::uint32_t first, std::uint32_t second, std::uint32_t number) {
    for (std::uint32_t e = latest_[first]; e != none; e = entry_[e].before) {
      if (entry_[e].second == second) return {entry_[e].number, false};
    }
    entry_.push_back({second, number, latest_[first]});
    latest_[first] = static_cast<std::uint32_t>(entry_.size() - 1);
    return {number, true};
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Entry {
    std::uint32_t second = 0, number = 0;
    std::uint32_t before = none;  ///< the entry before it with the same first index
  };
  std::vector<std::uint32_t> latest_;  // entry, per first index
  std::vector<Entry> entry_;
};

}  // namespace pomona
