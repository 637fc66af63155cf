#include "generator/diffusion/harmonic/multigrid.h"

#include <algorithm>
#include <bit>
#include <type_traits>
#include <utility>

#include "generator/diffusion/harmonic/pipelined_sweeps.h"

/// Inlines all calls inside a function: the work at one node is less than that of a call.
#define POMONA_FLAT [[gnu::flatten]]

namespace pomona {

namespace {

/// Sweeps on the coarsest level, instead of a direct solution.
constexpr int coarsest_sweeps = 24;

constexpr int length = SparseBlocks::length;

/// Bits of nodes that have no equation.
constexpr std::uint8_t not_solved = takes_no_part | is_given;

/// A node of some level, with what its equation needs.
struct At {
  std::size_t node;
  std::uint8_t open;
  const Stencil* stencil;  ///< null if all six arms are open
};

/// Calls body(r) for every block of a level.
template <typename Body>
void for_runs(const GridLevel& level, Threads threads, const Body& body) {
  parallel_for(level.ranges.size(), threads_for(level, threads), [&](std::size_t i) {
    for (std::size_t r = level.ranges[i].first; r < level.ranges[i].second; ++r) body(r);
  });
}

/// Calls body(at) for the nodes of block r with x of parity `first`, except those with a bit of `skipped`. The order
/// does not matter as long as no node reads another. Nodes of one kind are handled together: a test for each node would
/// cost more than most equations.
template <typename Body>
void for_every_other(const GridLevel& level, std::size_t r, int first, std::uint8_t skipped, const Body& body) {
  const BlockArms& block = level.block_arms[r];
  const std::size_t start = length * r;
  if (block.plain) {
    for (std::size_t k = static_cast<std::size_t>(first); k < length; k += 2) body(At{start + k, all_open, nullptr});
    return;
  }
  const unsigned wanted = 0x55u << first;
  for (unsigned left = block.regular & wanted; left != 0; left &= left - 1) {
    body(At{start + static_cast<std::size_t>(std::countr_zero(left)), all_open, nullptr});
  }
  const Stencil* stencil = level.stencil.data() + block.first_stencil;
  for (unsigned left = block.irregular & wanted; left != 0; left &= left - 1) {
    const std::size_t node = start + static_cast<std::size_t>(std::countr_zero(left));
    const std::uint8_t open = level.arms.open[node];
    if (open & skipped) continue;
    body(At{node, open, stencil + bit_counts[block.irregular & ((left & (0 - left)) - 1)]});
  }
}

/// Offsets from a node to its six neighbours.
std::array<std::ptrdiff_t, 6> offsets(const BlockArms& block) {
  return {-1, 1, block.y_down, block.y_up, block.z_down, block.z_up};
}

/// The sum of values beyond open arms, weighted.
Quad pulled(const Quad* value, const At& at, const std::array<std::ptrdiff_t, 6>& offset) {
  // Closed arms have weight 0, so any value may be there; only along x there may be no memory to read.
  const Quad* here = value + at.node;
  const auto& weight = at.stencil->weight;
  Quad sum = weight[x_down] * here[at.open >> x_down & 1 ? -1 : 0];
  sum += weight[x_up] * here[at.open >> x_up & 1 ? 1 : 0];
  for (std::size_t d = y_down; d <= z_up; ++d) sum += weight[d] * here[offset[d]];
  return sum;
}

Quad sum_of_six(const Quad* value, const std::array<std::ptrdiff_t, 6>& offset) {
  return (value[-1] + value[1]) + (value[offset[y_down]] + value[offset[y_up]]) +
         (value[offset[z_down]] + value[offset[z_up]]);
}

/// The sum over the axes along which a node with six open arms lies between coarse ones.
Quad sum_between(const Quad* value, const std::array<std::ptrdiff_t, 6>& offset, std::uint8_t along) {
  Quad sum{};
  if (along >> x_up & 1) sum += value[-1] + value[1];
  if (along >> y_up & 1) sum += value[offset[y_down]] + value[offset[y_up]];
  if (along >> z_up & 1) sum += value[offset[z_down]] + value[offset[z_up]];
  return sum;
}

/// The same for any node, over open arms only.
Quad sum_between(const Quad* value, const At& at, const std::array<std::ptrdiff_t, 6>& offset, std::uint8_t along) {
  if (at.stencil == nullptr) return sum_between(value + at.node, offset, along);
  Quad sum{};
  for (std::size_t d = 0; d < 6; ++d) {
    if ((at.open & along) >> d & 1) sum += value[static_cast<std::ptrdiff_t>(at.node) + offset[d]];
  }
  return sum;
}

/// The value at a node between coarse nodes, from the ends of its arms along these axes, which are neighbours or
/// surfaces: linear along each axis; shorter arms have a larger weight.
Quad value_between(const GridLevel& level, const At& at, const std::array<std::ptrdiff_t, 6>& offset,
                   std::uint8_t along) {
  Quad sum = sum_between(level.value.data(), at, offset, along);
  const CutNode& node = level.arms.node[level.stencil_of(at.node / length, static_cast<int>(at.node % length))];
  std::uint32_t next_cut = node.first_cut;
  for (std::size_t d = 0; d < 6; ++d) {
    if ((node.cut >> d & 1) == 0) continue;
    const ArmCut& cut = level.arms.cut[next_cut++];
    if (along >> d & 1) sum += Quad{cut.color.r, cut.color.g, cut.color.b, 1} / std::max(cut.theta, min_theta);
  }
  return at.stencil->odd_inverse * sum;
}

/// Gauss-Seidel for the nodes of block r with x + y + z of parity `color`.
template <bool with_source, bool with_rhs>
void relax_run(GridLevel& level, std::size_t r, int color) {
  constexpr float sixth = 1.0f / 6;
  const BlockArms& block = level.block_arms[r];
  const auto offset = offsets(block);
  const int first = (block.parity + color) & 1;
  Quad* value = level.value.data();
  for_every_other(level, r, first, not_solved, [&](const At& at) {
    Quad sum = at.stencil ? pulled(value, at, offset) : sum_of_six(value + at.node, offset);
    if constexpr (with_source) {
      if (at.stencil) sum += at.stencil->source;
    }
    if constexpr (with_rhs) sum += level.rhs[at.node];
    value[at.node] = (at.stencil ? at.stencil->inverse : sixth) * sum;
  });
}

/// Directions as bits, known when the program is compiled.
template <std::uint8_t bits>
using Along = std::integral_constant<std::uint8_t, bits>;

/// The unknown of a level: the field itself, or a correction to it, which is 0 on surfaces.
enum class Sought { field, correction };

/// The levels, finest first.
class Multigrid {
 public:
  Multigrid(std::vector<GridLevel> levels, const MultigridOptions& options)
      : levels_(std::move(levels)), options_(options) {}

