// From grids to painted diffusion surfaces.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/sweep/side_paint.h"
#include "generator/surface/sweep/spots.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// Collects grids as one named surface with the colours, parts and blur of a sketch.
class GridPainter {
 public:
  /// Adds a surface of this name to `surfaces`, which must outlive the painter.
  GridPainter(DiffusionSurfaces& surfaces, const std::string& name, const Side& front, const Side& back,
              const PaintedBlur& blur);

  void append(const SweptGrid& grid);

  /// Paints spots over one side of the grids, which must be all that have been appended, in the same order.
  void dab(SideOf side, std::span<const Spot> spots, std::span<const SweptGrid> grids);

 private:
  void append_vertex(const SweptGrid& grid, std::size_t vertex);

  DiffusionSurfaces& surfaces_;
  std::int32_t index_;
  std::size_t first_vertex_;
  const Side& front_;
  const Side& back_;
  SidePaint front_paint_, back_paint_;
  BlurPaint blur_;
};

}  // namespace pomona
