#include "generator/diffusion/harmonic/cut_links.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "generator/diffusion/harmonic/crossings.h"

namespace pomona {

namespace {

/// Ranges of planes that are worked on one by one; more than threads, so that they even out.
constexpr std::size_t slab_count = 16;

constexpr std::array<std::array<int, 3>, 6> step_to = {
    {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// What a range of planes adds to the whole.
struct SlabLinks {
  std::vector<CutNode> node;
  std::vector<LinkCut> cut;
};

/// Puts the slabs after each other.
void gather(CutLinks& links, std::vector<SlabLinks>& slabs) {
  for (SlabLinks& slab : slabs) {
    const auto before = static_cast<std::uint32_t>(links.cut.size());
    for (CutNode& node : slab.node) node.first_cut += before;
    links.node.insert(links.node.end(), slab.node.begin(), slab.node.end());
    links.cut.insert(links.cut.end(), slab.cut.begin(), slab.cut.end());
  }
}

/// A run's nodes before any surface: links to nodes that are not stored lead nowhere.
void open_links(const NodeRuns& runs, std::size_t r, std::uint8_t* open) {
  const NodeRun& run = runs.run[r];
  std::uint8_t across = all_open;
  if (runs.at(run.block, run.y - 1, run.z) == NodeRuns::none) across &= ~(1 << y_down);
  if (runs.at(run.block, run.y + 1, run.z) == NodeRuns::none) across &= ~(1 << y_up);
  if (runs.at(run.block, run.y, run.z - 1) == NodeRuns::none) across &= ~(1 << z_down);
  if (runs.at(run.block, run.y, run.z + 1) == NodeRuns::none) across &= ~(1 << z_up);
  const int inside = std::min(NodeRuns::length, runs.count[0] - NodeRuns::length * run.block);
  for (int k = 0; k < NodeRuns::length; ++k) open[k] = k < inside ? across : takes_no_part;
  if (runs.at(run.block - 1, run.y, run.z) == NodeRuns::none) open[0] &= ~(1 << x_down);
  if (inside < NodeRuns::length || runs.at(run.block + 1, run.y, run.z) == NodeRuns::none) {
    open[inside - 1] &= ~(1 << x_up);
  }
}

/// The nearest crossings around one node so far.
struct Nearest {
  std::uint32_t node = 0;
  std::uint8_t cut = 0;
  std::array<const LinkCrossing*, 6> crossing{};
  std::array<float, 6> theta{};
};

/// The links of some planes.
class Slab {
 public:
  Slab(const SnappedSurfaces& snapped, const NodeRuns& runs, std::size_t first_run, std::size_t end_run,
       std::uint8_t* open)
      : surfaces_(*snapped.surfaces),
        runs_(runs),
        first_node_(first_run * NodeRuns::length),
        nearest_(NodeRuns::length * (end_run - first_run), -1),
        open_(open) {}

  SlabLinks links(const std::vector<LinkCrossing>& crossings) {
    for (const LinkCrossing& crossing : crossings) {
      const auto axis = static_cast<std::size_t>(crossing.axis);
      Node ahead = crossing.node;
      ++ahead[axis];
      keep_if_nearest(crossing.node, 2 * crossing.axis + 1, crossing.theta, crossing);
      keep_if_nearest(ahead, 2 * crossing.axis, 1 - crossing.theta, crossing);
    }
    return in_order();
  }

 private:
  void keep_if_nearest(const Node& at, int direction, float theta, const LinkCrossing& crossing) {
    const std::int32_t node = runs_.node_at(at[0], at[1], at[2]);
    if (node == NodeRuns::none) return;
    const std::size_t local = static_cast<std::size_t>(node) - first_node_;
    if (local >= nearest_.size()) return;  // another slab's, before or after
    if (nearest_[local] < 0) {
      nearest_[local] = static_cast<std::int32_t>(found_.size());
      found_.push_back({static_cast<std::uint32_t>(node), 0, {}, {}});
    }
    Nearest& best = found_[static_cast<std::size_t>(nearest_[local])];
    const auto d = static_cast<std::size_t>(direction);
    const bool is_first = (best.cut >> direction & 1) == 0;
    if (!is_first &&
        (theta > best.theta[d] || (theta == best.theta[d] && crossing.triangle > best.crossing[d]->triangle))) {
      return;
    }
    best.cut = static_cast<std::uint8_t>(best.cut | 1 << direction);
    best.crossing[d] = &crossing;
    best.theta[d] = theta;
  }

  LinkCut seen(const Nearest& from, std::size_t direction) const {
    const LinkCrossing& crossing = *from.crossing[direction];
    const bool looks_ahead = direction % 2 == 1;
    const bool sees_front = looks_ahead != crossing.front_ahead;
    const std::vector<Color>& color = sees_front ? surfaces_.front_color : surfaces_.back_color;
    const glm::uvec3& t = surfaces_.triangle[crossing.triangle];
    return {from.theta[direction], 2 * crossing.triangle + (sees_front ? 0 : 1),
            crossing.weight[0] * color[t.x] + crossing.weight[1] * color[t.y] + crossing.weight[2] * color[t.z]};
  }

  /// Nodes with closed links, cut or leading nowhere, by place.
  SlabLinks in_order() const {
    SlabLinks links;
    for (std::size_t local = 0; local < nearest_.size(); ++local) {
      std::uint8_t& open = open_[first_node_ + local];
      if (open & takes_no_part) continue;
      CutNode node{static_cast<std::uint32_t>(first_node_ + local), static_cast<std::uint32_t>(links.cut.size()), 0};
      if (nearest_[local] >= 0) {
        const Nearest& from = found_[static_cast<std::size_t>(nearest_[local])];
        node.cut = from.cut;
        open = static_cast<std::uint8_t>(open & ~from.cut);
        for (std::size_t d = 0; d < 6; ++d) {
          if (from.cut >> d & 1) links.cut.push_back(seen(from, d));
        }
      }
      if (open != all_open) links.node.push_back(node);
    }
    return links;
  }

  const DiffusionSurfaces& surfaces_;
  const NodeRuns& runs_;
  std::size_t first_node_;
  std::vector<std::int32_t> nearest_;  ///< per node, index into found_
  std::vector<Nearest> found_;
  std::uint8_t* open_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> triangles_by_planes(const SnappedSurfaces& snapped, const Lattice& lattice,
                                                            std::span<const std::pair<int, int>> planes) {
  std::vector<std::vector<std::uint32_t>> lists(planes.size());
  for (std::uint32_t t = 0; t < snapped.surfaces->triangle_count(); ++t) {
    const glm::uvec3& corner = snapped.surfaces->triangle[t];
    const std::int64_t z0 = snapped.position[corner.x][2], z1 = snapped.position[corner.y][2],
                       z2 = snapped.position[corner.z][2];
    const std::int64_t low = (std::min({z0, z1, z2}) >> lattice.unit_bits) - 1;
    const std::int64_t high = (std::max({z0, z1, z2}) >> lattice.unit_bits) + 1;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (low < planes[i].second && high >= planes[i].first) lists[i].push_back(t);
    }
  }
  return lists;
}

CutLinks make_cut_links(const SnappedSurfaces& snapped, const Lattice& lattice, const NodeRuns& runs, Threads threads) {
  const auto ranges = ranges_of_planes(runs, slab_count);
  std::vector<std::pair<int, int>> planes;
  for (const auto& [first, end] : ranges) planes.emplace_back(runs.run[first].z, runs.run[end - 1].z + 1);
  const auto triangles = triangles_by_planes(snapped, lattice, planes);

  CutLinks links;
  links.open.resize(runs.node_count());
  std::vector<SlabLinks> slabs(ranges.size());
  parallel_for(ranges.size(), threads, [&](std::size_t i) {
    const auto [first, end] = ranges[i];
    for (std::size_t r = first; r < end; ++r) open_links(runs, r, &links.open[NodeRuns::length * r]);
    const auto crossings = link_crossings(snapped, triangles[i], lattice, planes[i].first, planes[i].second);
    slabs[i] = Slab(snapped, runs, first, end, links.open.data()).links(crossings);
  });
  gather(links, slabs);
  return links;
}

namespace {

/// The cuts of fine nodes, found by node.
class FineCuts {
 public:
  explicit FineCuts(const CutLinks& links) : links_(links) {}

  /// Nothing if the link is not cut.
  const LinkCut* in(std::uint32_t node, int direction) const {
    const auto found = std::lower_bound(links_.node.begin(), links_.node.end(), node,
                                        [](const CutNode& a, std::uint32_t b) { return a.node < b; });
    if (found == links_.node.end() || found->node != node || (found->cut >> direction & 1) == 0) return nullptr;
    const auto below = static_cast<unsigned>(found->cut & ((1 << direction) - 1));
    return &links_.cut[found->first_cut + static_cast<std::uint32_t>(std::popcount(below))];
  }

 private:
  const CutLinks& links_;
};

/// One coarse run.
void add_coarse_run(const CutLinks& fine, const NodeRuns& fine_runs, const NodeRuns& runs, std::size_t r,
                    std::vector<std::uint8_t>& open, SlabLinks& slab) {
  const FineCuts cuts(fine);
  const NodeRun& run = runs.run[r];
  for (int k = 0; k < NodeRuns::length; ++k) {
    const std::size_t node = NodeRuns::length * r + static_cast<std::size_t>(k);
    const int x = 2 * (NodeRuns::length * run.block + k), y = 2 * run.y, z = 2 * run.z;
    const std::int32_t here = fine_runs.node_at(x, y, z);
    if (here == NodeRuns::none || (fine.open[static_cast<std::size_t>(here)] & takes_no_part)) {
      open[node] = takes_no_part;
      continue;
    }
    CutNode cut{static_cast<std::uint32_t>(node), static_cast<std::uint32_t>(slab.cut.size()), 0};
    std::uint8_t both = 0;
    for (int d = 0; d < 6; ++d) {
      const auto& step = step_to[static_cast<std::size_t>(d)];
      const bool first_open = fine.open[static_cast<std::size_t>(here)] >> d & 1;
      const std::int32_t middle = first_open ? fine_runs.node_at(x + step[0], y + step[1], z + step[2]) : here;
      if (first_open && (fine.open[static_cast<std::size_t>(middle)] >> d & 1)) {
        both = static_cast<std::uint8_t>(both | 1 << d);
      } else if (const LinkCut* found = cuts.in(static_cast<std::uint32_t>(middle), d)) {
        cut.cut = static_cast<std::uint8_t>(cut.cut | 1 << d);
        slab.cut.push_back({0.5f * found->theta + (first_open ? 0.5f : 0.0f), found->side, found->color});
      }
    }
    open[node] = both;
    if (both != all_open) slab.node.push_back(cut);
  }
}

}  // namespace

CutLinks coarser_links(const CutLinks& fine, const NodeRuns& fine_runs, const NodeRuns& coarse_runs, Threads threads) {
  const auto ranges = ranges_of_planes(coarse_runs, slab_count);
  CutLinks links;
  links.open.resize(coarse_runs.node_count());
  std::vector<SlabLinks> slabs(ranges.size());
  parallel_for(ranges.size(), threads, [&](std::size_t i) {
    for (std::size_t r = ranges[i].first; r < ranges[i].second; ++r) {
      add_coarse_run(fine, fine_runs, coarse_runs, r, links.open, slabs[i]);
    }
  });
  gather(links, slabs);
  return links;
}

}  // namespace pomona
