#include "generator/diffusion/harmonic/solve_field.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/exterior.h"
#include "generator/diffusion/harmonic/multigrid.h"
#include "generator/diffusion/harmonic/nearest_labels.h"
#include "generator/diffusion/harmonic/patches.h"
#include "generator/diffusion/harmonic/refinement_indicator.h"

namespace pomona {

namespace {

/// Number of coarser levels of the multigrid.
constexpr int halvings = 4;

/// Margin around closed surfaces, in cells: enough for the flood fill of the outside.
constexpr int narrow_margin = 1;

/// Margin around open surfaces, as a share of their longest side: what lies beyond is only modelled.
constexpr double wide_margin = 0.25;

/// The same where sides are hidden: few random walks escape through the gaps of a fruit.
constexpr double fruit_margin = 0.06;

/// Cells per half-thickness of a body: with as many, the error of its influence is at most some 4 %.
constexpr double cells_per_half_thickness = 1.2;

/// A body longer than this many cells is no seed: a patch around it would be too large.
constexpr double longest_small_body = 16;

/// A patch keeps this many cells of the coarser grid around its bodies.
constexpr int patch_margin = 1;

/// The bricks with the largest refinement indicators fill at most this share of a patch, so that their borders and
/// small bodies have room, too. A brick has 128 nodes of its own.
constexpr std::size_t nodes_per_bent_brick = 166;

std::vector<std::uint32_t> all_triangles(const DiffusionSurfaces& surfaces) {
  std::vector<std::uint32_t> all(surfaces.triangle_count());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// Whether some side is hidden.
bool has_boundary(const DiffusionSurfaces& surfaces) {
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (surfaces.is_boundary(t)) return true;
  }
  return false;
}

/// A boundary shows its visible side to the air where it crosses itself, as thin sepals do. If the air sees the visible
/// side of more than this share of the boundary triangles, air has come in.
constexpr double max_inside_out = 0.1;

/// Whether the region that the air reaches is air alone, given the sides that are seen from there. If the surfaces have
/// hidden sides: the air hardly sees the visible side of a boundary. If not: the air sees no triangle from both sides;
/// else the surface is open there, and the region behind it is like the region before it.
bool stays_outside(const DiffusionSurfaces& surfaces, const std::vector<std::uint8_t>& sides_seen) {
  if (!has_boundary(surfaces)) return std::find(sides_seen.begin(), sides_seen.end(), 3) == sides_seen.end();
  std::size_t seen = 0, inside_out = 0;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!surfaces.is_boundary(t) || sides_seen[t] == 0) continue;
    const int visible = surfaces.is_hidden(t, SideOf::front) ? 2 : 1;
    ++seen;
    if ((sides_seen[t] & visible) != 0) ++inside_out;
  }
  return static_cast<double>(inside_out) <= max_inside_out * static_cast<double>(seen);
}

/// The modelled part of a lattice.
struct Inside {
  std::vector<std::uint8_t> outside;  ///< per block of the lattice, a bit for each node that is left out
  SparseBlocks blocks;                ///< all others
  bool is_sealed = true;
};

/// All nodes, except those of the outside if the surfaces are closed.
Inside inside_of(const DiffusionSurfaces& surfaces, const SparseBlocks& all, const ArmFinder& finder, Threads threads) {
  Inside inside;
  inside.outside = reached_from_corner(all, finder.open(), threads);
  inside.is_sealed = stays_outside(surfaces, finder.sides_seen(inside.outside));
  if (!inside.is_sealed) inside.outside.assign(inside.outside.size(), 0);
  inside.blocks = blocks_without(all, inside.outside);
  return inside;
}

/// Lays patches over solved levels, one inside the other.
class Patches {
 public:
  Patches(const SnappedSurfaces& snapped, const Lattice& lattice, const GridOptions& options)
      : snapped_(snapped),
        options_(options),
        middle_(bounds_of(*snapped.surfaces).center()),
        bodies_(small_bodies(*snapped.surfaces, longest_small_body * lattice.spacing)) {}

