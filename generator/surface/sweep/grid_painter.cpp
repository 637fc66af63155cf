#include "generator/surface/sweep/grid_painter.h"

#include <algorithm>

namespace pomona {

PaintPlace paint_place(const SweptGrid& grid, std::size_t vertex) {
  PaintPlace place;
  place.along = grid.along[vertex];
  const bool is_pole = grid.is_pole[vertex] != 0;
  if (!is_pole) place.around = grid.around[vertex];
  if (grid.turn.empty() || !grid.turn[vertex]) return place;

  place.turn = grid.turn[vertex];
  const int fold = grid.fold[vertex], folds = grid.folds_around;
  const bool on_fold_line = folds > 1 && grid.around[vertex] == 0;
  place.fold = fold;
  place.fold_before = on_fold_line ? (fold + folds - 1) % folds : fold;
  return place;
}

SidePaint::CoatPaint::CoatPaint(const Coat& coat)
    : color(coat.color), along(coat.along), around(coat.around), turn(coat.turn), folds(coat.folds, 1.0) {}

SidePaint::SidePaint(const Side& side)
    : along_(side.color.along),
      around_(side.color.around),
      turn_(side.color.turn),
      folds_(side.color.folds, Color(1.0f)),
      cells_(side.cells) {
  for (const Coat& coat : side.coats) coats_.emplace_back(coat);
}

Color SidePaint::operator()(const PaintPlace& place) const {
  Color color = along_(place.along) * around_(place.around) * turn_(place.turn) * folds_(place);
  for (const CoatPaint& coat : coats_) {
    const double share =
        coat.along(place.along) * coat.around(place.around) * coat.turn(place.turn) * coat.folds(place);
    color = blended(color, coat.color(place.along), share);
  }
  if (cells_ && place.cell)
    color = blended(color, cells_->color(*place.cell), cells_->cover(*place.cell) * cells_->along(place.along));
  return color;
}

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
  PaintPlace place = paint_place(grid, v);
  surfaces_.position.emplace_back(grid.position[v]);
  if (!grid.front_cell.empty()) place.cell = grid.front_cell[v];
  surfaces_.front_color.push_back(front_paint_(place));
  if (!grid.back_cell.empty()) place.cell = grid.back_cell[v];
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