  std::vector<GridLevel> block() {
    const std::size_t coarsest = levels_.size() - 1;
    relax_coarsest(2 * coarsest_sweeps, Sought::field);
    return run_from(coarsest);
  }

  /// The levels from `known` on are solved.
  std::vector<GridLevel> run_from(std::size_t known) {
    for (std::size_t l = known; l-- > 0;) {
      take(2, l, [&](auto first, auto end, int step) { start_from_coarser(l, first, end, step); });
      for (int i = 0; i < (l == 0 ? options_.cycles : 1); ++i) cycle(l, Sought::field);
    }
    return std::move(levels_);
  }

 private:
  /// Whether patches have put something on the right-hand side.
  bool has_rhs(std::size_t l, Sought sought) const {
    return sought == Sought::correction || (l > 0 && levels_[l - 1].is_patch);
  }

  /// A V cycle.
  void cycle(std::size_t l, Sought sought) {
    if (l + 1 == levels_.size()) {
      relax_coarsest(coarsest_sweeps, sought);
      return;
    }
    go_down(l, sought);
    if (levels_[l].is_patch) {
      hand_to_covered(l);
      cycle(l + 1, Sought::field);
    } else {
      restrict_to_coarser(l);
      cycle(l + 1, Sought::correction);
    }
    go_up(l, sought);
  }

  void relax_coarsest(int sweeps, Sought sought) {
    const std::size_t l = levels_.size() - 1;
    for (int half_sweep = 0; half_sweep < 2 * sweeps; ++half_sweep) {
      for (const auto& [first, end] : levels_[l].planes) relax(l, sought, first, end, half_sweep);
    }
  }

  /// The part of a V cycle before the next coarser level.
  void go_down(std::size_t l, Sought sought) {
    const int n = 2 * options_.sweeps;
    take(n + 2, l, [&](auto first, auto end, int step) {
      if (step < n) {
        relax(l, sought, first, end, step);
      } else if (step == n) {
        find_residual(l, sought, first, end);
      } else {
        restrict_to_edges(l, first, end);
      }
    });
  }

