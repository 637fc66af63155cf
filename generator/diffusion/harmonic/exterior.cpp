#include "generator/diffusion/harmonic/exterior.h"

#include <algorithm>
#include <utility>

#include "generator/diffusion/harmonic/cut_links.h"

namespace pomona {

namespace {

/// Rows of nodes as bits, 64 to a word, for one question each: reached? open towards +x, +y, +z?
class BitRows {
 public:
  explicit BitRows(const NodeRuns& runs)
      : words(static_cast<std::size_t>(runs.count()[0] + 63) / 64),
        rows_y(runs.count()[1]),
        bits_(row_count(runs) * words) {}

  std::uint64_t* row(int y, int z) { return &bits_[index(y, z)]; }
  const std::uint64_t* row(int y, int z) const { return &bits_[index(y, z)]; }

  std::size_t words;
  int rows_y;

 private:
  static std::size_t row_count(const NodeRuns& runs) {
    return static_cast<std::size_t>(runs.count()[1]) * static_cast<std::size_t>(runs.count()[2]);
  }
  std::size_t index(int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(rows_y) + static_cast<std::size_t>(y)) * words;
  }
  std::vector<std::uint64_t> bits_;
};

/// Which links towards larger x, y and z are open.
struct OpenRows {
  OpenRows(const NodeRuns& runs, const std::vector<std::uint8_t>& open, Threads threads) : x(runs), y(runs), z(runs) {
    const auto ranges = runs.ranges_of_planes(16);
    parallel_for(ranges.size(), threads, [&](std::size_t i) {
      for (std::size_t r = ranges[i].first; r < ranges[i].second; ++r) add_run(runs[r], &open[NodeRuns::length * r]);
    });
  }

  BitRows x, y, z;

 private:
  void add_run(const NodeRun& run, const std::uint8_t* open) {
    const std::uint64_t eight = eight_at(open);
    const std::uint64_t part = ~(eight >> 7);  // the lowest bit of each byte: whether the node takes part
    const std::uint64_t x_byte = lowest_bits(eight >> x_up & part), y_byte = lowest_bits(eight >> y_up & part),
                        z_byte = lowest_bits(eight >> z_up & part);
    const int word = run.block / 8, shift = 8 * (run.block % 8);
    x.row(run.y, run.z)[word] |= x_byte << shift;
    y.row(run.y, run.z)[word] |= y_byte << shift;
    z.row(run.y, run.z)[word] |= z_byte << shift;
  }
};

/// Within a word, through open links (bit i: from i to i + 1): runs double in length at every step.
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
  Flood(const NodeRuns& runs, const OpenRows& open) : runs_(runs), open_(open), reached_(runs) {}

  BitRows run() {
    reached_.row(0, 0)[0] = 1;
    spread_along(0, 0);
    waiting_.emplace_back(0, 0);
    while (!waiting_.empty()) {
      const auto [y, z] = waiting_.back();
      waiting_.pop_back();
      if (y > 0) pass(y, z, y - 1, z, open_.y.row(y - 1, z));
      if (y + 1 < runs_.count()[1]) pass(y, z, y + 1, z, open_.y.row(y, z));
      if (z > 0) pass(y, z, y, z - 1, open_.z.row(y, z - 1));
      if (z + 1 < runs_.count()[2]) pass(y, z, y, z + 1, open_.z.row(y, z));
    }
    return std::move(reached_);
  }

 private:
  /// From one row to a neighbour through what is open between them.
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

  /// Along x through open links, until nothing changes.
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

  const NodeRuns& runs_;
  const OpenRows& open_;
  BitRows reached_;
  std::vector<std::pair<int, int>> waiting_;
};

}  // namespace

std::vector<std::uint8_t> reached_from_corner(const NodeRuns& runs, const std::vector<std::uint8_t>& open,
                                              Threads threads) {
  const OpenRows rows(runs, open, threads);
  const BitRows reached = Flood(runs, rows).run();
  std::vector<std::uint8_t> marked(runs.size(), 0);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const NodeRun& run = runs[r];
    marked[r] = static_cast<std::uint8_t>(reached.row(run.y, run.z)[run.block / 8] >> (8 * (run.block % 8)));
  }
  return marked;
}

NodeRuns runs_without(const NodeRuns& runs, const std::vector<std::uint8_t>& marked) {
  const Node& count = runs.count();
  std::vector<BlocksOfRow> wanted(static_cast<std::size_t>(count[1] * count[2]), 0);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const NodeRun& run = runs[r];
    const bool is_wanted = (~marked[r] & ((1 << runs.inside(r)) - 1)) != 0;
    if (is_wanted) wanted[static_cast<std::size_t>(run.z * count[1] + run.y)] |= BlocksOfRow{1} << run.block;
  }
  return {count, wanted};
}

}  // namespace pomona
