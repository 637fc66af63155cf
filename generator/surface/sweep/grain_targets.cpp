#include "generator/surface/sweep/grain_targets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "generator/surface/sweep/grid_place.h"

namespace pomona {

namespace {

constexpr double min_density = 0.01;

bool in_band(const SweptGrid& grid, const glm::uvec3& t, const GrainGround& ground) {
  const auto [min, max] = std::minmax({grid.along[t.x], grid.along[t.y], grid.along[t.z]});
  return max >= ground.along_from && min <= ground.along_to;
}

/// Places around for the corners of one triangle that do not jump where the horizontal curve starts again. Poles lie
/// at every place around; they get the mean of the others.
std::array<double, 3> places_around(const SweptGrid& grid, const glm::uvec3& t) {
  // Corners more than half a turn apart lie on both sides of the curve's start.
  std::array<double, 3> around{};
  double min = 1, max = 0;
  for (int k = 0; k < 3; ++k) {
    if (grid.is_pole[t[k]] != 0) continue;
    min = std::min(min, grid.around[t[k]]);
    max = std::max(max, grid.around[t[k]]);
  }

  // If they do, places behind the start count on from 1.
  double sum = 0;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    if (grid.is_pole[t[k]] != 0) continue;
    const double at = grid.around[t[k]];
    around[static_cast<std::size_t>(k)] = max - min > 0.5 && at < 0.5 ? at + 1 : at;
    sum += around[static_cast<std::size_t>(k)];
    ++count;
  }
  for (int k = 0; k < 3; ++k) {
    if (grid.is_pole[t[k]] != 0 && count > 0) around[static_cast<std::size_t>(k)] = sum / count;
  }
  return around;
}

/// The fold of a triangle: that of its first corner.
int fold_of(const SweptGrid& grid, const glm::uvec3& t, const std::array<double, 3>& around) {
  int fold = grid.fold[t.x];
  double first = 2;
  for (int k = 0; k < 3; ++k) {
    if (grid.is_pole[t[k]] != 0 || around[static_cast<std::size_t>(k)] >= first) continue;
    first = around[static_cast<std::size_t>(k)];
    fold = grid.fold[t[k]];
  }
  return fold;
}

bool grows_in(const GrainGround& ground, int fold, const RandomStream& random) {
  const bool named =
      ground.folds.empty() || std::find(ground.folds.begin(), ground.folds.end(), fold) != ground.folds.end();
  return named && (ground.fold_share >= 1 || random.uniform(static_cast<std::uint64_t>(fold)) < ground.fold_share);
}

double max_between(const Ramp<double>& ramp, double from, double to) {
  double max = std::max(ramp(from), ramp(to));
  for (const Ramp<double>::Stop& stop : ramp.stops) {
    if (stop.at > from && stop.at < to) max = std::max(max, stop.value);
  }
  return max;
}

bool in_sector(const GrainGround& ground, double around) {
  if (ground.around_from <= ground.around_to) return around >= ground.around_from && around <= ground.around_to;
  return around >= ground.around_from || around <= ground.around_to;
}

/// True if any place of [from, to] within 0..1 is in the sector.
bool sector_meets(const GrainGround& ground, double from, double to) {
  if (in_sector(ground, from) || in_sector(ground, to)) return true;
  return from <= ground.around_from && ground.around_from <= to;
}

bool faces_right(const GrainSketch& sketch, const GrainPlace& place) {
  using Facing = GrainGround::Facing;
  if (sketch.ground.facing == Facing::any) return true;
  const double outwards =
      (place.normal.x * place.position.x + place.normal.z * place.position.z) * (sketch.on_front ? 1 : -1);
  return sketch.ground.facing == Facing::from_axis ? outwards > 0 : outwards < 0;
}

}  // namespace

GrainPlace blend(const GrainPlace& a, double share_a, const GrainPlace& b, double share_b) {
  return {a.position * share_a + b.position * share_b, a.normal * share_a + b.normal * share_b,
          a.along * share_a + b.along * share_b, a.around * share_a + b.around * share_b,
          a.depth * share_a + b.depth * share_b};
}

double area_of(const GrainTarget& target) {
  const auto& [a, b, c] = target.corner;
  return 0.5 * glm::length(glm::cross(b.position - a.position, c.position - a.position));
}

std::vector<GrainTarget> grain_targets(std::span<const SweptGrid> grids, const GrainSketch& sketch,
                                       const RandomStream& random) {
  std::vector<GrainTarget> targets;
  for (const SweptGrid& grid : grids) {
    const std::vector<glm::dvec3> normals = summed_normals(grid);
    for (const glm::uvec3& t : grid.triangle) {
      if (!in_band(grid, t, sketch.ground)) continue;
      const std::array<double, 3> around = places_around(grid, t);
      if (!grows_in(sketch.ground, fold_of(grid, t, around), random)) continue;
      GrainTarget target;
      for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        target.corner[at] = {grid.position[t[k]], normals[t[k]], grid.along[t[k]], around[at], grid.depth[t[k]]};
      }
      target.uphill = uphill(grid, t);
      targets.push_back(target);
    }
  }
  return targets;
}

double density_at(const GrainSketch& sketch, const GrainPlace& place) {
  const GrainGround& ground = sketch.ground;
  const double around = place.around > 1 ? place.around - 1 : place.around;
  const bool inside = place.along >= ground.along_from && place.along <= ground.along_to && in_sector(ground, around) &&
                      place.depth >= ground.depth_from && place.depth <= ground.depth_to && faces_right(sketch, place);
  if (!inside) return 0;
  const double density = ground.density_along(place.along) * ground.density_around(around);
  return density < min_density ? 0 : std::min(density, 1.0);
}

double max_density(const GrainSketch& sketch, const GrainTarget& target) {
  const GrainGround& ground = sketch.ground;
  const auto& [a, b, c] = target.corner;
  const auto [shallow, deep] = std::minmax({a.depth, b.depth, c.depth});
  if (deep < ground.depth_from || shallow > ground.depth_to) return 0;
  const bool faces = faces_right(sketch, a) || faces_right(sketch, b) || faces_right(sketch, c);
  if (!faces) return 0;

  // Where the horizontal curve starts again the triangle has a part on either side.
  const auto [from, to] = std::minmax({a.around, b.around, c.around});
  const auto max_around = [&](double low, double high) {
    return sector_meets(ground, low, high) ? max_between(ground.density_around, low, high) : 0.0;
  };
  const double around = to <= 1 ? max_around(from, to) : std::max(max_around(from, 1), max_around(0, to - 1));
  const auto [low, high] = std::minmax({a.along, b.along, c.along});
  const double density = max_between(ground.density_along, low, high) * around;
  return density < min_density ? 0 : std::min(density, 1.0);
}

}  // namespace pomona