  /// The part of a V cycle after it.
  void go_up(std::size_t l, Sought sought) {
    const int n = 2 * options_.sweeps;
    take(n + 2, l, [&](auto first, auto end, int step) {
      if (step < 2) {
        correct_from_coarser(l, first, end, step);
      } else {
        relax(l, sought, first, end, step - 2);
      }
    });
  }

  template <typename Body>
  void take(int steps, std::size_t l, const Body& body) {
    sweep_planes(levels_[l], steps, options_.threads, body);
  }

  /// Half a Gauss-Seidel sweep over some blocks: even steps relax the nodes of even parity, odd steps the others.
  POMONA_FLAT void relax(std::size_t l, Sought sought, std::size_t first, std::size_t end, int half_sweep) {
    GridLevel& level = levels_[l];
    const int color = half_sweep % 2;
    const bool with_rhs = has_rhs(l, sought);
    for (std::size_t r = first; r < end; ++r) {
      if (sought == Sought::correction) {
        relax_run<false, true>(level, r, color);
      } else if (with_rhs) {
        relax_run<true, true>(level, r, color);
      } else {
        relax_run<true, false>(level, r, color);
      }
    }
  }

  /// The residual at the nodes of even parity; at the odd ones it is 0, as they were relaxed last. Where two
  /// coordinates are odd, it already has its weight for the restriction.
  POMONA_FLAT void find_residual(std::size_t l, Sought sought, std::size_t first, std::size_t end) {
    GridLevel& level = levels_[l];
    const Quad* value = level.value.data();
    const bool with_rhs = has_rhs(l, sought);
    for (std::size_t r = first; r < end; ++r) {
      const auto offset = offsets(level.block_arms[r]);
      const NodeBlock& block = level.blocks[r];
      const float between = (block.y & 1) | (block.z & 1) ? 0.25f : 1.0f;
      for_every_other(level, r, level.block_arms[r].parity, takes_no_part, [&](const At& at) {
        Quad rest = at.stencil ? pulled(value, at, offset) - at.stencil->diagonal * value[at.node]
                               : sum_of_six(value + at.node, offset) - 6.0f * value[at.node];
        if (with_rhs) rest += level.rhs[at.node];
        if (sought == Sought::field && at.stencil) rest += at.stencil->source;
        if (at.open & is_given) rest = Quad{};
        level.residual[at.node] = (between != 1 && at.stencil ? at.stencil->odd_inverse : between) * rest;
      });
    }
  }

  /// Nodes on edges between coarse nodes (one odd coordinate) gather from their faces.
  POMONA_FLAT void restrict_to_edges(std::size_t l, std::size_t first, std::size_t end) {
    GridLevel& fine = levels_[l];
    for (std::size_t r = first; r < end; ++r) {
      const NodeBlock& block = fine.blocks[r];
      if ((block.y & 1) && (block.z & 1)) continue;
      if (block.y & 1) {
        gather_edges<0b110011>(fine, r, 0);
      } else if (block.z & 1) {
        gather_edges<0b001111>(fine, r, 0);
      } else {
        gather_edges<0b111100>(fine, r, 1);
      }
    }
  }

  template <std::uint8_t across>
  static void gather_edges(GridLevel& fine, std::size_t r, int odd_x) {
    const Quad* residual = fine.residual.data();
    const auto offset = offsets(fine.block_arms[r]);
    for_every_other(fine, r, odd_x, takes_no_part, [&](const At& at) {
      const Quad sum = at.open & is_given ? Quad{} : sum_between(residual, at, offset, across);
      fine.residual[at.node] = (at.stencil ? at.stencil->odd_inverse : 0.5f) * sum;
    });
  }

  /// The rest of the transpose of correct_from_coarser(), into the right-hand side of a correction.
  void restrict_to_coarser(std::size_t l) {
    GridLevel& fine = levels_[l];
    GridLevel& coarse = levels_[l + 1];
    const Quad* residual = fine.residual.data();

    // Coarse nodes gather from their edges. The equations' unit is the square of the spacing: 4 times the mean, while
    // the weights add up to 8.
    for_runs(coarse, options_.threads, [&](std::size_t r) {
      for_children(fine, coarse, r, [&](std::size_t node, const At* at, const auto& offset) {
        coarse.value[node] = coarse.rhs[node] = Quad{};
        if (at == nullptr) return;
        Quad sum = residual[at->node];
        const Quad* beside = residual + at->node;
        for (std::size_t d = 0; d < 6; ++d) {
          if (at->open == all_open || (at->open >> d & 1)) sum += beside[offset[d]];
        }
        coarse.rhs[node] = 0.5f * sum;
      });
    });
  }

