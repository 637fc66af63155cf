#include "generator/diffusion/harmonic/cut_links.h"

#include <algorithm>
#include <utility>

#include "generator/diffusion/harmonic/crossings.h"

namespace pomona {

namespace {

/// Ranges of planes that are worked on one by one; more than threads, so that they even out.
constexpr std::size_t slab_count = 16;

/// A run's nodes before any surface: links to nodes that are no members lead nowhere.
void open_links(const NodeRuns& runs, std::span<const std::uint8_t> members, std::size_t r, std::uint8_t* open) {
  const NodeRun& run = runs[r];
  const auto members_of = [&](int block, int y, int z) -> unsigned {
    const std::int32_t found = runs.at(block, y, z);
    return found == NodeRuns::none ? 0u : members[static_cast<std::size_t>(found)];
  };
  const unsigned here = members[r], before = members_of(run.block - 1, run.y, run.z),
                 after = members_of(run.block + 1, run.y, run.z);
  const std::array<unsigned, 6> beside = {here << 1 | before >> 7,
                                          here >> 1 | (after & 1) << 7,
                                          members_of(run.block, run.y - 1, run.z),
                                          members_of(run.block, run.y + 1, run.z),
                                          members_of(run.block, run.y, run.z - 1),
                                          members_of(run.block, run.y, run.z + 1)};

  // Most runs lie among others, or hold nothing.
  const unsigned all = beside[0] & beside[1] & beside[2] & beside[3] & beside[4] & beside[5] & here & 255;
  if (all == 255 || here == 0) {
    std::memset(open, all == 255 ? all_open : takes_no_part, NodeRuns::length);
    return;
  }
  for (int k = 0; k < NodeRuns::length; ++k) {
    unsigned bits = 0;
    for (unsigned d = 0; d < 6; ++d) bits |= (beside[d] >> k & 1) << d;
    open[k] = here >> k & 1 ? static_cast<std::uint8_t>(bits) : takes_no_part;
  }
}

/// The nearest crossings around one node so far.
struct Nearest {
  std::uint32_t node = 0;
  std::uint8_t cut = 0;
  std::array<std::uint32_t, 6> crossing{};
  std::array<float, 6> theta{};
};

}  // namespace

/// Some planes, and all that cuts links there.
class LinkFinder::Slab {
 public:
  Slab() = default;
  Slab(const NodeRuns& runs, std::pair<std::size_t, std::size_t> range, std::vector<LinkCrossing> crossings,
       std::uint8_t* open)
      : runs_(&runs),
        first_run_(range.first),
        crossings_(std::move(crossings)),
        nearest_(NodeRuns::length * (range.second - range.first), -1) {
    found_.reserve(crossings_.size());
    for (std::uint32_t c = 0; c < crossings_.size(); ++c) {
      const LinkCrossing& crossing = crossings_[c];
      Node ahead = crossing.node;
      ++ahead[static_cast<std::size_t>(crossing.axis)];
      keep_if_nearest(crossing.node, 2 * crossing.axis + 1, crossing.theta, c);
      keep_if_nearest(ahead, 2 * crossing.axis, 1 - crossing.theta, c);
    }
    for (const Nearest& from : found_) open[from.node] = static_cast<std::uint8_t>(open[from.node] & ~from.cut);
  }

  /// Adds the sides that marked nodes see, 1 for front and 2 for back, to those per triangle.
  void add_sides(const std::vector<std::uint8_t>& marked, std::vector<std::uint8_t>& sides) const {
    for (const Nearest& from : found_) {
      if ((marked[from.node / NodeRuns::length] >> from.node % NodeRuns::length & 1) == 0) continue;
      for (std::size_t d = 0; d < 6; ++d) {
        if ((from.cut >> d & 1) == 0) continue;
        const std::uint32_t side = side_seen(crossings_[from.crossing[d]], d);
        sides[side / 2] = static_cast<std::uint8_t>(sides[side / 2] | 1 << side % 2);
      }
    }
  }

  std::size_t first_run() const { return first_run_; }

  /// What cuts the links of a node, given by its number among all and by `node` among those kept; it has a closed one.
  void add_node(const DiffusionSurfaces& surfaces, std::size_t number, std::uint32_t node, CutLinks& links) const {
    CutNode cut{node, static_cast<std::uint32_t>(links.cut.size()), 0};
    const std::int32_t found = nearest_[number - NodeRuns::length * first_run_];
    if (found >= 0) {
      const Nearest& from = found_[static_cast<std::size_t>(found)];
      cut.cut = from.cut;
      for (std::size_t d = 0; d < 6; ++d) {
        if (from.cut >> d & 1) links.cut.push_back(seen(surfaces, from, d));
      }
    }
    links.node.push_back(cut);
  }

 private:
  void keep_if_nearest(const Node& at, int direction, float theta, std::uint32_t crossing) {
    const std::int32_t node = runs_->node_at(at[0], at[1], at[2]);
    if (node == NodeRuns::none) return;
    const std::size_t local = static_cast<std::size_t>(node) - NodeRuns::length * first_run_;
    if (local >= nearest_.size()) return;  // another slab's, before or after
    if (nearest_[local] < 0) {
      nearest_[local] = static_cast<std::int32_t>(found_.size());
      found_.push_back({static_cast<std::uint32_t>(node), 0, {}, {}});
    }
    Nearest& best = found_[static_cast<std::size_t>(nearest_[local])];
    const auto d = static_cast<std::size_t>(direction);
    const bool is_first = (best.cut >> direction & 1) == 0;
    const auto triangle = [&](std::uint32_t c) { return crossings_[c].triangle; };
    if (!is_first &&
        (theta > best.theta[d] || (theta == best.theta[d] && triangle(crossing) > triangle(best.crossing[d])))) {
      return;
    }
    best.cut = static_cast<std::uint8_t>(best.cut | 1 << direction);
    best.crossing[d] = crossing;
    best.theta[d] = theta;
  }

