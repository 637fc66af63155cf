// Maps and sets of edges. An edge is keyed by its two vertices, whichever way it is run; what runs one way along it is
// a HalfEdge (edges.h), which knows its edge.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace pomona {

struct EdgeKey {
  std::uint32_t low = 0, high = 0;  ///< vertices, low <= high

  EdgeKey(std::uint32_t a, std::uint32_t b) : low(std::min(a, b)), high(std::max(a, b)) {}
  friend auto operator<=>(const EdgeKey&, const EdgeKey&) = default;

  struct Hash {
    std::size_t operator()(const EdgeKey& edge) const {
      return std::hash<std::uint64_t>()(std::uint64_t{edge.low} << 32 | edge.high);
    }
  };
};

/// One value per edge. It is a hash table, because edges are looked up far more often than they are listed. The order
/// of a hash table differs between libraries, so this one cannot be walked: edges() lists what it has in order. A
/// reference to a value stays valid until its edge is erased.
template <typename T>
class EdgeMap : private std::unordered_map<EdgeKey, T, EdgeKey::Hash> {
  using Table = std::unordered_map<EdgeKey, T, EdgeKey::Hash>;

 public:
  using Table::at, Table::clear, Table::contains, Table::empty, Table::erase, Table::operator[];
  struct Entry {
    T& value;
    bool is_new;
  };

  /// The edge's value, which is made of `arguments` where there is none yet.
  template <typename... Arguments>
  Entry try_emplace(const EdgeKey& edge, Arguments&&... arguments) {
    const auto [entry, is_new] = Table::try_emplace(edge, std::forward<Arguments>(arguments)...);
    return {entry->second, is_new};
  }

  /// Null where there is none.
  const T* find(const EdgeKey& edge) const {
    const auto found = Table::find(edge);
    return found == Table::end() ? nullptr : &found->second;
  }

  /// All edges, by their lower vertices, then by their higher ones.
  std::vector<EdgeKey> edges() const {
    std::vector<EdgeKey> all;
    for (const auto& entry : static_cast<const Table&>(*this)) all.push_back(entry.first);
    std::sort(all.begin(), all.end());
    return all;
  }
};

class EdgeSet : private std::unordered_set<EdgeKey, EdgeKey::Hash> {
 public:
  using unordered_set::contains, unordered_set::insert;
};

}  // namespace pomona