  /// Calls body(coarse node, its fine node or nothing, offsets there) for block r of the coarse level.
  template <typename Body>
  static void for_children(const GridLevel& fine, const GridLevel& coarse, std::size_t r, const Body& body) {
    const NodeBlock& block = coarse.blocks[r];
    for (int half = 0; half < 2; ++half) {
      const std::int32_t below = fine.blocks.at(2 * block.column + half, 2 * block.y, 2 * block.z);
      std::array<std::ptrdiff_t, 6> offset{};
      if (below != SparseBlocks::none) offset = offsets(fine.block_arms[static_cast<std::size_t>(below)]);
      for (int k = 0; k < length / 2; ++k) {
        const std::size_t node = length * r + static_cast<std::size_t>(length / 2 * half + k);
        const std::size_t child = static_cast<std::size_t>(length * below + 2 * k);
        if (below == SparseBlocks::none || (coarse.arms.open[node] & takes_no_part)) {
          body(node, nullptr, offset);
          continue;
        }
        const At at{child, fine.arms.open[child], nullptr};
        body(node, &at, offset);
      }
    }
  }

  /// Calls body(at, coarse node, offsets) for the nodes of block r of a level that lie on coarse ones.
  template <typename Body>
  void for_parents(std::size_t l, std::size_t r, const Body& body) const {
    const GridLevel &fine = levels_[l], &coarse = levels_[l + 1];
    const NodeBlock& block = fine.blocks[r];
    if ((block.y | block.z) & 1) return;
    const std::int32_t above = coarse.blocks.at(block.column / 2, block.y / 2, block.z / 2);
    if (above == SparseBlocks::none) return;
    const auto offset = offsets(fine.block_arms[r]);
    const auto first = static_cast<std::size_t>(length * above + length / 2 * (block.column % 2));
    for_every_other(fine, r, 0, takes_no_part, [&](const At& at) {
      const std::size_t parent = first + at.node % length / 2;
      if ((coarse.arms.open[parent] & takes_no_part) == 0) body(at, parent, offset);
    });
  }

  /// Makes the equations of the coarse nodes inside a patch those that the patch's solution fulfils (full
  /// approximation scheme [Brandt 1977]; local refinement as in [McCormick 1989]).
  void hand_to_covered(std::size_t l) {
    GridLevel &patch = levels_[l], &coarse = levels_[l + 1];
    for_runs(patch, options_.threads, [&](std::size_t block) {
      for_parents(l, block, [&](const At& at, std::size_t parent, const auto&) {
        if ((at.open & is_given) == 0) coarse.value[parent] = patch.value[at.node];
      });
    });
    const auto hand_over = [&](const At& at, std::size_t parent, const auto& offset) {
      if (at.open & is_given) return;
      const std::size_t r = parent / length;
      const std::uint8_t open = coarse.arms.open[parent];
      const At above{
          parent, open,
          open == all_open ? nullptr : &coarse.stencil[coarse.stencil_of(r, static_cast<int>(parent % length))]};
      const auto beside = offsets(coarse.block_arms[r]);
      const Quad& here = coarse.value[parent];
      const Quad fulfilled = above.stencil ? above.stencil->diagonal * here -
                                                 pulled(coarse.value.data(), above, beside) - above.stencil->source
                                           : 6.0f * here - sum_of_six(coarse.value.data() + parent, beside);
      coarse.rhs[parent] =
          fulfilled + 0.5f * (patch.residual[at.node] + sum_between(patch.residual.data(), at, offset, all_open));
    };
    for_runs(patch, options_.threads, [&](std::size_t block) { for_parents(l, block, hand_over); });
  }

