#include "generator/diffusion/harmonic/grid_level.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Ranges of planes for threads: even with few threads, more ranges even out the work.
constexpr std::size_t range_count = 12;

RunLinks links_of_run(const NodeRuns& runs, const CutLinks& links, std::size_t r) {
  const NodeRun& run = runs[r];
  const auto offset = [&](int y, int z) {
    const std::int32_t other = runs.at(run.block, y, z);
    return other == NodeRuns::none ? 0 : NodeRuns::length * (other - static_cast<std::int32_t>(r));
  };
  RunLinks result{offset(run.y - 1, run.z), offset(run.y + 1, run.z), offset(run.y, run.z - 1),
                  offset(run.y, run.z + 1)};
  result.parity = static_cast<std::uint8_t>((run.y + run.z) & 1);
  result.plain = eight_at(&links.open[NodeRuns::length * r]) == eight_of(all_open) ? 1 : 0;
  if (result.plain) {
    result.regular = 255;
    return result;
  }
  const std::uint64_t eight = eight_at(&links.open[NodeRuns::length * r]);
  result.irregular = irregular_of(eight);
  result.regular = static_cast<std::uint8_t>(~(result.irregular | lowest_bits(eight >> 7)));
  return result;
}

/// The pull towards 0 of what lies beyond the border, in parts of a link's: a field that falls like 1 / r loses
/// h (n r) / r^2 of itself per link along n.
float pull_of_outside(const Lattice& lattice, const Node& at, int direction, const glm::dvec3& middle) {
  const glm::dvec3 place = lattice.origin + lattice.spacing * glm::dvec3(at[0], at[1], at[2]) - middle;
  const double outwards = (direction % 2 == 1 ? 1 : -1) * place[direction / 2];
  return static_cast<float>(std::max(0.0, lattice.spacing * outwards / glm::dot(place, place)));
}

bool leaves_lattice(const Lattice& lattice, const Node& at, int direction) {
  const auto axis = static_cast<std::size_t>(direction / 2);
  return direction % 2 == 1 ? at[axis] + 1 >= lattice.count[axis] : at[axis] == 0;
}

/// The equation of a node whose links end on surfaces [Shortley & Weller 1938]: along each axis the second difference
/// over links of different lengths, times the square of the spacing.
Stencil stencil_at(const Lattice& lattice, const Node& at, const CutLinks& links, const CutNode& node,
                   const glm::dvec3& middle) {
  // How long links are along which way; what weighs nothing is added all the same, which is faster than to ask.
  std::array<float, 6> length{1, 1, 1, 1, 1, 1}, nearness{}, pull{};
  std::uint32_t next_cut = node.first_cut;
  for (unsigned left = node.cut; left != 0; left &= left - 1) {
    length[static_cast<std::size_t>(std::countr_zero(left))] = std::max(links.cut[next_cut++].theta, least_theta);
  }
  Stencil stencil;
  const std::uint8_t open = links.open[node.node];
  std::array<float, 3> stretch{};
  for (std::size_t a = 0; a < 3; ++a) stretch[a] = 2 / (length[2 * a] + length[2 * a + 1]);
  for (std::size_t d = 0; d < 6; ++d) {
    nearness[d] = static_cast<float>(open >> d & 1);
    pull[d] = stencil.weight[d] = stretch[d / 2] * nearness[d];
  }

  // Cut links pull towards the surfaces, and those that leave the lattice towards nothing.
  next_cut = node.first_cut;
  for (unsigned left = node.cut; left != 0; left &= left - 1) {
    const auto d = static_cast<std::size_t>(std::countr_zero(left));
    nearness[d] = 1 / length[d];
    pull[d] = stretch[d / 2] * nearness[d];
    const Color& color = links.cut[next_cut++].color;
    stencil.source += pull[d] * Quad{color.r, color.g, color.b, 1};
  }
  for (unsigned left = all_open & ~(open | node.cut); left != 0; left &= left - 1) {
    const int d = std::countr_zero(left);
    if (leaves_lattice(lattice, at, d))
      nearness[static_cast<std::size_t>(d)] = pull[static_cast<std::size_t>(d)] =
          pull_of_outside(lattice, at, d, middle);
  }
  float odd = 0;
  for (std::size_t d = 0; d < 6; ++d) {
    stencil.diagonal += pull[d];
    odd += static_cast<float>(at[d / 2] & 1) * nearness[d];
  }
  stencil.inverse = stencil.diagonal > 0 ? 1 / stencil.diagonal : 0;
  stencil.odd_inverse = odd > 0 ? 1 / odd : 0;
  return stencil;
}