  static std::uint32_t side_seen(const LinkCrossing& crossing, std::size_t direction) {
    const bool looks_ahead = direction % 2 == 1;
    return 2 * crossing.triangle + (looks_ahead != crossing.front_ahead ? 0 : 1);
  }

  LinkCut seen(const DiffusionSurfaces& surfaces, const Nearest& from, std::size_t direction) const {
    const LinkCrossing& crossing = crossings_[from.crossing[direction]];
    const std::uint32_t side = side_seen(crossing, direction);
    const std::vector<Color>& color = side % 2 == 0 ? surfaces.front_color : surfaces.back_color;
    const glm::uvec3& t = surfaces.triangle[crossing.triangle];
    return {from.theta[direction], side,
            crossing.weight[0] * color[t.x] + crossing.weight[1] * color[t.y] + crossing.weight[2] * color[t.z]};
  }

  const NodeRuns* runs_ = nullptr;
  std::size_t first_run_ = 0;
  std::vector<LinkCrossing> crossings_;
  std::vector<std::int32_t> nearest_;  ///< per node, index into found_
  std::vector<Nearest> found_;
};

std::vector<std::vector<std::uint32_t>> triangles_by_planes(const SnappedSurfaces& snapped,
                                                            std::span<const std::uint32_t> triangles,
                                                            const Lattice& lattice,
                                                            std::span<const std::pair<int, int>> planes) {
  std::vector<std::vector<std::uint32_t>> lists(planes.size());
  for (const std::uint32_t t : triangles) {
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

LinkFinder::LinkFinder(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& lattice,
                       const NodeRuns& runs, std::span<const std::uint8_t> members, Threads threads)
    : snapped_(snapped), runs_(runs), threads_(threads), open_(runs.node_count()) {
  const auto ranges = runs.ranges_of_planes(slab_count);
  std::vector<std::pair<int, int>> planes;
  for (const auto& [first, end] : ranges) planes.emplace_back(runs[first].z, runs[end - 1].z + 1);
  const auto by_planes = triangles_by_planes(snapped, triangles, lattice, planes);
  slabs_.resize(ranges.size());
  parallel_for(ranges.size(), threads, [&](std::size_t i) {
    for (std::size_t r = ranges[i].first; r < ranges[i].second; ++r)
      open_links(runs, members, r, &open_[NodeRuns::length * r]);
    slabs_[i] = Slab(runs, ranges[i], link_crossings(snapped, by_planes[i], lattice, planes[i].first, planes[i].second),
                     open_.data());
  });
}

LinkFinder::~LinkFinder() = default;

std::vector<std::uint8_t> LinkFinder::sides_seen(const std::vector<std::uint8_t>& marked) const {
  std::vector<std::uint8_t> sides(snapped_.surfaces->triangle_count(), 0);
  for (const Slab& slab : slabs_) slab.add_sides(marked, sides);
  return sides;
}

CutLinks LinkFinder::links(const NodeRuns& kept, const std::vector<std::uint8_t>& marked) const {
  CutLinks links;
  links.open.resize(kept.node_count());

  // Each slab by itself.
  std::vector<CutLinks> parts(slabs_.size());
  parallel_for(slabs_.size(), threads_, [&](std::size_t i) {
    const std::size_t end = i + 1 < slabs_.size() ? slabs_[i + 1].first_run() : runs_.size();
    for (std::size_t r = slabs_[i].first_run(); r < end; ++r) {
      const NodeRun& run = runs_[r];
      const std::int32_t place = kept.at(run.block, run.y, run.z);
      if (place == NodeRuns::none) continue;
      const std::size_t first = NodeRuns::length * r, first_to = static_cast<std::size_t>(NodeRuns::length * place);
      if (marked[r] == 0 && eight_at(&open_[first]) == eight_of(all_open)) {
        std::memset(&links.open[first_to], all_open, NodeRuns::length);
        continue;
      }
      for (std::size_t k = 0; k < NodeRuns::length; ++k) {
        const std::size_t from = first + k, to = first_to + k;
        links.open[to] = marked[r] >> k & 1 ? takes_no_part : open_[from];
        if (links.open[to] == all_open || (links.open[to] & takes_no_part)) continue;
        slabs_[i].add_node(*snapped_.surfaces, from, static_cast<std::uint32_t>(to), parts[i]);
      }
    }
  });

  append(links, parts);
  return links;
}

void append(CutLinks& links, std::vector<CutLinks>& parts) {
  for (CutLinks& part : parts) {
    const auto before = static_cast<std::uint32_t>(links.cut.size());
    for (CutNode& node : part.node) node.first_cut += before;
    links.node.insert(links.node.end(), part.node.begin(), part.node.end());
    links.cut.insert(links.cut.end(), part.cut.begin(), part.cut.end());
  }
}

}  // namespace pomona
