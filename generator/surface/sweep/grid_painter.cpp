#include "generator/surface/sweep/grid_painter.h"

#include <algorithm>
#include <vector>

namespace pomona {

GridPainter::GridPainter(DiffusionSurfaces& surfaces, const std::string& name, const Side& front, const Side& back,
                         const PaintedBlur& blur)
    : surfaces_(surfaces),
      index_(static_cast<std::int32_t>(surfaces.surface_names.size())),
      first_vertex_(surfaces.vertex_count()),
      front_(front),
      back_(back),
      front_paint_(front),
      back_paint_(back),
      blur_(blur) {
  surfaces_.surface_names.push_back(name);
}

void GridPainter::append(const SweptGrid& grid) {
  const auto first = static_cast<std::uint32_t>(surfaces_.vertex_count());
  for (std::size_t v = 0; v < grid.position.size(); ++v) append_vertex(grid, v);
  for (const glm::uvec3& t : grid.triangle) {
    surfaces_.triangle.push_back(t + glm::uvec3(first));
    surfaces_.surface.push_back(index_);
    surfaces_.front_part.push_back(front_.part);
    surfaces_.back_part.push_back(back_.part);
  }
}

void GridPainter::append_vertex(const SweptGrid& grid, std::size_t v) {
  const PaintPlace place = paint_place(grid, v);
  surfaces_.position.emplace_back(grid.position[v]);
  surfaces_.front_color.push_back(front_paint_(place));
  surfaces_.back_color.push_back(back_paint_(place));
  surfaces_.blur.push_back(static_cast<float>(blur_(place)));
  surfaces_.front_hidden.push_back(front_.hidden ? 1 : 0);
  surfaces_.back_hidden.push_back(back_.hidden ? 1 : 0);
}

void GridPainter::dab(SideOf side, std::span<const Spot> spots, std::span<const SweptGrid> grids) {
  if (spots.empty()) return;
  std::vector<Color>& colors = side == SideOf::front ? surfaces_.front_color : surfaces_.back_color;
  std::size_t first = first_vertex_;
  for (const SweptGrid& grid : grids) {
    const auto begin = colors.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(grid.position.size());
    const std::vector<Color> painted = with_spots(grid, {begin, end}, spots);
    std::copy(painted.begin(), painted.end(), begin);
    first += grid.position.size();
  }
}

}  // namespace pomona
