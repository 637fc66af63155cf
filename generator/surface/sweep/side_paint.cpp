#include "generator/surface/sweep/side_paint.h"

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
      folds_(side.color.folds, Color(1.0f)) {
  for (const Coat& coat : side.coats) coats_.emplace_back(coat);
}

Color SidePaint::operator()(const PaintPlace& place) const {
  Color color = along_(place.along) * around_(place.around) * turn_(place.turn) * folds_(place);
  for (const CoatPaint& coat : coats_) {
    const double share =
        coat.along(place.along) * coat.around(place.around) * coat.turn(place.turn) * coat.folds(place);
    color = blended(color, coat.color(place.along), share);
  }
  return color;
}

}  // namespace pomona
