#include "generator/diffusion/harmonic/exterior.h"

#include <bit>
#include <utility>

namespace pomona {

namespace {

/// Rows of nodes as bits, 64 to a word, for one question each: reached? open towards +x, +y, +z?
class BitRows {
 public:
  explicit BitRows(const NodeRuns& runs)
      : words(static_cast<std::size_t>(runs.blocks + 7) / 8), rows_y(runs.count[1]), bits_(row_count(runs) * words) {}

  std::uint64_t* row(int y, int z) { return &bits_[index(y, z)]; }
  const std::uint64_t* row(int y, int z) const { return &bits_[index(y, z)]; }

  std::size_t words;
  int rows_y;

 private:
  static std::size_t row_count(const NodeRuns& runs) {
    return static_cast<std::size_t>(runs.count[1]) * static_cast<std::size_t>(runs.count[2]);
  }
  std::size_t index(int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(rows_y) + static_cast<std::size_t>(y)) * words;
  }
  std::vector<std::uint64_t> bits_;
};

/// Bit k of byte i of the result's bytes is bit `direction` of open[8 i + k].
BitRows open_towards(const CutLinks& links, const NodeRuns& runs, int direction) {
  BitRows rows(runs);
  for (std::size_t r = 0; r < runs.run.size(); ++r) {
    std::uint64_t byte = 0;
    for (std::size_t k = 0; k < NodeRuns::length; ++k) {
      const std::uint8_t open = links.open[NodeRuns::length * r + k];
      if ((open & takes_no_part) == 0) byte |= static_cast<std::uint64_t>(open >> direction & 1) << k;
    }
    const NodeRun& run = runs.run[r];
    rows.row(run.y, run.z)[run.block / 8] |= byte << (8 * (run.block % 8));
  }
  return rows;
}

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
  Flood(const CutLinks& links, const NodeRuns& runs)
      : runs_(runs),
        x_(open_towards(links, runs, x_up)),
        y_(open_towards(links, runs, y_up)),
        z_(open_towards(links, runs, z_up)),
        reached_(runs) {}

  BitRows run() {
    reached_.row(0, 0)[0] = 1;
    spread_along(0, 0);
    waiting_.emplace_back(0, 0);
    while (!waiting_.empty()) {
      const auto [y, z] = waiting_.back();
      waiting_.pop_back();
      if (y > 0) pass(y, z, y - 1, z, y_.row(y - 1, z));
      if (y + 1 < runs_.count[1]) pass(y, z, y + 1, z, y_.row(y, z));
      if (z > 0) pass(y, z, y, z - 1, z_.row(y, z - 1));
      if (z + 1 < runs_.count[2]) pass(y, z, y, z + 1, z_.row(y, z));
    }
    return std::move(reached_);
  }

 private:
  /// From one row to a neighbour through what is open between them.
  void pass(int y, int z, int to_y, int to_z, const std::uint64_t* open) {
    const std::uint64_t* from = reached_.row(y, z);
    std::uint64_t* to = reached_.row(to_y, to_z);
    std::uint64_t added = 0;
    for (std::size_t w = 0; w < x_.words; ++w) {
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
    const std::uint64_t* open = x_.row(y, z);
    for (bool changed = true; changed;) {
      changed = false;
      std::uint64_t carry = 0;
      for (std::size_t w = 0; w < x_.words; ++w) {
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
  BitRows x_, y_, z_, reached_;
  std::vector<std::pair<int, int>> waiting_;
};

/// Whether the flooded nodes see some triangle from both sides.
bool sees_both_sides(const CutLinks& links, const std::vector<std::uint8_t>& is_outside, std::size_t triangle_count) {
  std::vector<std::uint8_t> seen(triangle_count, 0);
  for (const CutNode& node : links.node) {
    if (!is_outside[node.node]) continue;
    const auto cuts = static_cast<std::uint32_t>(std::popcount(node.cut));
    for (std::uint32_t c = node.first_cut; c < node.first_cut + cuts; ++c) {
      std::uint8_t& sides = seen[links.cut[c].side / 2];
      sides = static_cast<std::uint8_t>(sides | 1 << links.cut[c].side % 2);
      if (sides == 3) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::uint8_t> sealed_off(const CutLinks& links, const NodeRuns& runs, std::size_t triangle_count) {
  const BitRows reached = Flood(links, runs).run();
  std::vector<std::uint8_t> is_outside(runs.node_count(), 0);
  for (std::size_t r = 0; r < runs.run.size(); ++r) {
    const NodeRun& run = runs.run[r];
    const std::uint64_t byte = reached.row(run.y, run.z)[run.block / 8] >> (8 * (run.block % 8));
    for (std::size_t k = 0; k < NodeRuns::length; ++k) {
      is_outside[NodeRuns::length * r + k] = static_cast<std::uint8_t>(byte >> k & 1);
    }
  }
  if (sees_both_sides(links, is_outside, triangle_count)) is_outside.assign(is_outside.size(), 0);
  return is_outside;
}

std::pair<NodeRuns, CutLinks> without(const NodeRuns& runs, const CutLinks& links,
                                      const std::vector<std::uint8_t>& is_left_out) {
  // Keep the runs in which some node stays.
  std::vector<std::uint8_t> wanted(runs.place.size(), 0);
  for (std::size_t place = 0; place < wanted.size(); ++place) {
    if (runs.place[place] == NodeRuns::none) continue;
    const auto first = static_cast<std::size_t>(NodeRuns::length * runs.place[place]);
    for (std::size_t k = 0; k < NodeRuns::length; ++k) {
      if (!is_left_out[first + k] && !(links.open[first + k] & takes_no_part)) wanted[place] = 1;
    }
  }
  NodeRuns kept = make_node_runs(runs.count, wanted);

  // Their links, and the cuts of what stays.
  CutLinks left;
  left.open.resize(kept.node_count());
  std::vector<std::uint32_t> new_run(runs.run.size(), 0);
  for (std::size_t r = 0; r < kept.run.size(); ++r) {
    const NodeRun& run = kept.run[r];
    const auto old = static_cast<std::size_t>(runs.at(run.block, run.y, run.z));
    new_run[old] = static_cast<std::uint32_t>(r);
    for (std::size_t k = 0; k < NodeRuns::length; ++k) {
      const std::size_t from = NodeRuns::length * old + k;
      left.open[NodeRuns::length * r + k] = is_left_out[from] ? takes_no_part : links.open[from];
    }
  }
  for (const CutNode& node : links.node) {
    if (is_left_out[node.node]) continue;
    const auto first_cut = static_cast<std::uint32_t>(left.cut.size());
    const auto cuts = static_cast<std::uint32_t>(std::popcount(node.cut));
    left.cut.insert(left.cut.end(), links.cut.begin() + node.first_cut, links.cut.begin() + node.first_cut + cuts);
    const std::uint32_t run = node.node / NodeRuns::length;
    left.node.push_back({NodeRuns::length * new_run[run] + node.node % NodeRuns::length, first_cut, node.cut});
  }
  return {std::move(kept), std::move(left)};
}

}  // namespace pomona
