#include "generator/diffusion/harmonic/cut_arms.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "generator/diffusion/harmonic/crossings.h"

namespace pomona {

namespace {

/// Ranges of planes that are worked on one by one; more than threads, so that they even out.
constexpr std::size_t slab_count = 16;

/// A block's nodes before any surface: arms to nodes that are no members lead nowhere.
void open_arms(const SparseBlocks& blocks, std::span<const std::uint8_t> members, std::size_t r, std::uint8_t* open) {
  const NodeBlock& block = blocks[r];
  const auto members_of = [&](int column, int y, int z) -> unsigned {
    const std::int32_t found = blocks.at(column, y, z);
    return found == SparseBlocks::none ? 0u : members[static_cast<std::size_t>(found)];
  };
  const unsigned here = members[r], before = members_of(block.column - 1, block.y, block.z),
                 after = members_of(block.column + 1, block.y, block.z);
  const std::array<unsigned, 6> beside = {here << 1 | before >> 7,
                                          here >> 1 | (after & 1) << 7,
                                          members_of(block.column, block.y - 1, block.z),
                                          members_of(block.column, block.y + 1, block.z),
                                          members_of(block.column, block.y, block.z - 1),
                                          members_of(block.column, block.y, block.z + 1)};

  // Most blocks lie among others, or hold nothing.
  const unsigned all = beside[0] & beside[1] & beside[2] & beside[3] & beside[4] & beside[5] & here & 255;
  if (all == 255 || here == 0) {
    std::memset(open, all == 255 ? all_open : takes_no_part, SparseBlocks::length);
    return;
  }
  for (int k = 0; k < SparseBlocks::length; ++k) {
    unsigned bits = 0;
    for (unsigned d = 0; d < 6; ++d) bits |= (beside[d] >> k & 1) << d;
    open[k] = here >> k & 1 ? static_cast<std::uint8_t>(bits) : takes_no_part;
  }
}

/// The same where the blocks hold a whole lattice and all its nodes are members: only the border has closed arms.
void open_arms_of_whole(const SparseBlocks& blocks, std::size_t r, std::uint8_t* open) {
  const NodeBlock& block = blocks[r];
  const Node& count = blocks.count();
  int bits = all_open;
  if (block.y == 0) bits &= ~(1 << y_down);
  if (block.y == count[1] - 1) bits &= ~(1 << y_up);
  if (block.z == 0) bits &= ~(1 << z_down);
  if (block.z == count[2] - 1) bits &= ~(1 << z_up);
  std::memset(open, bits, SparseBlocks::length);
  if (block.column == 0) open[0] = static_cast<std::uint8_t>(open[0] & ~(1 << x_down));
  const int beyond = count[0] - SparseBlocks::length * block.column;  // the first node that the lattice does not have
  if (beyond > SparseBlocks::length) return;
  open[beyond - 1] = static_cast<std::uint8_t>(open[beyond - 1] & ~(1 << x_up));
  std::fill(open + beyond, open + SparseBlocks::length, takes_no_part);
}

/// The triangle's side that a node sees along an arm in some direction.
std::uint32_t side_seen(const ArmCrossing& crossing, std::size_t direction) {
  const bool front_ahead = direction % 2 == 1;
  return 2 * crossing.triangle + (front_ahead != crossing.front_ahead ? 0 : 1);
}

ArmCut seen(const DiffusionSurfaces& surfaces, const ArmCrossing& crossing, std::size_t direction, float theta) {
  const std::uint32_t side = side_seen(crossing, direction);
  const std::vector<Color>& color = side % 2 == 0 ? surfaces.front_color : surfaces.back_color;
  const glm::uvec3& t = surfaces.triangle[crossing.triangle];
  return {theta, side,
          crossing.weight[0] * color[t.x] + crossing.weight[1] * color[t.y] + crossing.weight[2] * color[t.z]};
}

/// The ends of crossed arms, by the block in which they lie: end 2 c is the node of crossing c, end 2 c + 1 the next.
/// Crossings come by triangle and are wanted by node; chains bring them there with one visit each.
class EndsOfRuns {
 public:
  EndsOfRuns(const SparseBlocks& blocks, std::pair<std::size_t, std::size_t> range,
             const std::vector<ArmCrossing>& crossings)
      : first_run_(range.first), first_(range.second - range.first, none), next_(2 * crossings.size()) {
    for (std::uint32_t c = 0; c < crossings.size(); ++c) {
      const Node& node = crossings[c].node;
      Node ahead = node;
      ++ahead[static_cast<std::size_t>(crossings[c].axis)];
      add(blocks.node_at(node[0], node[1], node[2]), 2 * c);
      add(blocks.node_at(ahead[0], ahead[1], ahead[2]), 2 * c + 1);
    }
  }

  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t first(std::size_t block) const { return first_[block - first_run_]; }
  std::uint32_t next(std::uint32_t end) const { return next_[end]; }

