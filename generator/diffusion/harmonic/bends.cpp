#include "generator/diffusion/harmonic/bends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "generator/diffusion/harmonic/patches.h"

namespace pomona {

namespace {

/// What a node sees along one direction, and how far away, in links.
struct Seen {
  Quad value{};
  float length = 1;
  bool is_there = false;
};

/// All six of them.
std::array<Seen, 6> seen_from(const GridLevel& level, std::size_t run, int k) {
  const RunLinks& links = level.run_links[run];
  const std::array<std::ptrdiff_t, 6> offset = {-1, 1, links.y_down, links.y_up, links.z_down, links.z_up};
  const std::size_t node = NodeRuns::length * run + static_cast<std::size_t>(k);
  const std::uint8_t open = level.links.open[node];
  std::array<Seen, 6> seen;
  for (std::size_t d = 0; d < 6; ++d) {
    if (open >> d & 1) seen[d] = {level.value[node + static_cast<std::size_t>(offset[d])], 1, true};
  }
  if (open == all_open) return seen;
  const CutNode& cut = level.links.node[level.stencil_of(run, k)];
  std::uint32_t next = cut.first_cut;
  for (std::size_t d = 0; d < 6; ++d) {
    if ((cut.cut >> d & 1) == 0) continue;
    const LinkCut& end = level.links.cut[next++];
    seen[d] = {Quad{end.color.r, end.color.g, end.color.b, 1}, end.theta, true};
  }
  return seen;
}

/// A brick by number, and how far the solution bends there.
using BrickBend = std::pair<std::size_t, float>;

/// Adds the bricks that meet at a node.
void add_bricks_at(const Lattice& lattice, const Node& at, float bend, std::vector<BrickBend>& bends) {
  const Node count = bricks_of(lattice);
  Node low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = std::clamp((at[a] - 1) / brick[a], 0, count[a] - 1);
    high[a] = std::clamp(at[a] / brick[a], 0, count[a] - 1);
  }
  for (int z = low[2]; z <= high[2]; ++z) {
    for (int y = low[1]; y <= high[1]; ++y) {
      for (int x = low[0]; x <= high[0]; ++x) bends.emplace_back(brick_index({x, y, z}, count), bend);
    }
  }
}

}  // namespace

float bend_at(const GridLevel& level, std::size_t run, int k) {
  const std::size_t node = NodeRuns::length * run + static_cast<std::size_t>(k);
  const std::array<Seen, 6> seen = seen_from(level, run, k);
  float most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Seen &below = seen[2 * axis], &above = seen[2 * axis + 1];
    if (!below.is_there || !above.is_there) continue;
    const float way = below.length + above.length;
    if (!(way > 0)) continue;
    const Quad off = level.value[node] - (above.length * below.value + below.length * above.value) / way;
    for (std::size_t channel = 0; channel < 3; ++channel) most = std::max(most, std::fabs(off[channel]));
  }
  return most;
}

std::vector<float> bends_of_bricks(const GridLevel& level, double least, Threads threads) {
  // Each range of planes finds the bends of its own nodes.
  const auto enough = static_cast<float>(least);
  std::vector<std::vector<BrickBend>> found(level.ranges.size());
  parallel_for(level.ranges.size(), threads, [&](std::size_t i) {
    for (std::size_t r = level.ranges[i].first; r < level.ranges[i].second; ++r) {
      const NodeRun& run = level.runs[r];
      for (int k = 0; k < NodeRuns::length; ++k) {
        if (level.links.open[NodeRuns::length * r + static_cast<std::size_t>(k)] & (takes_no_part | is_given)) continue;
        const float bend = bend_at(level, r, k);
        if (bend < enough) continue;
        add_bricks_at(level.lattice, {NodeRuns::length * run.block + k, run.y, run.z}, bend, found[i]);
      }
    }
  });

  // A brick bends as much as its most bent node.
  const Node count = bricks_of(level.lattice);
  std::vector<float> bend_of_brick(static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1] * count[2]));
  for (const auto& part : found) {
    for (const auto& [number, bend] : part) bend_of_brick[number] = std::max(bend_of_brick[number], bend);
  }
  return bend_of_brick;
}

std::vector<std::uint8_t> most_bent(const std::vector<float>& bend_of_brick, std::size_t most) {
  // Of bricks that bend alike, all or none are taken: which come first must not matter.
  std::vector<float> bends;
  std::copy_if(bend_of_brick.begin(), bend_of_brick.end(), std::back_inserter(bends),
               [](float bend) { return bend > 0; });
  float too_straight = 0;
  if (bends.size() > most) {
    const auto first_out = bends.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(bends.begin(), first_out, bends.end(), std::greater<>());
    too_straight = *first_out;
  }
  std::vector<std::uint8_t> is_bent(bend_of_brick.size());
  std::transform(bend_of_brick.begin(), bend_of_brick.end(), is_bent.begin(),
                 [&](float bend) { return bend > too_straight ? 1 : 0; });
  return is_bent;
}

}  // namespace pomona
