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

/// Patches stop at this many nodes: with all that belongs to them, some 60 bytes each.
constexpr std::size_t most_patch_nodes = 1'000'000;

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

/// Builds the levels of one field.
class Levels {
 public:
  Levels(const SnappedSurfaces& snapped, const Lattice& lattice, const GridOptions& options)
      : snapped_(snapped), options_(options), middle_(bounds_of(*snapped.surfaces).center()), lattice_(lattice) {}

  /// Patches, the finest first; then the whole grid, at `patch_count`; then ever coarser ones.
  std::vector<GridLevel> run() {
    std::vector<GridLevel> levels = patches();
    patch_count = levels.size();
    levels.push_back(whole());
    for (int i = 0; i < halvings; ++i) levels.push_back(coarser(levels.back(), middle_, options_.threads));
    for (std::size_t l = 1; l <= patch_count; ++l) {
      levels[l].rhs = RawArray<Quad>(levels[l].runs.node_count());
      std::fill(levels[l].rhs.data(), levels[l].rhs.data() + levels[l].rhs.size(), Quad{});
    }
    return levels;
  }

  std::size_t patch_count = 0;
  bool is_sealed = true;

 private:
  /// All links first; then only the nodes that the outside does not hold, if it is sealed off.
  GridLevel whole() {
    const NodeRuns all = all_node_runs(lattice_.count);
    std::vector<std::uint8_t> members(all.size());
    for (std::size_t r = 0; r < all.size(); ++r) members[r] = static_cast<std::uint8_t>((1 << all.inside(r)) - 1);
    const LinkFinder finder(snapped_, all_triangles(*snapped_.surfaces), lattice_, all, members, options_.threads);
    std::vector<std::uint8_t> outside = reached_from_corner(all, finder.open(), options_.threads);
    is_sealed = stays_outside(*snapped_.surfaces, finder.sides_seen(outside));
    if (!is_sealed) outside.assign(outside.size(), 0);
    NodeRuns runs = runs_without(all, outside);
    CutLinks links = finder.links(runs, outside);
    return make_grid_level(lattice_, std::move(runs), std::move(links), middle_, options_.threads);
  }

  std::vector<GridLevel> patches() const {
    // Only small bodies may ask for finer grids.
    std::vector<GridLevel> levels;
    if (options_.finer == 0) return levels;
    const auto bodies = small_bodies(*snapped_.surfaces, longest_small_body * lattice_.spacing);
    Lattice coarse = lattice_;
    PatchNodes around;
    for (int i = 0; i < options_.finer; ++i) {
      // Take the bodies for which this grid is still too coarse.
      std::vector<std::uint32_t> triangles;
      for (const SmallBody& body : bodies) {
        if (body.half_thickness >= cells_per_half_thickness * coarse.spacing) continue;
        triangles.insert(triangles.end(), body.triangle.begin(), body.triangle.end());
      }

      // Lay a patch of half the spacing around these bodies, within the patch before it.
      const Lattice fine = halved(coarse);
      if (triangles.empty() || *std::max_element(fine.count.begin(), fine.count.end()) > most_nodes) break;
      std::sort(triangles.begin(), triangles.end());
      PatchNodes patch = patch_around(snapped_, triangles, coarse, patch_margin, i == 0 ? nullptr : &around);
      if (patch.runs.node_count() > most_patch_nodes) break;
      levels.insert(levels.begin(), patch_level(fine, patch));
      around = std::move(patch);
      coarse = fine;
    }
    return levels;
  }

  GridLevel patch_level(const Lattice& lattice, const PatchNodes& patch) const {
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
  Lattice lattice_;
};

SolvedGrid kept(GridLevel& level) {
  SolvedGrid grid;
  grid.lattice = level.lattice;
  grid.members.resize(level.runs.size());
  for (std::size_t node = 0; node < level.links.open.size(); ++node) {
    if (level.links.open[node] & takes_no_part) continue;
    std::uint8_t& bits = grid.members[node / NodeRuns::length];
    bits = static_cast<std::uint8_t>(bits | 1 << node % NodeRuns::length);
  }
  grid.runs = std::move(level.runs);
  grid.value = std::move(level.value);
  return grid;
}

/// Nothing if the surfaces leave more to solve than the margin has room for.
std::optional<PreparedField> prepared_within(const DiffusionSurfaces& surfaces, const GridOptions& options,
                                             int margin) {
  const Lattice lattice = lattice_around(surfaces, options.spacing, margin, halvings, options.shift);
  PreparedField prepared;
  prepared.snapped = snapped(surfaces, lattice);
  Levels builder(prepared.snapped, lattice, options);
  prepared.levels = builder.run();
  if (!builder.is_sealed && margin == narrow_margin) return std::nullopt;
  prepared.patch_count = builder.patch_count;
  prepared.is_sealed = builder.is_sealed;
  prepared.triangles = CellTriangles(prepared.snapped, lattice, options.reach / lattice.spacing, options.threads);
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

FieldLookUp solved_field(PreparedField prepared, const GridOptions& options) {
  std::vector<GridLevel> levels =
      solved(std::move(prepared.levels), {.cycles = options.cycles, .threads = options.threads});
  SolvedGrids grids;
  GridLevel& every_other = levels[prepared.patch_count + 1];
  grids.label = nearest_labels(every_other);
  grids.every_other = std::move(every_other.runs);
  for (std::size_t l = 0; l <= prepared.patch_count; ++l) grids.grids.push_back(kept(levels[l]));
  return {prepared.snapped, std::move(grids), std::move(prepared.triangles)};
}

}  // namespace pomona