 private:
  void add(std::int32_t node, std::uint32_t end) {
    if (node == SparseBlocks::none) return;
    const std::size_t block = static_cast<std::size_t>(node) / SparseBlocks::length - first_run_;
    if (block >= first_.size()) return;  // another slab's, before or after
    next_[end] = std::exchange(first_[block], end);
  }

  std::size_t first_run_;
  std::vector<std::uint32_t> first_, next_;
};

/// The nearest crossings around the nodes of one block.
class NearestOfRun {
 public:
  explicit NearestOfRun(const std::vector<ArmCrossing>& crossings) : crossings_(crossings) {}

  void clear() {
    cut_ = {};
    nodes_ = 0;
  }

  void keep_if_nearest(std::uint32_t end) {
    const std::uint32_t c = end / 2;
    const ArmCrossing& crossing = crossings_[c];
    const bool is_ahead = end % 2 == 1;
    const int x = crossing.node[0] + (is_ahead && crossing.axis == 0 ? 1 : 0);
    const auto k = static_cast<std::size_t>(x % SparseBlocks::length);
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

  /// Adds the nodes with a cut, of which `first` is the first of the block; their arms are open no longer.
  void add_nodes(const DiffusionSurfaces& surfaces, std::size_t first, CutArms& arms, std::uint8_t* open) const {
    for (unsigned nodes = nodes_; nodes != 0; nodes &= nodes - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(nodes));
      open[first + k] = static_cast<std::uint8_t>(open[first + k] & ~cut_[k]);
      arms.node.push_back(
          {static_cast<std::uint32_t>(first + k), static_cast<std::uint32_t>(arms.cut.size()), cut_[k]});
      for (unsigned directions = cut_[k]; directions != 0; directions &= directions - 1) {
        const auto d = static_cast<std::size_t>(std::countr_zero(directions));
        const Nearest& nearest = nearest_[k][d];
        arms.cut.push_back(seen(surfaces, crossings_[nearest.crossing], d, nearest.theta));
      }
    }
  }

