#include "generator/diffusion/harmonic/grid_level.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Ranges of planes for threads: even with few threads, more ranges even out the work.
constexpr std::size_t range_count = 12;

/// Cuts nearer than this to a node, in links, count as this near: 1 / theta stays a sensible float.
constexpr float least_theta = 1e-5f;

RunLinks links_of_run(const NodeRuns& runs, const CutLinks& links, std::size_t r) {
  const NodeRun& run = runs.run[r];
  const auto offset = [&](int y, int z) {
    const std::int32_t other = runs.at(run.block, y, z);
    return other == NodeRuns::none ? 0 : NodeRuns::length * (other - static_cast<std::int32_t>(r));
  };
  RunLinks result{offset(run.y - 1, run.z), offset(run.y + 1, run.z), offset(run.y, run.z - 1),
                  offset(run.y, run.z + 1)};
  result.plain = 1;
  result.parity = static_cast<std::uint8_t>((run.y + run.z) & 1);
  for (int k = 0; k < NodeRuns::length; ++k) {
    const std::uint8_t open = links.open[NodeRuns::length * r + static_cast<std::size_t>(k)];
    if (open == all_open) continue;
    result.plain = 0;
    if ((open & takes_no_part) == 0) result.irregular = static_cast<std::uint8_t>(result.irregular | 1 << k);
  }
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

/// The symmetric equation of a node whose links end on surfaces [Gibou et al. 2002]: a cut link of length theta pulls
/// with 1 / theta.
Stencil stencil_at(const Lattice& lattice, const Node& at, const CutLinks& links, const CutNode& node,
                   const glm::dvec3& middle) {
  Stencil stencil;
  const std::uint8_t open = links.open[node.node];
  std::uint32_t next_cut = node.first_cut;
  float odd = 0;
  for (int d = 0; d < 6; ++d) {
    float pull = 0;
    if (open >> d & 1) {
      pull = stencil.weight[static_cast<std::size_t>(d)] = 1;
    } else if (node.cut >> d & 1) {
      const LinkCut& cut = links.cut[next_cut++];
      pull = 1 / std::max(cut.theta, least_theta);
      stencil.source += pull * Quad{cut.color.r, cut.color.g, cut.color.b, 1};
    } else if (leaves_lattice(lattice, at, d)) {
      pull = pull_of_outside(lattice, at, d, middle);
    }
    stencil.diagonal += pull;
    if (at[static_cast<std::size_t>(d / 2)] & 1) odd += pull;
  }
  stencil.inverse = stencil.diagonal > 0 ? 1 / stencil.diagonal : 0;
  stencil.odd_inverse = odd > 0 ? 1 / odd : 0;
  return stencil;
}

}  // namespace

std::size_t GridLevel::stencil_of(std::size_t run, int k) const {
  const auto below = static_cast<unsigned>(run_links[run].irregular & ((1 << k) - 1));
  return run_links[run].first_stencil + static_cast<std::size_t>(std::popcount(below));
}

std::size_t GridLevel::bytes() const {
  return runs.run.size() * sizeof(NodeRun) + runs.place.size() * sizeof(std::int32_t) + links.open.size() +
         links.node.size() * sizeof(CutNode) + links.cut.size() * sizeof(LinkCut) +
         run_links.size() * sizeof(RunLinks) + stencil.size() * sizeof(Stencil) + value.bytes() + rhs.bytes() +
         residual.bytes();
}

GridLevel make_grid_level(const Lattice& lattice, NodeRuns runs, CutLinks links, const glm::dvec3& middle,
                          Threads threads) {
  GridLevel level;
  level.lattice = lattice;
  level.runs = std::move(runs);
  level.links = std::move(links);
  level.ranges = ranges_of_planes(level.runs, range_count);
  level.run_links.resize(level.runs.run.size());
  level.stencil.resize(level.links.node.size());
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
      const NodeRun& run = level.runs.run[r];
      for (int k = 0; k < NodeRuns::length; ++k) {
        const std::size_t node = NodeRuns::length * r + static_cast<std::size_t>(k);
        level.value[node] = level.residual[node] = Quad{};
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
  const int blocks = (lattice.count[0] + NodeRuns::length - 1) / NodeRuns::length;

  // A coarse run is stored if either fine run under it is.
  std::vector<std::uint8_t> wanted;
  for (int z = 0; z < lattice.count[2]; ++z) {
    for (int y = 0; y < lattice.count[1]; ++y) {
      for (int block = 0; block < blocks; ++block) {
        wanted.push_back(fine.runs.at(2 * block, 2 * y, 2 * z) != NodeRuns::none ||
                         fine.runs.at(2 * block + 1, 2 * y, 2 * z) != NodeRuns::none);
      }
    }
  }
  NodeRuns runs = make_node_runs(lattice.count, wanted);
  CutLinks links = coarser_links(fine.links, fine.runs, runs, threads);
  GridLevel level = make_grid_level(lattice, std::move(runs), std::move(links), middle, threads);
  level.rhs = RawArray<Quad>(level.runs.node_count());
  std::fill(level.rhs.data(), level.rhs.data() + level.rhs.size(), Quad{});
  return level;
}

}  // namespace pomona
