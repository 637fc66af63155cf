#include "generator/diffusion/harmonic/exterior.h"

#include <algorithm>
#include <utility>

#include "generator/diffusion/harmonic/cut_arms.h"

namespace pomona {

namespace {

/// Rows of nodes as bits, 64 in a word. One such grid per property: reached, open towards +x, open towards +y, ...
class BitRows {
 public:
  explicit BitRows(const SparseBlocks& blocks)
      : words(static_cast<std::size_t>(blocks.count()[0] + 63) / 64),
        rows_y(blocks.count()[1]),
        bits_(row_count(blocks) * words) {}

  std::uint64_t* row(int y, int z) { return &bits_[index(y, z)]; }
  const std::uint64_t* row(int y, int z) const { return &bits_[index(y, z)]; }

  std::size_t words;
  int rows_y;

 private:
  static std::size_t row_count(const SparseBlocks& blocks) {
    return static_cast<std::size_t>(blocks.count()[1]) * static_cast<std::size_t>(blocks.count()[2]);
  }
  std::size_t index(int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(rows_y) + static_cast<std::size_t>(y)) * words;
  }
  std::vector<std::uint64_t> bits_;
};

/// Which arms towards larger x, y and z are open.
struct OpenRows {
  OpenRows(const SparseBlocks& blocks, const std::vector<std::uint8_t>& open, Threads threads)
      : x(blocks), y(blocks), z(blocks) {
    const auto ranges = blocks.ranges_of_planes(16);
    parallel_for(ranges.size(), threads, [&](std::size_t i) {
      for (std::size_t r = ranges[i].first; r < ranges[i].second; ++r)
        add_run(blocks[r], &open[SparseBlocks::length * r]);
    });
  }

  BitRows x, y, z;

 private:
  void add_run(const NodeBlock& block, const std::uint8_t* open) {
    const std::uint64_t eight = eight_at(open);
    const std::uint64_t part = ~(eight >> 7);  // the lowest bit of each byte: whether the node takes part
    const std::uint64_t x_byte = lowest_bits(eight >> x_up & part), y_byte = lowest_bits(eight >> y_up & part),
                        z_byte = lowest_bits(eight >> z_up & part);
    const int word = block.column / 8, shift = 8 * (block.column % 8);
    x.row(block.y, block.z)[word] |= x_byte << shift;
    y.row(block.y, block.z)[word] |= y_byte << shift;
    z.row(block.y, block.z)[word] |= z_byte << shift;
  }
};

/// Spreads within a word through open arms (bit i: from i to i + 1). The distance doubles at every step.
std::uint64_t spread_up(std::uint64_t bits, std::uint64_t open) {
  std::uint64_t passable = open << 1;
  for (int step = 1; step < 64; step *= 2) {
    bits |= passable & bits << step;
    passable &= passable << step;
  }
  return bits;
}

std::uint64_t spread_down(std::uint64_t bits, std::uint64_t open) {
  std::uint64_t passable = open;
  for (int step = 1; step < 64; step *= 2) {
    bits |= passable & bits >> step;
    passable &= passable >> step;
  }
  return bits;
}

/// Floods a lattice from one corner, row by row.
class Flood {
 public:
  Flood(const SparseBlocks& blocks, const OpenRows& open) : blocks_(blocks), open_(open), reached_(blocks) {}

  BitRows block() {
    reached_.row(0, 0)[0] = 1;
    spread_along(0, 0);
    waiting_.emplace_back(0, 0);
    while (!waiting_.empty()) {
      const auto [y, z] = waiting_.back();
      waiting_.pop_back();
      if (y > 0) pass(y, z, y - 1, z, open_.y.row(y - 1, z));
      if (y + 1 < blocks_.count()[1]) pass(y, z, y + 1, z, open_.y.row(y, z));
      if (z > 0) pass(y, z, y, z - 1, open_.z.row(y, z - 1));
      if (z + 1 < blocks_.count()[2]) pass(y, z, y, z + 1, open_.z.row(y, z));
    }
    return std::move(reached_);
  }

 private:
  /// Spreads from one row to a neighbour row through the open arms between them.
  void pass(int y, int z, int to_y, int to_z, const std::uint64_t* open) {
    const std::uint64_t* from = reached_.row(y, z);
    std::uint64_t* to = reached_.row(to_y, to_z);
    std::uint64_t added = 0;
    for (std::size_t w = 0; w < open_.x.words; ++w) {
      const std::uint64_t fresh = from[w] & open[w] & ~to[w];
      to[w] |= fresh;
      added |= fresh;
    }
    if (added == 0) return;
    spread_along(to_y, to_z);
    waiting_.emplace_back(to_y, to_z);
  }

  /// Spreads along x through open arms, until nothing changes.
  void spread_along(int y, int z) {
    std::uint64_t* bits = reached_.row(y, z);
    const std::uint64_t* open = open_.x.row(y, z);
    for (bool changed = true; changed;) {
      changed = false;
      std::uint64_t carry = 0;
      for (std::size_t w = 0; w < open_.x.words; ++w) {
        const std::uint64_t old = bits[w];
        std::uint64_t now = old | carry;
        now = spread_up(now, open[w]);
        carry = (now & open[w]) >> 63;
        now = spread_down(now, open[w]);
        bits[w] = now;
        if (w > 0 && (now & 1) && (open[w - 1] >> 63) && !(bits[w - 1] >> 63)) {
          bits[w - 1] |= std::uint64_t{1} << 63;
          changed = true;
        }
      }
    }
  }

  const SparseBlocks& blocks_;
  const OpenRows& open_;
  BitRows reached_;
  std::vector<std::pair<int, int>> waiting_;
};

}  // namespace

std::vector<std::uint8_t> reached_from_corner(const SparseBlocks& blocks, const std::vector<std::uint8_t>& open,
                                              Threads threads) {
  const OpenRows rows(blocks, open, threads);
  const BitRows reached = Flood(blocks, rows).block();
  std::vector<std::uint8_t> marked(blocks.size(), 0);
  for (std::size_t r = 0; r < blocks.size(); ++r) {
    const NodeBlock& block = blocks[r];
    marked[r] = static_cast<std::uint8_t>(reached.row(block.y, block.z)[block.column / 8] >> (8 * (block.column % 8)));
  }
  return marked;
}

SparseBlocks blocks_without(const SparseBlocks& blocks, const std::vector<std::uint8_t>& marked) {
  const Node& count = blocks.count();
  std::vector<ColumnMask> wanted(static_cast<std::size_t>(count[1] * count[2]), 0);
  for (std::size_t r = 0; r < blocks.size(); ++r) {
    const NodeBlock& block = blocks[r];
    const bool is_wanted = (~marked[r] & ((1 << blocks.inside(r)) - 1)) != 0;
    if (is_wanted) wanted[static_cast<std::size_t>(block.z * count[1] + block.y)] |= ColumnMask{1} << block.column;
  }
  return {count, wanted};
}

}  // namespace pomona