/// The cut of a node's link; nothing if it is not cut.
const LinkCut* cut_at(const GridLevel& level, std::size_t node, int direction) {
  if (level.links.open[node] == all_open) return nullptr;
  const CutNode& found = level.links.node[level.stencil_of(node / NodeRuns::length, node % NodeRuns::length)];
  if ((found.cut >> direction & 1) == 0) return nullptr;
  return &level.links.cut[found.first_cut + bit_counts[found.cut & ((1u << direction) - 1)]];
}

/// Whether all fine links that a coarse run is made of are open, as far as a glance at the fine runs tells.
bool is_plain_below(const GridLevel& fine, const NodeRun& run) {
  for (int block = 2 * run.block - 1; block <= 2 * run.block + 1; ++block) {
    const std::int32_t middle = fine.runs.at(block, 2 * run.y, 2 * run.z);
    if (middle == NodeRuns::none || !fine.run_links[static_cast<std::size_t>(middle)].plain) return false;
    if (block < 2 * run.block) continue;
    for (const auto& [y, z] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const std::int32_t beside = fine.runs.at(block, 2 * run.y + y, 2 * run.z + z);
      if (beside == NodeRuns::none || !fine.run_links[static_cast<std::size_t>(beside)].plain) return false;
    }
  }
  return true;
}

/// A coarse node's links: open where both fine halves are, else cut where the nearer half is.
void add_coarse_node(const GridLevel& fine, const Node& at, std::size_t node, CutLinks& part, std::uint8_t& open) {
  // What the fine grid does not have, or leaves out, takes no part here either.
  const std::int32_t found = fine.runs.node_at(2 * at[0], 2 * at[1], 2 * at[2]);
  const auto here = static_cast<std::size_t>(found);
  open = takes_no_part;
  if (found == NodeRuns::none || (fine.links.open[here] & takes_no_part)) return;

  // Two fine links make one coarse link: a cut in the second lies half a link further on.
  const RunLinks& run = fine.run_links[here / NodeRuns::length];
  const std::array<std::int32_t, 6> offset = {-1, 1, run.y_down, run.y_up, run.z_down, run.z_up};
  unsigned opened = fine.links.open[here] & all_open;
  for (unsigned left = opened; left != 0; left &= left - 1) {
    const auto d = static_cast<std::size_t>(std::countr_zero(left));
    const auto middle = static_cast<std::size_t>(found + offset[d]);
    if ((fine.links.open[middle] >> d & 1) == 0) opened &= ~(1u << d);
  }
  open = static_cast<std::uint8_t>(opened);
  if (open == all_open) return;
  CutNode cut{static_cast<std::uint32_t>(node), static_cast<std::uint32_t>(part.cut.size()), 0};
  for (unsigned left = all_open & ~opened; left != 0; left &= left - 1) {
    const auto d = static_cast<std::size_t>(std::countr_zero(left));
    const bool first_open = fine.links.open[here] >> d & 1;
    const std::size_t middle = first_open ? static_cast<std::size_t>(found + offset[d]) : here;
    const LinkCut* nearer = cut_at(fine, middle, static_cast<int>(d));
    if (nearer == nullptr) continue;
    cut.cut = static_cast<std::uint8_t>(cut.cut | 1 << d);
    part.cut.push_back({0.5f * nearer->theta + (first_open ? 0.5f : 0.0f), nearer->side, nearer->color});
  }
  part.node.push_back(cut);
}

