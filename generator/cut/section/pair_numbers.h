// Numbers given to pairs of indices, where few second ones go with each first one: a look-up without hashing.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace pomona {

class PairNumbers {
 public:
  /// First indices lie below `firsts`.
  explicit PairNumbers(std::size_t firsts) : latest_(firsts, none) {}

  /// The pair's number, and whether it is new: then it is the one given here.
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
