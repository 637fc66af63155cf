#include "generator/diffusion/harmonic/cut_links.h"

#include <algorithm>
#include <bit>
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

/// The same where the runs hold a whole lattice and all its nodes are members: only the border has closed links.
void open_links_of_whole(const NodeRuns& runs, std::size_t r, std::uint8_t* open) {
  const NodeRun& run = runs[r];
  const Node& count = runs.count();
  int bits = all_open;
  if (run.y == 0) bits &= ~(1 << y_down);
  if (run.y == count[1] - 1) bits &= ~(1 << y_up);
  if (run.z == 0) bits &= ~(1 << z_down);
  if (run.z == count[2] - 1) bits &= ~(1 << z_up);
  std::memset(open, bits, NodeRuns::length);
  if (run.block == 0) open[0] = static_cast<std::uint8_t>(open[0] & ~(1 << x_down));
  const int beyond = count[0] - NodeRuns::length * run.block;  // the first node that the lattice does not have
  if (beyond > NodeRuns::length) return;
  open[beyond - 1] = static_cast<std::uint8_t>(open[beyond - 1] & ~(1 << x_up));
  std::fill(open + beyond, open + NodeRuns::length, takes_no_part);
}

/// The triangle's side that a node sees along a link in some direction.
std::uint32_t side_seen(const LinkCrossing& crossing, std::size_t direction) {
  const bool looks_ahead = direction % 2 == 1;
  return 2 * crossing.triangle + (looks_ahead != crossing.front_ahead ? 0 : 1);
}

LinkCut seen(const DiffusionSurfaces& surfaces, const LinkCrossing& crossing, std::size_t direction, float theta) {
  const std::uint32_t side = side_seen(crossing, direction);
  const std::vector<Color>& color = side % 2 == 0 ? surfaces.front_color : surfaces.back_color;
  const glm::uvec3& t = surfaces.triangle[crossing.triangle];
  return {theta, side,
          crossing.weight[0] * color[t.x] + crossing.weight[1] * color[t.y] + crossing.weight[2] * color[t.z]};
}

/// The ends of crossed links, by the run in which they lie: end 2 c is the node of crossing c, end 2 c + 1 the next.
/// Crossings come by triangle and are wanted by node; chains bring them there with one visit each.
class EndsOfRuns {
 public:
  EndsOfRuns(const NodeRuns& runs, std::pair<std::size_t, std::size_t> range,
             const std::vector<LinkCrossing>& crossings)
      : first_run_(range.first), first_(range.second - range.first, none), next_(2 * crossings.size()) {
    for (std::uint32_t c = 0; c < crossings.size(); ++c) {
      const Node& node = crossings[c].node;
      Node ahead = node;
      ++ahead[static_cast<std::size_t>(crossings[c].axis)];
      add(runs.node_at(node[0], node[1], node[2]), 2 * c);
      add(runs.node_at(ahead[0], ahead[1], ahead[2]), 2 * c + 1);
    }
  }

  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t first(std::size_t run) const { return first_[run - first_run_]; }
  std::uint32_t next(std::uint32_t end) const { return next_[end]; }

 private:
  void add(std::int32_t node, std::uint32_t end) {
    if (node == NodeRuns::none) return;
    const std::size_t run = static_cast<std::size_t>(node) / NodeRuns::length - first_run_;
    if (run >= first_.size()) return;  // another slab's, before or after
    next_[end] = std::exchange(first_[run], end);
  }

  std::size_t first_run_;
  std::vector<std::uint32_t> first_, next_;
};

/// The nearest crossings around the nodes of one run.
class NearestOfRun {
 public:
  explicit NearestOfRun(const std::vector<LinkCrossing>& crossings) : crossings_(crossings) {}

  void clear() {
    cut_ = {};
    nodes_ = 0;
  }

  void keep_if_nearest(std::uint32_t end) {
    const std::uint32_t c = end / 2;
    const LinkCrossing& crossing = crossings_[c];
    const bool is_ahead = end % 2 == 1;
    const int x = crossing.node[0] + (is_ahead && crossing.axis == 0 ? 1 : 0);
    const auto k = static_cast<std::size_t>(x % NodeRuns::length);
    const auto d = static_cast<std::size_t>(2 * crossing.axis + (is_ahead ? 0 : 1));
    const float theta = is_ahead ? 1 - crossing.theta : crossing.theta;
    Nearest& best = nearest_[k][d];
    const bool is_first = (cut_[k] >> d & 1) == 0;
    if (!is_first &&
        (theta > best.theta || (theta == best.theta && crossing.triangle > crossings_[best.crossing].triangle))) {
      return;
    }
    cut_[k] = static_cast<std::uint8_t>(cut_[k] | 1 << d);
    nodes_ |= 1u << k;
    best = {theta, c};
  }

