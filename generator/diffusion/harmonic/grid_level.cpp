#include "generator/diffusion/harmonic/grid_level.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Number of ranges of planes. More ranges than threads balance the work.
constexpr std::size_t range_count = 12;

BlockArms arms_of_block(const SparseBlocks& blocks, const CutArms& arms, std::size_t r) {
  const NodeBlock& block = blocks[r];
  const auto offset = [&](int y, int z) {
    const std::int32_t other = blocks.at(block.column, y, z);
    return other == SparseBlocks::none ? 0 : SparseBlocks::length * (other - static_cast<std::int32_t>(r));
  };
  BlockArms result{offset(block.y - 1, block.z), offset(block.y + 1, block.z), offset(block.y, block.z - 1),
                   offset(block.y, block.z + 1)};
  result.parity = static_cast<std::uint8_t>((block.y + block.z) & 1);
  result.plain = eight_at(&arms.open[SparseBlocks::length * r]) == eight_of(all_open) ? 1 : 0;
  if (result.plain) {
    result.regular = 255;
    return result;
  }
  const std::uint64_t eight = eight_at(&arms.open[SparseBlocks::length * r]);
  result.irregular = irregular_of(eight);
  result.regular = static_cast<std::uint8_t>(~(result.irregular | lowest_bits(eight >> 7)));
  return result;
}

/// The weight of an arm that leaves the lattice, relative to an open arm; its value is 0. A field that falls like 1 / r
/// loses the share h (n r) / r^2 over one spacing h along n.
float pull_of_outside(const Lattice& lattice, const Node& at, int direction, const glm::dvec3& middle) {
  const glm::dvec3 place = lattice.origin + lattice.spacing * glm::dvec3(at[0], at[1], at[2]) - middle;
  const double outwards = (direction % 2 == 1 ? 1 : -1) * place[direction / 2];
  return static_cast<float>(std::max(0.0, lattice.spacing * outwards / glm::dot(place, place)));
}

bool leaves_lattice(const Lattice& lattice, const Node& at, int direction) {
  const auto axis = static_cast<std::size_t>(direction / 2);
  return direction % 2 == 1 ? at[axis] + 1 >= lattice.count[axis] : at[axis] == 0;
}

