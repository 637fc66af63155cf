// From grids to painted diffusion surfaces.
#pragma once

#include <cstdint>
#include <string>

#include "generator/surface/swept_grid.h"

namespace pomona {

/// Collects grids as one named surface with the colours, parts and blur of a sketch.
class GridPainter {
 public:
  /// Adds a surface of this name to `surfaces`, which must outlive the painter.
  GridPainter(DiffusionSurfaces& surfaces, const std::string& name, const Side& front, const Side& back,
              const Ramp<double>& blur);

  void append(const SweptGrid& grid);

 private:
  void append_vertex(const SweptGrid& grid, std::size_t vertex);

  DiffusionSurfaces& surfaces_;
  std::int32_t index_;
  const Side& front_;
  const Side& back_;
  const Ramp<double>& blur_;
  Color front_mean_, back_mean_;  ///< of the ramps around, for poles
};

}  // namespace pomona
