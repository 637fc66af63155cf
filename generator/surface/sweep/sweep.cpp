#include "generator/surface/sweep/sweep.h"

#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "generator/base/error.h"
#include "generator/surface/orientation.h"
#include "generator/surface/sweep/grid_painter.h"
#include "generator/surface/sweep/mesh_surfaces.h"
#include "generator/surface/sweep/sheet_shells.h"
#include "generator/surface/sweep/spots.h"
#include "generator/surface/sweep/surface_grids.h"
#include "generator/surface/sweep/swept_fruit.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

namespace {

[[noreturn]] void refuse_undecided(const Template& fruit, const DiffusionSurfaces& surfaces, const Undecided& shell) {
  const std::string& name = surfaces.surface_names[static_cast<std::size_t>(shell.surface)];
  std::array<char, 80> place{};
  std::snprintf(place.data(), place.size(), "%.4g, %.4g, %.4g", shell.place.x, shell.place.y, shell.place.z);
  refuse_entry(fruit, "mesh", name,
               std::string("which way its shell at ") + place.data() + " (m) should face cannot be told: " + shell.why,
               "write flip = true to turn it, or flip = false to leave it as it is");
}

}  // namespace

SweptFruit swept_fruit(const Template& fruit, const SweepOptions& options) {
  DiffusionSurfaces surfaces;
  std::vector<Spot> raised;
  surfaces.part_names = fruit.parts;
  for (const SurfaceSketch& sketch : fruit.surfaces) {
    GridPainter painter(surfaces, sketch.name, sketch.front, sketch.back, sketch.blur);
    const std::vector<SweptGrid> grids = swept_grids(fruit, sketch, options);
    for (const SweptGrid& grid : grids) painter.append(grid);
    if (sketch.front.spots.empty() && sketch.back.spots.empty()) continue;
    std::vector<SweptGrid> coarser;
    if (options.detail > 1) coarser = swept_grids(fruit, sketch, for_placing(options));
    for (const SideOf side : {SideOf::front, SideOf::back}) {
      const std::vector<Spot> spots = placed_spots(fruit, sketch, side, coarser.empty() ? grids : coarser, options);
      painter.dab(side, spots, grids);
      for (const Spot& spot : raised_spots(spots, side)) raised.push_back(spot);
    }
  }
  append_sheets(surfaces, fruit, options);
  const std::size_t drawn = surfaces.triangle_count();
  std::vector<std::uint8_t> turns(drawn, 0);
  for (const MeshSketch& mesh : fruit.meshes) {
    surfaces = joined(surfaces, mesh_surfaces(fruit, mesh));
    check_meshes_together(fruit, mesh, surfaces.triangle_count() - drawn);
    turns.resize(surfaces.triangle_count(), may_turn(mesh) ? 1 : 0);
  }
  Oriented result = oriented(std::move(surfaces), turns);
  for (const Undecided& shell : result.undecided) refuse_undecided(fruit, result.surfaces, shell);
  return {std::move(result.surfaces), std::move(raised)};
}

DiffusionSurfaces sweep(const Template& fruit, const SweepOptions& options) {
  return swept_fruit(fruit, options).surfaces;
}

}  // namespace pomona