  /// Adds the nodes with a cut, of which `first` is the first of the run; their links are open no longer.
  void add_nodes(const DiffusionSurfaces& surfaces, std::size_t first, CutLinks& links, std::uint8_t* open) const {
    for (unsigned nodes = nodes_; nodes != 0; nodes &= nodes - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(nodes));
      open[first + k] = static_cast<std::uint8_t>(open[first + k] & ~cut_[k]);
      links.node.push_back(
          {static_cast<std::uint32_t>(first + k), static_cast<std::uint32_t>(links.cut.size()), cut_[k]});
      for (unsigned directions = cut_[k]; directions != 0; directions &= directions - 1) {
        const auto d = static_cast<std::size_t>(std::countr_zero(directions));
        const Nearest& nearest = nearest_[k][d];
        links.cut.push_back(seen(surfaces, crossings_[nearest.crossing], d, nearest.theta));
      }
    }
  }

 private:
  struct Nearest {
    float theta = 0;
    std::uint32_t crossing = 0;
  };
  const std::vector<LinkCrossing>& crossings_;
  unsigned nodes_ = 0;                                ///< a bit for each that has a cut
  std::array<std::uint8_t, NodeRuns::length> cut_{};  ///< a bit per direction
  std::array<std::array<Nearest, 6>, NodeRuns::length> nearest_;
};

/// The cut nodes of some runs, by node; `open` loses what is cut.
CutLinks cut_nodes(const DiffusionSurfaces& surfaces, const NodeRuns& runs, std::pair<std::size_t, std::size_t> range,
                   const std::vector<LinkCrossing>& crossings, std::uint8_t* open) {
  CutLinks links;
  links.node.reserve(crossings.size());
  links.cut.reserve(2 * crossings.size());
  const EndsOfRuns ends(runs, range, crossings);
  NearestOfRun nearest(crossings);
  for (std::size_t r = range.first; r < range.second; ++r) {
    if (ends.first(r) == EndsOfRuns::none) continue;
    nearest.clear();
    for (std::uint32_t end = ends.first(r); end != EndsOfRuns::none; end = ends.next(end)) nearest.keep_if_nearest(end);
    nearest.add_nodes(surfaces, NodeRuns::length * r, links, open);
  }
  return links;
}

}  // namespace

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
    : LinkFinder(snapped, runs, threads) {
  find(triangles, lattice, [&](std::size_t r, std::uint8_t* open) { open_links(runs, members, r, open); });
}

LinkFinder::LinkFinder(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& lattice,
                       const NodeRuns& runs, Threads threads)
    : LinkFinder(snapped, runs, threads) {
  find(triangles, lattice, [&](std::size_t r, std::uint8_t* open) { open_links_of_whole(runs, r, open); });
}

LinkFinder::LinkFinder(const SnappedSurfaces& snapped, const NodeRuns& runs, Threads threads)
    : snapped_(snapped),
      runs_(runs),
      threads_(threads),
      open_(runs.node_count()),
      ranges_(runs.ranges_of_planes(slab_count)),
      slabs_(ranges_.size()) {}

template <typename OpenLinks>
void LinkFinder::find(std::span<const std::uint32_t> triangles, const Lattice& lattice, const OpenLinks& open_links) {
  std::vector<std::pair<int, int>> planes;
  for (const auto& [first, end] : ranges_) planes.emplace_back(runs_[first].z, runs_[end - 1].z + 1);
  const auto by_planes = triangles_by_planes(snapped_, triangles, lattice, planes);
  parallel_for(ranges_.size(), threads_, [&](std::size_t i) {
    const auto [first, end] = ranges_[i];
    for (std::size_t r = first; r < end; ++r) open_links(r, &open_[NodeRuns::length * r]);
    const std::vector<LinkCrossing> crossings =
        link_crossings(snapped_, by_planes[i], lattice, planes[i].first, planes[i].second);
    slabs_[i] = cut_nodes(*snapped_.surfaces, runs_, ranges_[i], crossings, open_.data());
  });
}