  /// A patch of half the spacing on the finest level so far, whose solution is known; nothing where that is fine
  /// enough, or where a row would be longer than can be stored.
  std::optional<GridLevel> on(const GridLevel& finest) {
    const Lattice& coarse = finest.lattice;
    const Lattice fine = halved(coarse);
    if (fine.count[0] > max_nodes) return std::nullopt;
    const std::vector<float> bends = options_.refine_above > 0
                                         ? indicator_of_bricks(finest, options_.refine_above, options_.threads)
                                         : std::vector<float>();
    std::optional<PatchNodes> patch = patch_on(coarse, triangles_too_small_for(coarse), bends);
    if (!patch) patch = patch_on(coarse, {}, bends);
    if (!patch) return std::nullopt;
    GridLevel level = level_of(fine, *patch);
    around_ = std::move(patch);
    return level;
  }

 private:
  /// The patch around small bodies, and the bricks with the largest indicators that fit besides; nothing if the bodies
  /// alone need too many nodes.
  std::optional<PatchNodes> patch_on(const Lattice& coarse, const std::vector<std::uint32_t>& small,
                                     const std::vector<float>& bends) const {
    const PatchNodes* within = around_ ? &*around_ : nullptr;
    for (std::size_t max = bends.empty() ? 0 : options_.max_patch_nodes / nodes_per_bent_brick;; max = max * 3 / 4) {
      const std::vector<std::uint8_t> bent = max > 0 ? bricks_to_refine(bends, max) : std::vector<std::uint8_t>();
      if (small.empty() && std::find(bent.begin(), bent.end(), 1) == bent.end()) return std::nullopt;
      PatchNodes patch = patch_around(snapped_, small, coarse, patch_margin, within, bent);
      if (patch.blocks.node_count() <= options_.max_patch_nodes) return patch;
      if (max == 0) return std::nullopt;
    }
  }