  /// Calls body(at, offsets, directions along odd axes) for the nodes of block r with so many odd coordinates. The
  /// directions are a type's value: no node needs to ask for them.
  template <typename Body>
  static void for_between(const GridLevel& level, std::size_t r, int odd_coordinates, const Body& body) {
    const NodeBlock& block = level.blocks[r];
    const int odd_x = odd_coordinates - (block.y & 1) - (block.z & 1);
    if (odd_x < 0 || odd_x > 1) return;
    const auto offset = offsets(level.block_arms[r]);
    const auto go_along = [&](auto along) {
      for_every_other(level, r, along() & 1, takes_no_part, [&](const At& at) { body(at, offset, along); });
    };
    switch (odd_x | (block.y & 1) << 1 | (block.z & 1) << 2) {
      case 0b001:
        return go_along(Along<0b000011>());
      case 0b010:
        return go_along(Along<0b001100>());
      case 0b011:
        return go_along(Along<0b001111>());
      case 0b100:
        return go_along(Along<0b110000>());
      case 0b101:
        return go_along(Along<0b110011>());
      case 0b110:
        return go_along(Along<0b111100>());
      case 0b111:
        return go_along(Along<0b111111>());
      default:
        return;
    }
  }

  /// Goes from the nodes that lie on coarse ones to those between, so that each finds its neighbours along odd axes
  /// done: in the first step on planes that hold coarse nodes, in the second on those between.
  template <typename OnCoarse, typename Between>
  void go_from_coarser(std::size_t l, std::size_t first, std::size_t end, int step, const OnCoarse& on_coarse,
                       const Between& between) const {
    const GridLevel& fine = levels_[l];
    if ((fine.blocks[first].z & 1) != step) return;
    if (step == 0) {
      for (std::size_t r = first; r < end; ++r) for_parents(l, r, on_coarse);
    }
    for (int odd = 1; odd <= 2 + step; ++odd) {
      for (std::size_t r = first; r < end; ++r) for_between(fine, r, odd, between);
    }
  }

  /// The correction of a node between coarse ones is the mean over the axes on which it lies between; a surface there
  /// is not corrected.
  POMONA_FLAT void correct_from_coarser(std::size_t l, std::size_t first, std::size_t end, int step) {
    GridLevel& fine = levels_[l];
    Quad* correction = fine.residual.data();
    const GridLevel& coarse = levels_[l + 1];
    go_from_coarser(
        l, first, end, step,
        [&](const At& at, std::size_t parent, const auto&) {
          correction[at.node] = fine.is_patch ? coarse.value[parent] - fine.value[at.node] : coarse.value[parent];
          fine.value[at.node] += correction[at.node];
        },
        [&](const At& at, const auto& offset, auto along) {
          constexpr float share = 1.0f / static_cast<float>(bit_counts[decltype(along)::value]);
          const Quad sum = sum_between(correction, at, offset, along);
          correction[at.node] = (at.stencil ? at.stencil->odd_inverse : share) * sum;
          fine.value[at.node] += correction[at.node];
        });
  }

  /// A first guess between coarse nodes: the mean of the neighbours that are known, or else what the surfaces give.
  POMONA_FLAT void start_from_coarser(std::size_t l, std::size_t first, std::size_t end, int step) {
    GridLevel& fine = levels_[l];
    const GridLevel& coarse = levels_[l + 1];
    go_from_coarser(
        l, first, end, step,
        [&](const At& at, std::size_t parent, const auto&) { fine.value[at.node] = coarse.value[parent]; },
        [&](const At& at, const auto& offset, auto along) {
          if (at.stencil == nullptr) {
            constexpr auto beside = static_cast<float>(bit_counts[decltype(along)::value]);
            fine.value[at.node] = sum_between(fine.value.data() + at.node, offset, along) / beside;
            return;
          }
          if ((at.open & is_given) != 0) {
            // The border value of the patch; values beyond a surface must not reach it.
            fine.value[at.node] = value_between(fine, at, offset, along);
            return;
          }
          const auto known = static_cast<std::uint8_t>(at.open & along);
          if (known == 0) {
            const Quad& source = at.stencil->source;
            fine.value[at.node] = source[3] > 0 ? source / source[3] : Quad{};
            return;
          }
          const Quad sum = sum_between(fine.value.data(), at, offset, known);
          fine.value[at.node] = sum / static_cast<float>(bit_counts[known]);
        });
  }

  std::vector<GridLevel> levels_;
  MultigridOptions options_;
};

}  // namespace

std::vector<GridLevel> solved(std::vector<GridLevel> levels, const MultigridOptions& options) {
  return Multigrid(std::move(levels), options).block();
}

std::vector<GridLevel> solved_further(std::vector<GridLevel> levels, std::size_t known,
                                      const MultigridOptions& options) {
  return Multigrid(std::move(levels), options).run_from(known);
}

}  // namespace pomona
