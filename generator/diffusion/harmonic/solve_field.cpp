#include "generator/diffusion/harmonic/solve_field.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/bends.h"
#include "generator/diffusion/harmonic/exterior.h"
#include "generator/diffusion/harmonic/multigrid.h"
#include "generator/diffusion/harmonic/nearest_labels.h"
#include "generator/diffusion/harmonic/patches.h"

namespace pomona {

namespace {

/// Times that the grid is halved for the multigrid.
constexpr int halvings = 4;

/// Cells around surfaces that seal everything off: enough for a flood to pass.
constexpr int narrow_margin = 1;

/// Around others, as a share of their longest side: what lies beyond is only modelled.
constexpr double wide_margin = 0.25;

/// The same where sides are hidden: few walks escape through what gaps a fruit has.
constexpr double fruit_margin = 0.06;

/// A body's influence is right within some 4 % once this many cells make its half-thickness.
constexpr double cells_per_half_thickness = 1.2;

/// Bodies longer than this many cells are no seeds; a patch around them would be no patch.
constexpr double longest_small_body = 16;

/// A patch keeps this many cells of the coarser grid around its bodies.
constexpr int patch_margin = 1;

/// A brick has 128 nodes of its own; those that are laid where the solution bends, the most bent, fill this share of a
/// patch at most, so that their borders and small bodies have room, too.
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

/// Boundaries turn their visible side outwards where they cross themselves, as thin sepals do. More than this share of
/// the boundary triangles that air sees, and air has come in.
constexpr double most_inside_out = 0.1;

/// Whether what air reaches is air alone, given the sides that are seen from there. Where sides are hidden, it hardly
/// meets the visible side of a boundary; where none is, no triangle is seen from both sides: else a surface is open
/// there, and what is behind it counts like what is before it.
bool stays_outside(const DiffusionSurfaces& surfaces, const std::vector<std::uint8_t>& sides_seen) {
  if (!has_boundary(surfaces)) return std::find(sides_seen.begin(), sides_seen.end(), 3) == sides_seen.end();
  std::size_t seen = 0, inside_out = 0;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!surfaces.is_boundary(t) || sides_seen[t] == 0) continue;
    const int visible = surfaces.is_hidden(t, SideOf::front) ? 2 : 1;
    ++seen;
    if ((sides_seen[t] & visible) != 0) ++inside_out;
  }
  return static_cast<double>(inside_out) <= most_inside_out * static_cast<double>(seen);
}

/// What of a lattice is modelled.
struct Inside {
  std::vector<std::uint8_t> outside;  ///< per run of the lattice, a bit for each node that is left out
  NodeRuns runs;                      ///< all others
  bool is_sealed = true;
};