/// The equation of a node whose arms end on surfaces [Shortley & Weller 1938]: along each axis the second difference
/// over arms of different lengths, times the square of the spacing.
Stencil stencil_at(const Lattice& lattice, const Node& at, const CutArms& arms, const CutNode& node,
                   const glm::dvec3& middle) {
  // The lengths of the arms along each axis. Terms of weight 0 are added, too: that is faster than a test.
  std::array<float, 6> length{1, 1, 1, 1, 1, 1}, nearness{}, pull{};
  std::uint32_t next_cut = node.first_cut;
  for (unsigned left = node.cut; left != 0; left &= left - 1) {
    length[static_cast<std::size_t>(std::countr_zero(left))] = std::max(arms.cut[next_cut++].theta, min_theta);
  }
  Stencil stencil;
  const std::uint8_t open = arms.open[node.node];
  std::array<float, 3> stretch{};
  for (std::size_t a = 0; a < 3; ++a) stretch[a] = 2 / (length[2 * a] + length[2 * a + 1]);
  for (std::size_t d = 0; d < 6; ++d) {
    nearness[d] = static_cast<float>(open >> d & 1);
    pull[d] = stencil.weight[d] = stretch[d / 2] * nearness[d];
  }

  // Cut arms add the colour of their surface; arms that leave the lattice add 0.
  next_cut = node.first_cut;
  for (unsigned left = node.cut; left != 0; left &= left - 1) {
    const auto d = static_cast<std::size_t>(std::countr_zero(left));
    nearness[d] = 1 / length[d];
    pull[d] = stretch[d / 2] * nearness[d];
    const Color& color = arms.cut[next_cut++].color;
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

/// The cut of a node's arm; nothing if it is not cut.
const ArmCut* cut_at(const GridLevel& level, std::size_t node, int direction) {
  if (level.arms.open[node] == all_open) return nullptr;
  const CutNode& found = level.arms.node[level.stencil_of(node / SparseBlocks::length, node % SparseBlocks::length)];
  if ((found.cut >> direction & 1) == 0) return nullptr;
  return &level.arms.cut[found.first_cut + bit_counts[found.cut & ((1u << direction) - 1)]];
}

/// Whether the fine blocks under a coarse block show at once that all its arms are open.
bool is_plain_below(const GridLevel& fine, const NodeBlock& block) {
  for (int column = 2 * block.column - 1; column <= 2 * block.column + 1; ++column) {
    const std::int32_t middle = fine.blocks.at(column, 2 * block.y, 2 * block.z);
    if (middle == SparseBlocks::none || !fine.block_arms[static_cast<std::size_t>(middle)].plain) return false;
    if (column < 2 * block.column) continue;
    for (const auto& [y, z] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const std::int32_t beside = fine.blocks.at(column, 2 * block.y + y, 2 * block.z + z);
      if (beside == SparseBlocks::none || !fine.block_arms[static_cast<std::size_t>(beside)].plain) return false;
    }
  }
  return true;
}

/// A coarse node's arms: open where both fine halves are, else cut where the nearer half is.
void add_coarse_node(const GridLevel& fine, const Node& at, std::size_t node, CutArms& part, std::uint8_t& open) {
  // Nodes that the fine grid does not have, or leaves out, are left out here, too.
  const std::int32_t found = fine.blocks.node_at(2 * at[0], 2 * at[1], 2 * at[2]);
  const auto here = static_cast<std::size_t>(found);
  open = takes_no_part;
  if (found == SparseBlocks::none || (fine.arms.open[here] & takes_no_part)) return;

  // Two fine arms make one coarse arm: a cut in the second lies half an arm further on.
  const BlockArms& block = fine.block_arms[here / SparseBlocks::length];
  const std::array<std::int32_t, 6> offset = {-1, 1, block.y_down, block.y_up, block.z_down, block.z_up};
  unsigned opened = fine.arms.open[here] & all_open;
  for (unsigned left = opened; left != 0; left &= left - 1) {
    const auto d = static_cast<std::size_t>(std::countr_zero(left));
    const auto middle = static_cast<std::size_t>(found + offset[d]);
    if ((fine.arms.open[middle] >> d & 1) == 0) opened &= ~(1u << d);
  }
  open = static_cast<std::uint8_t>(opened);
  if (open == all_open) return;
  CutNode cut{static_cast<std::uint32_t>(node), static_cast<std::uint32_t>(part.cut.size()), 0};
  for (unsigned left = all_open & ~opened; left != 0; left &= left - 1) {
    const auto d = static_cast<std::size_t>(std::countr_zero(left));
    const bool first_open = fine.arms.open[here] >> d & 1;
    const std::size_t middle = first_open ? static_cast<std::size_t>(found + offset[d]) : here;
    const ArmCut* nearer = cut_at(fine, middle, static_cast<int>(d));
    if (nearer == nullptr) continue;
    cut.cut = static_cast<std::uint8_t>(cut.cut | 1 << d);
    part.cut.push_back({0.5f * nearer->theta + (first_open ? 0.5f : 0.0f), nearer->side, nearer->color});
  }
  part.node.push_back(cut);
}

CutArms coarser_arms(const GridLevel& fine, const SparseBlocks& coarse_runs, Threads threads) {
  // Each range of planes writes its cut nodes into a part of its own.
  const auto ranges = coarse_runs.ranges_of_planes(range_count);
  CutArms arms;
  arms.open.resize(coarse_runs.node_count());
  std::vector<CutArms> parts(ranges.size());
  parallel_for(ranges.size(), threads, [&](std::size_t i) {
    // A coarse plane has about a fourth of the cut nodes of a fine one, and there are half as many planes.
    parts[i].node.reserve(fine.arms.node.size() / (3 * ranges.size()));
    parts[i].cut.reserve(fine.arms.cut.size() / (3 * ranges.size()));

    // If a whole block is open, its arms need not be tested one by one.
    for (std::size_t r = ranges[i].first; r < ranges[i].second; ++r) {
      const NodeBlock& block = coarse_runs[r];
      const bool is_plain = is_plain_below(fine, block);
      for (int k = 0; k < SparseBlocks::length; ++k) {
        const std::size_t node = SparseBlocks::length * r + static_cast<std::size_t>(k);
        if (is_plain) {
          arms.open[node] = all_open;
        } else {
          add_coarse_node(fine, {SparseBlocks::length * block.column + k, block.y, block.z}, node, parts[i],
                          arms.open[node]);
        }
      }
    }
  });

  // The parts are joined in the order of the ranges, so that threads make no difference.
  append(arms, parts);
  return arms;
}

}  // namespace

std::size_t GridLevel::bytes() const {
  return blocks.bytes() + arms.open.size() + arms.node.size() * sizeof(CutNode) + arms.cut.size() * sizeof(ArmCut) +
         block_arms.size() * sizeof(BlockArms) + stencil.bytes() + value.bytes() + rhs.bytes() + residual.bytes();
}

GridLevel make_grid_level(const Lattice& lattice, SparseBlocks blocks, CutArms arms, const glm::dvec3& middle,
                          Threads threads) {
  GridLevel level;
  level.lattice = lattice;
  level.blocks = std::move(blocks);
  level.arms = std::move(arms);
  level.ranges = level.blocks.ranges_of_planes(range_count);
  level.planes = level.blocks.ranges_of_planes(level.blocks.size());
  level.block_arms.resize(level.blocks.size());
  level.stencil = RawArray<Stencil>(level.arms.node.size());
  level.value = RawArray<Quad>(level.blocks.node_count());
  level.residual = RawArray<Quad>(level.blocks.node_count());

  parallel_for(level.ranges.size(), threads, [&](std::size_t i) {
    const auto [first, end] = level.ranges[i];
    const auto before = std::lower_bound(level.arms.node.begin(), level.arms.node.end(), SparseBlocks::length * first,
                                         [](const CutNode& node, std::size_t from) { return node.node < from; });
    auto stencil = static_cast<std::uint32_t>(before - level.arms.node.begin());
    for (std::size_t r = first; r < end; ++r) {
      level.block_arms[r] = arms_of_block(level.blocks, level.arms, r);
      level.block_arms[r].first_stencil = stencil;
      const NodeBlock& block = level.blocks[r];
      std::fill_n(&level.value[SparseBlocks::length * r], SparseBlocks::length, Quad{});
      if (level.block_arms[r].irregular == 0) continue;
      for (int k = 0; k < SparseBlocks::length; ++k) {
        if ((level.block_arms[r].irregular >> k & 1) == 0) continue;
        level.stencil[stencil] = stencil_at(lattice, {SparseBlocks::length * block.column + k, block.y, block.z},
                                            level.arms, level.arms.node[stencil], middle);
        ++stencil;
      }
    }
  });
  return level;
}

GridLevel coarser(const GridLevel& fine, const glm::dvec3& middle, Threads threads) {
  const Lattice lattice = doubled(fine.lattice);

  // A coarse block is stored if either fine block under it is.
  std::vector<ColumnMask> wanted(static_cast<std::size_t>(lattice.count[1] * lattice.count[2]), 0);
  for (std::size_t r = 0; r < fine.blocks.size(); ++r) {
    const NodeBlock& block = fine.blocks[r];
    if ((block.y | block.z) & 1) continue;
    wanted[static_cast<std::size_t>(block.z / 2 * lattice.count[1] + block.y / 2)] |= ColumnMask{1} << block.column / 2;
  }
  SparseBlocks blocks(lattice.count, wanted);
  CutArms arms = coarser_arms(fine, blocks, threads);
  GridLevel level = make_grid_level(lattice, std::move(blocks), std::move(arms), middle, threads);
  level.rhs = RawArray<Quad>(level.blocks.node_count());
  std::fill(level.rhs.data(), level.rhs.data() + level.rhs.size(), Quad{});
  return level;
}

}  // namespace pomona