std::vector<std::uint8_t> LinkFinder::sides_seen(const std::vector<std::uint8_t>& marked) const {
  std::vector<std::uint8_t> sides(snapped_.surfaces->triangle_count(), 0);
  for (const CutLinks& slab : slabs_) {
    for (const CutNode& node : slab.node) {
      if ((marked[node.node / NodeRuns::length] >> node.node % NodeRuns::length & 1) == 0) continue;
      const std::uint32_t end = node.first_cut + bit_counts[node.cut];
      for (std::uint32_t c = node.first_cut; c < end; ++c) {
        std::uint8_t& seen_so_far = sides[slab.cut[c].side / 2];
        seen_so_far = static_cast<std::uint8_t>(seen_so_far | 1 << slab.cut[c].side % 2);
      }
    }
  }
  return sides;
}

CutLinks LinkFinder::links(const NodeRuns& kept, const std::vector<std::uint8_t>& marked) const {
  CutLinks links;
  links.open.resize(kept.node_count());

  // Each slab counts what it will write, so that all can write to one place.
  std::vector<std::pair<std::size_t, std::size_t>> nodes_and_cuts(slabs_.size());
  parallel_for(slabs_.size(), threads_, [&](std::size_t i) {
    auto& [nodes, cuts] = nodes_and_cuts[i];
    for_irregular(i, kept, marked, links.open, [&, &nodes = nodes, &cuts = cuts](std::size_t, const CutNode* cut) {
      ++nodes;
      if (cut != nullptr) cuts += bit_counts[cut->cut];
    });
  });
  std::size_t nodes = 0, cuts = 0;
  for (auto& counts : nodes_and_cuts) {
    nodes += std::exchange(counts.first, nodes);
    cuts += std::exchange(counts.second, cuts);
  }
  links.node.resize(nodes);
  links.cut.resize(cuts);
  parallel_for(slabs_.size(), threads_, [&](std::size_t i) {
    auto [node, next_cut] = nodes_and_cuts[i];
    for_irregular(i, kept, marked, links.open,
                  [&, &node = node, &next_cut = next_cut](std::size_t to, const CutNode* cut) {
                    links.node[node++] = {static_cast<std::uint32_t>(to), static_cast<std::uint32_t>(next_cut),
                                          cut != nullptr ? cut->cut : std::uint8_t{0}};
                    if (cut == nullptr) return;
                    const LinkCut* first = &slabs_[i].cut[cut->first_cut];
                    std::copy(first, first + bit_counts[cut->cut], &links.cut[next_cut]);
                    next_cut += bit_counts[cut->cut];
                  });
  });
  return links;
}

template <typename Body>
void LinkFinder::for_irregular(std::size_t i, const NodeRuns& kept, const std::vector<std::uint8_t>& marked,
                               std::vector<std::uint8_t>& open, const Body& body) const {
  auto next = slabs_[i].node.begin();
  const auto end = slabs_[i].node.end();
  for (std::size_t r = ranges_[i].first; r < ranges_[i].second; ++r) {
    const NodeRun& run = runs_[r];
    const std::int32_t place = kept.at(run.block, run.y, run.z);
    if (place == NodeRuns::none) continue;
    const std::size_t first = NodeRuns::length * r, first_to = static_cast<std::size_t>(NodeRuns::length * place);
    if (marked[r] == 0 && eight_at(&open_[first]) == eight_of(all_open)) {
      std::memset(&open[first_to], all_open, NodeRuns::length);
      continue;
    }
    std::memcpy(&open[first_to], &open_[first], NodeRuns::length);
    for (unsigned left = marked[r]; left != 0; left &= left - 1) {
      open[first_to + static_cast<std::size_t>(std::countr_zero(left))] = takes_no_part;
    }
    for (unsigned left = irregular_of(eight_at(&open[first_to])); left != 0; left &= left - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      while (next != end && next->node < first + k) ++next;
      body(first_to + k, next != end && next->node == first + k ? &*next : nullptr);
    }
  }
}

void append(CutLinks& links, std::vector<CutLinks>& parts) {
  std::size_t nodes = links.node.size(), cuts = links.cut.size();
  for (const CutLinks& part : parts) {
    nodes += part.node.size();
    cuts += part.cut.size();
  }
  links.node.reserve(nodes);
  links.cut.reserve(cuts);
  for (CutLinks& part : parts) {
    const auto before = static_cast<std::uint32_t>(links.cut.size());
    for (CutNode& node : part.node) node.first_cut += before;
    links.node.insert(links.node.end(), part.node.begin(), part.node.end());
    links.cut.insert(links.cut.end(), part.cut.begin(), part.cut.end());
  }
}

}  // namespace pomona