CutLinks coarser_links(const GridLevel& fine, const NodeRuns& coarse_runs, Threads threads) {
  // Each range of planes writes its cut nodes into a part of its own.
  const auto ranges = coarse_runs.ranges_of_planes(range_count);
  CutLinks links;
  links.open.resize(coarse_runs.node_count());
  std::vector<CutLinks> parts(ranges.size());
  parallel_for(ranges.size(), threads, [&](std::size_t i) {
    // A coarse plane has about a fourth of the cut nodes of a fine one, and there are half as many planes.
    parts[i].node.reserve(fine.links.node.size() / (3 * ranges.size()));
    parts[i].cut.reserve(fine.links.cut.size() / (3 * ranges.size()));

    // Where a glance shows that a whole run is open, its nodes need no look at each link.
    for (std::size_t r = ranges[i].first; r < ranges[i].second; ++r) {
      const NodeRun& run = coarse_runs[r];
      const bool is_plain = is_plain_below(fine, run);
      for (int k = 0; k < NodeRuns::length; ++k) {
        const std::size_t node = NodeRuns::length * r + static_cast<std::size_t>(k);
        if (is_plain) {
          links.open[node] = all_open;
        } else {
          add_coarse_node(fine, {NodeRuns::length * run.block + k, run.y, run.z}, node, parts[i], links.open[node]);
        }
      }
    }
  });

  // The parts are joined in the order of the ranges, so that threads make no difference.
  append(links, parts);
  return links;
}

}  // namespace

std::size_t GridLevel::bytes() const {
  return runs.bytes() + links.open.size() + links.node.size() * sizeof(CutNode) + links.cut.size() * sizeof(LinkCut) +
         run_links.size() * sizeof(RunLinks) + stencil.bytes() + value.bytes() + rhs.bytes() + residual.bytes();
}

GridLevel make_grid_level(const Lattice& lattice, NodeRuns runs, CutLinks links, const glm::dvec3& middle,
                          Threads threads) {
  GridLevel level;
  level.lattice = lattice;
  level.runs = std::move(runs);
  level.links = std::move(links);
  level.ranges = level.runs.ranges_of_planes(range_count);
  level.planes = level.runs.ranges_of_planes(level.runs.size());
  level.run_links.resize(level.runs.size());
  level.stencil = RawArray<Stencil>(level.links.node.size());
  level.value = RawArray<Quad>(level.runs.node_count());
  level.residual = RawArray<Quad>(level.runs.node_count());

  parallel_for(level.ranges.size(), threads, [&](std::size_t i) {
    const auto [first, end] = level.ranges[i];
    const auto before = std::lower_bound(level.links.node.begin(), level.links.node.end(), NodeRuns::length * first,
                                         [](const CutNode& node, std::size_t from) { return node.node < from; });
    auto stencil = static_cast<std::uint32_t>(before - level.links.node.begin());
    for (std::size_t r = first; r < end; ++r) {
      level.run_links[r] = links_of_run(level.runs, level.links, r);
      level.run_links[r].first_stencil = stencil;
      const NodeRun& run = level.runs[r];
      std::fill_n(&level.value[NodeRuns::length * r], NodeRuns::length, Quad{});
      if (level.run_links[r].irregular == 0) continue;
      for (int k = 0; k < NodeRuns::length; ++k) {
        if ((level.run_links[r].irregular >> k & 1) == 0) continue;
        level.stencil[stencil] = stencil_at(lattice, {NodeRuns::length * run.block + k, run.y, run.z}, level.links,
                                            level.links.node[stencil], middle);
        ++stencil;
      }
    }
  });
  return level;
}

GridLevel coarser(const GridLevel& fine, const glm::dvec3& middle, Threads threads) {
  const Lattice lattice = doubled(fine.lattice);

  // A coarse run is stored if either fine run under it is.
  std::vector<BlocksOfRow> wanted(static_cast<std::size_t>(lattice.count[1] * lattice.count[2]), 0);
  for (std::size_t r = 0; r < fine.runs.size(); ++r) {
    const NodeRun& run = fine.runs[r];
    if ((run.y | run.z) & 1) continue;
    wanted[static_cast<std::size_t>(run.z / 2 * lattice.count[1] + run.y / 2)] |= BlocksOfRow{1} << run.block / 2;
  }
  NodeRuns runs(lattice.count, wanted);
  CutLinks links = coarser_links(fine, runs, threads);
  GridLevel level = make_grid_level(lattice, std::move(runs), std::move(links), middle, threads);
  level.rhs = RawArray<Quad>(level.runs.node_count());
  std::fill(level.rhs.data(), level.rhs.data() + level.rhs.size(), Quad{});
  return level;
}

}  // namespace pomona