/// All nodes but those that the outside holds, if it is sealed off.
Inside inside_of(const DiffusionSurfaces& surfaces, const NodeRuns& all, const LinkFinder& finder, Threads threads) {
  Inside inside;
  inside.outside = reached_from_corner(all, finder.open(), threads);
  inside.is_sealed = stays_outside(surfaces, finder.sides_seen(inside.outside));
  if (!inside.is_sealed) inside.outside.assign(inside.outside.size(), 0);
  inside.runs = runs_without(all, inside.outside);
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
    if (fine.count[0] > most_nodes) return std::nullopt;
    const std::vector<float> bends =
        options_.bend > 0 ? bends_of_bricks(finest, options_.bend, options_.threads) : std::vector<float>();
    std::optional<PatchNodes> patch = patch_on(coarse, triangles_too_small_for(coarse), bends);
    if (!patch) patch = patch_on(coarse, {}, bends);
    if (!patch) return std::nullopt;
    GridLevel level = level_of(fine, *patch);
    around_ = std::move(patch);
    return level;
  }

 private:
  /// Around small bodies, and the most bent bricks that there is room for beside these; nothing if the bodies alone are
  /// too many.
  std::optional<PatchNodes> patch_on(const Lattice& coarse, const std::vector<std::uint32_t>& small,
                                     const std::vector<float>& bends) const {
    const PatchNodes* within = around_ ? &*around_ : nullptr;
    for (std::size_t most = bends.empty() ? 0 : options_.most_patch_nodes / nodes_per_bent_brick;;
         most = most * 3 / 4) {
      const std::vector<std::uint8_t> bent = most > 0 ? most_bent(bends, most) : std::vector<std::uint8_t>();
      if (small.empty() && std::find(bent.begin(), bent.end(), 1) == bent.end()) return std::nullopt;
      PatchNodes patch = patch_around(snapped_, small, coarse, patch_margin, within, bent);
      if (patch.runs.node_count() <= options_.most_patch_nodes) return patch;
      if (most == 0) return std::nullopt;
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
    const LinkFinder finder(snapped_, patch.triangle, lattice, patch.runs, patch.members, options_.threads);
    std::vector<std::uint8_t> outside(patch.members);
    for (std::uint8_t& bits : outside) bits = static_cast<std::uint8_t>(~bits);
    CutLinks links = finder.links(patch.runs, outside);

    // Where a link leads out of the patch, the coarser grid gives the value.
    for (const CutNode& node : links.node) {
      std::uint8_t& open = links.open[node.node];
      if (((open | node.cut) & all_open) != all_open) open |= is_given;
    }
    GridLevel level = make_grid_level(lattice, patch.runs, std::move(links), middle_, options_.threads);
    level.is_patch = true;
    return level;
  }

  const SnappedSurfaces& snapped_;
  const GridOptions& options_;
  glm::dvec3 middle_;
  std::vector<SmallBody> bodies_;
  std::optional<PatchNodes> around_;
};

/// A right-hand side of nothing, for patches to put theirs on.
void add_empty_rhs(GridLevel& level) {
  level.rhs = RawArray<Quad>(level.runs.node_count());
  std::fill(level.rhs.data(), level.rhs.data() + level.rhs.size(), Quad{});
}

SolvedGrid kept(GridLevel& level) {
  SolvedGrid grid;
  grid.lattice = level.lattice;
  grid.members.reserve(level.runs.size());
  for (const RunLinks& run : level.run_links) grid.members.push_back(run.regular | run.irregular);
  grid.runs = std::move(level.runs);
  grid.value = std::move(level.value);
  return grid;
}

/// Nothing if the surfaces leave more to solve than the margin has room for.
std::optional<PreparedField> prepared_within(const DiffusionSurfaces& surfaces, const GridOptions& options,
                                             int margin) {
  const Threads threads = options.threads;
  const Lattice lattice = lattice_around(surfaces, options.spacing, margin, halvings, options.shift);
  const glm::dvec3 middle = bounds_of(surfaces).center();
  PreparedField prepared;
  prepared.snapped = snapped(surfaces, lattice);

  // Find all links; then what lies inside. That is one thread's work: others find the cells' triangles meanwhile.
  const NodeRuns all = all_node_runs(lattice.count);
  const LinkFinder finder(prepared.snapped, all_triangles(surfaces), lattice, all, threads);
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
  CutLinks links = finder.links(inside.runs, inside.outside);
  prepared.levels.push_back(make_grid_level(lattice, std::move(inside.runs), std::move(links), middle, threads));
  prepared.levels.push_back(coarser(prepared.levels.front(), middle, threads));

  // The coarser ones are too small to share; to know parts is one thread's work, too, and cells take what is left.
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

FieldLookUp solved_field(PreparedField prepared, const GridOptions& options) {
  auto [levels, patch_count] = solved_levels(prepared.snapped, std::move(prepared.levels), options);
  SolvedGrids grids;
  grids.label = std::move(prepared.label);
  grids.every_other = std::move(levels[patch_count + 1].runs);
  for (std::size_t l = 0; l <= patch_count; ++l) grids.grids.push_back(kept(levels[l]));
  return {prepared.snapped, std::move(grids), std::move(prepared.triangles)};
}

}  // namespace pomona