  /// The bodies for which this grid is too coarse.
  std::vector<std::uint32_t> triangles_too_small_for(const Lattice& coarse) const {
    std::vector<std::uint32_t> triangles;
    for (const SmallBody& body : bodies_) {
      if (body.half_thickness >= cells_per_half_thickness * coarse.spacing) continue;
      triangles.insert(triangles.end(), body.triangle.begin(), body.triangle.end());
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

  GridLevel level_of(const Lattice& lattice, const PatchNodes& patch) const {
    const ArmFinder finder(snapped_, patch.triangle, lattice, patch.blocks, patch.members, options_.threads);
    std::vector<std::uint8_t> outside(patch.members);
    for (std::uint8_t& bits : outside) bits = static_cast<std::uint8_t>(~bits);
    CutArms arms = finder.arms(patch.blocks, outside);

    // Where an arm leads out of the patch, the coarser grid gives the value.
    for (const CutNode& node : arms.node) {
      std::uint8_t& open = arms.open[node.node];
      if (((open | node.cut) & all_open) != all_open) open |= is_given;
    }
    GridLevel level = make_grid_level(lattice, patch.blocks, std::move(arms), middle_, options_.threads);
    level.is_patch = true;
    return level;
  }

  const SnappedSurfaces& snapped_;
  const GridOptions& options_;
  glm::dvec3 middle_;
  std::vector<SmallBody> bodies_;
  std::optional<PatchNodes> around_;
};

/// A right-hand side of zeros, to which patches add theirs.
void add_empty_rhs(GridLevel& level) {
  level.rhs = RawArray<Quad>(level.blocks.node_count());
  std::fill(level.rhs.data(), level.rhs.data() + level.rhs.size(), Quad{});
}

SolvedGrid kept(GridLevel& level) {
  SolvedGrid grid;
  grid.lattice = level.lattice;
  grid.members.reserve(level.blocks.size());
  for (const BlockArms& block : level.block_arms) grid.members.push_back(block.regular | block.irregular);
  grid.blocks = std::move(level.blocks);
  grid.value = std::move(level.value);
  return grid;
}

/// The field with a small margin; nothing if the surfaces are not closed and need a larger one.
std::optional<PreparedField> prepared_within(const DiffusionSurfaces& surfaces, const GridOptions& options,
                                             int margin) {
  const Threads threads = options.threads;
  const Lattice lattice = lattice_around(surfaces, options.spacing, margin, halvings, options.shift);
  const glm::dvec3 middle = bounds_of(surfaces).center();
  PreparedField prepared;
  prepared.snapped = snapped(surfaces, lattice);

  // Find all arms, then the inside. One thread does that; the others find the triangles of cells meanwhile.
  const SparseBlocks all = all_blocks(lattice.count);
  const ArmFinder finder(prepared.snapped, all_triangles(surfaces), lattice, all, threads);
  CellTriangleFinder cells(prepared.snapped, lattice, options.reach / lattice.spacing);
  Inside inside;
  parallel_for(1 + cells.slab_count(), threads, [&](std::size_t i) {
    if (i == 0) {
      inside = inside_of(surfaces, all, finder, threads);
    } else {
      cells.find(i - 1);
    }
  });
  prepared.is_sealed = inside.is_sealed;
  if (!prepared.is_sealed && margin == narrow_margin) return std::nullopt;

  // Make the two finest levels, whose planes threads share.
  prepared.levels.reserve(1 + halvings);
  CutArms arms = finder.arms(inside.blocks, inside.outside);
  prepared.levels.push_back(make_grid_level(lattice, std::move(inside.blocks), std::move(arms), middle, threads));
  prepared.levels.push_back(coarser(prepared.levels.front(), middle, threads));

  // The coarser levels are too small to share, and the labels are one thread's work, too; the other threads fill cells.
  cells.place();
  const GridLevel& every_other = prepared.levels[1];
  parallel_for(2 + cells.slab_count(), threads, [&](std::size_t i) {
    if (i == 0) {
      prepared.label = nearest_labels(every_other);
    } else if (i == 1) {
      for (int h = 1; h < halvings; ++h) prepared.levels.push_back(coarser(prepared.levels.back(), middle, threads));
    } else {
      cells.fill(i - 2);
    }
  });
  prepared.triangles = cells.taken();
  return prepared;
}

}  // namespace

PreparedField prepared_field(const DiffusionSurfaces& surfaces, const GridOptions& options) {
  auto prepared = prepared_within(surfaces, options, narrow_margin);
  if (prepared) return std::move(*prepared);
  const glm::dvec3 size = bounds_of(surfaces).size();
  const double longest = std::max({size.x, size.y, size.z});
  const bool is_fruit = has_boundary(surfaces);
  const int margin = static_cast<int>((is_fruit ? fruit_margin : wide_margin) * longest / options.spacing);
  return std::move(*prepared_within(surfaces, options, std::max(narrow_margin + 1, margin)));
}

SolvedLevels solved_levels(const SnappedSurfaces& snapped, std::vector<GridLevel> levels, const GridOptions& options) {
  const MultigridOptions multigrid{.cycles = options.cycles, .threads = options.threads};
  SolvedLevels result{solved(std::move(levels), multigrid), 0};
  if (options.finer == 0) return result;
  Patches patches(snapped, result.levels.front().lattice, options);
  for (int i = 0; i < options.finer; ++i) {
    std::optional<GridLevel> patch = patches.on(result.levels.front());
    if (!patch) break;
    add_empty_rhs(result.levels.front());
    result.levels.insert(result.levels.begin(), std::move(*patch));
    ++result.patch_count;
    result.levels = solved_further(std::move(result.levels), 1, multigrid);
  }
  return result;
}

FieldSampler solved_field(PreparedField prepared, const GridOptions& options) {
  auto [levels, patch_count] = solved_levels(prepared.snapped, std::move(prepared.levels), options);
  SolvedGrids grids;
  grids.label = std::move(prepared.label);
  grids.every_other = std::move(levels[patch_count + 1].blocks);
  for (std::size_t l = 0; l <= patch_count; ++l) grids.grids.push_back(kept(levels[l]));
  return {prepared.snapped, std::move(grids), std::move(prepared.triangles)};
}

}  // namespace pomona
