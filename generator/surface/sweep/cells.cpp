#include "generator/surface/sweep/cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "generator/surface/sweep/grid_place.h"
#include "generator/surface/sweep/law_seats.h"

namespace pomona {

namespace {

constexpr double max_cells = 20'000;

/// Looks seats up from the height of a place outwards, as long as they may be nearer than those found.
class SeatFinder {
 public:
  explicit SeatFinder(std::span<const glm::dvec3> seats) : seats_(seats.begin(), seats.end()) {
    std::stable_sort(seats_.begin(), seats_.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  }

  /// The distances of the nearest and the second nearest seat.
  std::array<double, 2> nearest(const glm::dvec3& place) const {
    std::array<double, 2> found{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const auto middle = std::lower_bound(seats_.begin(), seats_.end(), place.y,
                                         [](const glm::dvec3& seat, double y) { return seat.y < y; });
    for (auto above = middle; above != seats_.end() && above->y - place.y < found[1]; ++above)
      take(glm::distance(*above, place), found);
    for (auto below = middle; below != seats_.begin() && place.y - (below - 1)->y < found[1]; --below)
      take(glm::distance(*(below - 1), place), found);
    return found;
  }

 private:
  static void take(double distance, std::array<double, 2>& found) {
    if (distance < found[0]) {
      found = {distance, found[0]};
    } else {
      found[1] = std::min(found[1], distance);
    }
  }

  std::vector<glm::dvec3> seats_;
};

std::vector<double> cells_of(const SweptGrid& grid, const Template& fruit, const SurfaceSketch& sketch,
                             const CellSketch& cells, VariantKey key) {
  const LawSketch& law = fruit.laws.at(static_cast<std::size_t>(cells.law));
  if (law_room(law, sketch.vertical) > max_cells)
    refuse(fruit, sketch, "more than 20 000 cells", "make the spacing of their law larger");
  const GridPlaces places(grid);
  std::vector<glm::dvec3> seats;
  for (const LawSeat& seat : law_seats(law, sketch.vertical, law_draws(law, key)))
    seats.push_back(places.at(seat.along, seat.azimuth).position);
  if (seats.size() < 2)
    refuse(fruit, sketch, "the law \"" + law.name + "\" of its cells has fewer than two seats here",
           "make the spacing of the law smaller, or its band longer");
  return cell_places(grid.position, seats);
}

/// \param towards 1: the front, -1: the back
void raise(SweptGrid& grid, const CellSketch& cells, const std::vector<double>& cell, double towards) {
  const std::vector<glm::dvec3> normals = unit_normals(grid);
  for (std::size_t v = 0; v < grid.position.size(); ++v)
    grid.position[v] += towards * cells.raise(cell[v]) * cells.along(grid.along[v]) * normals[v];
}

}  // namespace

std::vector<double> cell_places(std::span<const glm::dvec3> places, std::span<const glm::dvec3> seats) {
  const SeatFinder finder(seats);
  std::vector<double> found;
  found.reserve(places.size());
  for (const glm::dvec3& place : places) {
    const auto [first, second] = finder.nearest(place);
    found.push_back(first + second > 0 ? 2 * first / (first + second) : 1);
  }
  return found;
}

SweptGrid with_cells(SweptGrid grid, const Template& fruit, const SurfaceSketch& sketch, VariantKey key) {
  if (sketch.front.cells) grid.front_cell = cells_of(grid, fruit, sketch, *sketch.front.cells, key);
  if (sketch.back.cells) grid.back_cell = cells_of(grid, fruit, sketch, *sketch.back.cells, key);
  if (sketch.front.cells) raise(grid, *sketch.front.cells, grid.front_cell, 1);
  if (sketch.back.cells) raise(grid, *sketch.back.cells, grid.back_cell, -1);
  return grid;
}

}  // namespace pomona
