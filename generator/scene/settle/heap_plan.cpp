#include "generator/scene/settle/heap_plan.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <glm/geometric.hpp>

#include "generator/base/units.h"

namespace pomona {

HeapPlan::HeapPlan(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
                   const SettleOptions& options)
    : solids_(solids),
      items_(items),
      options_(options),
      name_(dish.name),
      purpose_(dish.turned ? "scene/drop" : "scene/drop/" + dish.name),
      shapes_(prepared()),
      // Without a bowl the ground must reach under all pieces.
      dish_(dish, {.cell = unit() / 24, .around = 2 * widest() + unit(), .ground = 2 * spread() + 4 * unit()}),
      footprint_(mean_footprint()) {}

std::vector<std::size_t> HeapPlan::solid_numbers() const {
  std::vector<std::size_t> numbers;
  for (const SettleItem& item : items_) numbers.push_back(static_cast<std::size_t>(item.solid));
  return numbers;
}

/// Shapes of the solids that are used. Also sets `sizes_`, which the members after it need.
std::vector<PieceShape> HeapPlan::prepared() {
  constexpr std::size_t all_cells = 100'000'000;  // limit of cells of all grids together: 400 MB
  std::vector<std::uint8_t> used(solids_.size());
  std::vector<double> sizes(solids_.size());
  for (const SettleItem& item : items_) {
    const auto solid = static_cast<std::size_t>(item.solid);
    if (used[solid] == 0) sizes[solid] = size_of(solids_[solid]);
    used[solid] = 1;
    sizes_.unit += sizes[solid] / static_cast<double>(items_.size());
  }
  const auto distinct = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  const int cells = static_cast<int>(std::clamp<std::size_t>(all_cells / distinct, 8000, 40000));
  std::vector<PieceShape> shapes(solids_.size());
  parallel_for(solids_.size(), options_.threads, [&](std::size_t i) {
    if (used[i] != 0) shapes[i] = piece_shape(solids_[i], sizes_.unit, cells);
  });
  for (const PieceShape& made : shapes) sizes_.widest = std::max(sizes_.widest, made.radius);
  return shapes;
}

const PieceArrangement* HeapPlan::arrangement(std::size_t item) const {
  const int index = items_[item].arrangement;
  return index < 0 ? nullptr : &options_.arrangements[static_cast<std::size_t>(index)];
}

bool HeapPlan::is_placed(std::size_t item) const {
  const PieceArrangement* how = arrangement(item);
  return how && how->kind != PieceArrangementKind::heap && how->kind != PieceArrangementKind::as_cut;
}

DropArea HeapPlan::area_of(std::size_t item) const {
  const PieceArrangement* how = arrangement(item);
  const double radius = shape(item).radius;
  if (in_bowl(item) && dish_.form()) return cells_for(radius, how);
  DropRing ring = ring_of(item);
  if (how && how->within > 0) {
    ring.inner = 0;
    ring.outer = how->within;
    ring.middle = how->at;
  }
  return ring;
}

/// The cells of a dish that is not turned, as far from its walls as a piece needs so that it does not start inside
/// them.
DropCells HeapPlan::cells_for(double radius, const PieceArrangement* how) const {
  double widest = 0;
  for (const MeshDish::Place& place : dish_.form()->places()) widest = std::max(widest, place.inset);
  const double inset = std::min(0.8 * radius, 0.7 * widest);
  DropCells cells;
  for (const MeshDish::Place& place : dish_.form()->places()) {
    if (place.inset < inset) continue;
    if (how && how->within > 0 && glm::distance(place.at, how->at) > how->within) continue;
    cells.push_back(place);
  }
  return cells;
}

DropRing HeapPlan::ring_of(std::size_t item) const {
  const double radius = shape(item).radius, rim = dish_.rim_radius();
  // A piece may start against the wall: it slides down, so that heaps become as wide as the bowl.
  if (in_bowl(item)) return {0, std::max(0.0, options_.fill * rim - 0.65 * radius), rim, dish_.rim_height()};
  if (items_[item].beside) return {rim + radius, options_.around * std::max(rim, 2 * sizes_.widest)};
  return {0, std::max(0.0, spread() - radius)};
}

HeightMap HeapPlan::empty_map() const {
  double half = dish_.form() ? dish_.rim_radius() : 0;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    half = std::max(half, ring_of(i).outer + shape(i).radius);
    const PieceArrangement* how = arrangement(i);
    if (how) half = std::max(half, glm::length(how->at) + how->within + shape(i).radius);
  }
  return {dish_, half, sizes_.unit / 9};
}

double HeapPlan::mean_footprint() const {
  double footprint = 0;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const glm::dvec3 size(shape(i).box.size());
    footprint += std::max({size.x * size.y, size.y * size.z, size.z * size.x});
  }
  return footprint / static_cast<double>(items_.size());
}

std::size_t HeapPlan::pieces_in_wave(std::size_t first) const {
  constexpr std::size_t min_pieces = 12;
  const DropArea where = area_of(first);
  if (const auto* cells = std::get_if<DropCells>(&where)) {
    const double all = static_cast<double>(cells->size()) * dish_.form()->cell_area();
    return std::max(min_pieces, static_cast<std::size_t>(0.8 * all / footprint_));
  }
  const auto& ring = std::get<DropRing>(where);
  const double area =
      pi * (ring.outer + 0.5 * sizes_.unit) * (ring.outer + 0.5 * sizes_.unit) - pi * ring.inner * ring.inner;
  return std::max(min_pieces, static_cast<std::size_t>(0.8 * area / footprint_));
}

Funnel HeapPlan::funnel() const {
  if (!dish_.has_bowl()) return {};
  if (const MeshDish* form = dish_.form()) {
    const Box<double>& box = form->box();
    return {.low = 0.9 * dish_.rim_height(), .from = {box.low.x, box.low.z}, .to = {box.high.x, box.high.z}};
  }
  return {.radius = options_.fill * dish_.rim_radius(), .low = 0.9 * dish_.rim_height()};
}

bool HeapPlan::is_outside(std::size_t item, const Pose& pose) const {
  if (!in_bowl(item)) return false;
  const glm::dmat3 turn = glm::mat3_cast(pose.rotation);
  for (const glm::vec3& position : solid(item).mesh.position) {
    const glm::dvec3 p = turn * glm::dvec3(position) + pose.translation;
    if (!dish_.covers(p) || p.y < (dish_.form() ? -1e-4 : 0)) return true;
  }
  return false;
}

}  // namespace pomona