 private:
  struct Nearest {
    float theta = 0;
    std::uint32_t crossing = 0;
  };
  const std::vector<ArmCrossing>& crossings_;
  unsigned nodes_ = 0;                                    ///< a bit for each that has a cut
  std::array<std::uint8_t, SparseBlocks::length> cut_{};  ///< a bit per direction
  std::array<std::array<Nearest, 6>, SparseBlocks::length> nearest_;
};

/// The cut nodes of some blocks, by node; `open` loses what is cut.
CutArms cut_nodes(const DiffusionSurfaces& surfaces, const SparseBlocks& blocks,
                  std::pair<std::size_t, std::size_t> range, const std::vector<ArmCrossing>& crossings,
                  std::uint8_t* open) {
  CutArms arms;
  arms.node.reserve(crossings.size());
  arms.cut.reserve(2 * crossings.size());
  const EndsOfRuns ends(blocks, range, crossings);
  NearestOfRun nearest(crossings);
  for (std::size_t r = range.first; r < range.second; ++r) {
    if (ends.first(r) == EndsOfRuns::none) continue;
    nearest.clear();
    for (std::uint32_t end = ends.first(r); end != EndsOfRuns::none; end = ends.next(end)) nearest.keep_if_nearest(end);
    nearest.add_nodes(surfaces, SparseBlocks::length * r, arms, open);
  }
  return arms;
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

ArmFinder::ArmFinder(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& lattice,
                     const SparseBlocks& blocks, std::span<const std::uint8_t> members, Threads threads)
    : ArmFinder(snapped, blocks, threads) {
  find(triangles, lattice, [&](std::size_t r, std::uint8_t* open) { open_arms(blocks, members, r, open); });
}

ArmFinder::ArmFinder(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& lattice,
                     const SparseBlocks& blocks, Threads threads)
    : ArmFinder(snapped, blocks, threads) {
  find(triangles, lattice, [&](std::size_t r, std::uint8_t* open) { open_arms_of_whole(blocks, r, open); });
}

ArmFinder::ArmFinder(const SnappedSurfaces& snapped, const SparseBlocks& blocks, Threads threads)
    : snapped_(snapped),
      blocks_(blocks),
      threads_(threads),
      open_(blocks.node_count()),
      ranges_(blocks.ranges_of_planes(slab_count)),
      slabs_(ranges_.size()) {}

template <typename OpenArms>
void ArmFinder::find(std::span<const std::uint32_t> triangles, const Lattice& lattice, const OpenArms& open_arms) {
  std::vector<std::pair<int, int>> planes;
  for (const auto& [first, end] : ranges_) planes.emplace_back(blocks_[first].z, blocks_[end - 1].z + 1);
  const auto by_planes = triangles_by_planes(snapped_, triangles, lattice, planes);
  parallel_for(ranges_.size(), threads_, [&](std::size_t i) {
    const auto [first, end] = ranges_[i];
    for (std::size_t r = first; r < end; ++r) open_arms(r, &open_[SparseBlocks::length * r]);
    const std::vector<ArmCrossing> crossings =
        arm_crossings(snapped_, by_planes[i], lattice, planes[i].first, planes[i].second);
    slabs_[i] = cut_nodes(*snapped_.surfaces, blocks_, ranges_[i], crossings, open_.data());
  });
}

std::vector<std::uint8_t> ArmFinder::sides_seen(const std::vector<std::uint8_t>& marked) const {
  std::vector<std::uint8_t> sides(snapped_.surfaces->triangle_count(), 0);
  for (const CutArms& slab : slabs_) {
    for (const CutNode& node : slab.node) {
      if ((marked[node.node / SparseBlocks::length] >> node.node % SparseBlocks::length & 1) == 0) continue;
      const std::uint32_t end = node.first_cut + bit_counts[node.cut];
      for (std::uint32_t c = node.first_cut; c < end; ++c) {
        std::uint8_t& seen_so_far = sides[slab.cut[c].side / 2];
        seen_so_far = static_cast<std::uint8_t>(seen_so_far | 1 << slab.cut[c].side % 2);
      }
    }
  }
  return sides;
}

CutArms ArmFinder::arms(const SparseBlocks& kept, const std::vector<std::uint8_t>& marked) const {
  CutArms arms;
  arms.open.resize(kept.node_count());

  // Each slab counts what it will write, so that all can write to one place.
  std::vector<std::pair<std::size_t, std::size_t>> nodes_and_cuts(slabs_.size());
  parallel_for(slabs_.size(), threads_, [&](std::size_t i) {
    auto& [nodes, cuts] = nodes_and_cuts[i];
    for_irregular(i, kept, marked, arms.open, [&, &nodes = nodes, &cuts = cuts](std::size_t, const CutNode* cut) {
      ++nodes;
      if (cut != nullptr) cuts += bit_counts[cut->cut];
    });
  });
  std::size_t nodes = 0, cuts = 0;
  for (auto& counts : nodes_and_cuts) {
    nodes += std::exchange(counts.first, nodes);
    cuts += std::exchange(counts.second, cuts);
  }
  arms.node.resize(nodes);
  arms.cut.resize(cuts);
  parallel_for(slabs_.size(), threads_, [&](std::size_t i) {
    auto [node, next_cut] = nodes_and_cuts[i];
    for_irregular(i, kept, marked, arms.open,
                  [&, &node = node, &next_cut = next_cut](std::size_t to, const CutNode* cut) {
                    arms.node[node++] = {static_cast<std::uint32_t>(to), static_cast<std::uint32_t>(next_cut),
                                         cut != nullptr ? cut->cut : std::uint8_t{0}};
                    if (cut == nullptr) return;
                    const ArmCut* first = &slabs_[i].cut[cut->first_cut];
                    std::copy(first, first + bit_counts[cut->cut], &arms.cut[next_cut]);
                    next_cut += bit_counts[cut->cut];
                  });
  });
  return arms;
}

template <typename Body>
void ArmFinder::for_irregular(std::size_t i, const SparseBlocks& kept, const std::vector<std::uint8_t>& marked,
                              std::vector<std::uint8_t>& open, const Body& body) const {
  auto next = slabs_[i].node.begin();
  const auto end = slabs_[i].node.end();
  for (std::size_t r = ranges_[i].first; r < ranges_[i].second; ++r) {
    const NodeBlock& block = blocks_[r];
    const std::int32_t place = kept.at(block.column, block.y, block.z);
    if (place == SparseBlocks::none) continue;
    const std::size_t first = SparseBlocks::length * r,
                      first_to = static_cast<std::size_t>(SparseBlocks::length * place);
    if (marked[r] == 0 && eight_at(&open_[first]) == eight_of(all_open)) {
      std::memset(&open[first_to], all_open, SparseBlocks::length);
      continue;
    }
    std::memcpy(&open[first_to], &open_[first], SparseBlocks::length);
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

void append(CutArms& arms, std::vector<CutArms>& parts) {
  std::size_t nodes = arms.node.size(), cuts = arms.cut.size();
  for (const CutArms& part : parts) {
    nodes += part.node.size();
    cuts += part.cut.size();
  }
  arms.node.reserve(nodes);
  arms.cut.reserve(cuts);
  for (CutArms& part : parts) {
    const auto before = static_cast<std::uint32_t>(arms.cut.size());
    for (CutNode& node : part.node) node.first_cut += before;
    arms.node.insert(arms.node.end(), part.node.begin(), part.node.end());
    arms.cut.insert(arms.cut.end(), part.cut.begin(), part.cut.end());
  }
}

}  // namespace pomona
