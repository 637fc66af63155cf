#include "generator/surface/sweep/spots.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/surface/sweep/dart_throwing.h"
#include "generator/surface/sweep/grid_place.h"
#include "generator/surface/sweep/law_seats.h"
#include "generator/surface/sweep/section_loop.h"
#include "generator/surface/sweep/surface_grids.h"

namespace pomona {

namespace {

constexpr double max_spots = 20'000;  // limit of spots of one kind
constexpr double max_layers = 2'000;  // limit of spots of all kinds level with a vertex, on average

// The smallest softness of relief, because a hard rim would be a cliff.
constexpr double min_slope = 0.4;

const char* name_of(SideOf side) { return side == SideOf::front ? "front" : "back"; }
const Side& side_of(const SurfaceSketch& sketch, SideOf side) {
  return side == SideOf::front ? sketch.front : sketch.back;
}

/// Scattered spots are placed like grains that lie flat on the front.
GrainSketch as_darts(const SpotSketch& sketch) {
  GrainSketch darts;
  darts.spacing.poisson_radius = sketch.spacing;
  darts.ground.along_from = sketch.along_from;
  darts.ground.along_to = sketch.along_to;
  return darts;
}

/// The outline has two to five waves around it; shorter ones are lower.
std::array<glm::dvec2, 4> drawn_waves(double raggedness, const RandomStream& random, std::uint64_t first_draw) {
  constexpr std::array<double, 4> share{0.4, 0.3, 0.18, 0.12};
  std::array<glm::dvec2, 4> waves;
  for (std::size_t k = 0; k < waves.size(); ++k) {
    waves[k] = raggedness * share[k] * direction_of(2 * pi * random.uniform(first_draw + k));
  }
  return waves;
}

/// Uses draws 3 to 7 of the dart's candidate.
Spot spot_at(const Dart& dart, const SpotSketch& sketch, const RandomStream& random) {
  const std::uint64_t draw = draws_per_candidate * dart.number + 3;
  Spot spot;
  spot.center = dart.center;
  spot.normal = dart.normal;
  spot.tangent = dart.tangent;
  spot.radius = 0.5 * (sketch.size_min + (sketch.size_max - sketch.size_min) * random.uniform(draw));
  spot.stretch = sketch.stretch;
  spot.softness = sketch.softness;
  spot.strength = sketch.strength;
  spot.waves = drawn_waves(sketch.raggedness, random, draw + 1);
  spot.color = sketch.color;
  spot.relief = sketch.relief;
  return spot;
}

std::vector<Dart> seated_spots(const Template& fruit, const SurfaceSketch& surface, SideOf side,
                               const SpotSketch& sketch, const SweptGrid& grid, const GrainDraws& draws,
                               VariantKey key) {
  const LawSketch& law = fruit.laws.at(static_cast<std::size_t>(*sketch.law));
  if (law_room(law, surface.vertical) > max_spots) {
    refuse(fruit, surface, std::string(name_of(side)) + " has more than 20 000 spots", "make their spacing larger");
  }
  std::vector<Dart> darts = seated_darts(law, surface.vertical, grid, as_darts(sketch), draws, key);
  if (sketch.count > 0 && darts.size() > static_cast<std::size_t>(sketch.count))
    darts.resize(static_cast<std::size_t>(sketch.count));
  return darts;
}

std::vector<Dart> darts_of(const Template& fruit, const SurfaceSketch& surface, SideOf side, const SpotSketch& sketch,
                           std::span<const SweptGrid> grids, const RandomStream& random, Threads threads,
                           VariantKey key) {
  if (grids.empty()) return {};
  if (sketch.place) {
    const GridPoint point = point_at(grids.front(), sketch.place->along, sketch.place->azimuth);
    Dart dart;
    dart.center = point.position;
    dart.normal = point.normal;
    dart.tangent = point.uphill;
    return {dart};
  }
  const GrainSketch thrown = as_darts(sketch);
  if (sketch.law) return seated_spots(fruit, surface, side, sketch, grids.front(), {random, random, random}, key);
  const std::vector<GrainTarget> targets = grain_targets(grids, thrown, random);
  if (room_for_grains(targets, thrown) > max_spots) {
    refuse(fruit, surface, std::string(name_of(side)) + " has more than 20 000 spots", "make their spacing larger");
  }
  std::vector<Dart> darts = thrown_darts(targets, thrown, {random, random, random}, threads);
  if (sketch.count > 0 && darts.size() > static_cast<std::size_t>(sketch.count)) {
    darts.resize(static_cast<std::size_t>(sketch.count));
  }
  return darts;
}

/// Vertices by height, so that a spot need not test all of them.
class ByHeight {
 public:
  explicit ByHeight(const std::vector<glm::dvec3>& position) : position_(position), order_(position.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return position[a].y != position[b].y ? position[a].y < position[b].y : a < b;
    });
  }

  std::span<const std::size_t> between(double low, double high) const {
    const auto lower = [&](std::size_t v, double y) { return position_[v].y < y; };
    const auto upper = [&](double y, std::size_t v) { return y < position_[v].y; };
    const auto begin = std::lower_bound(order_.begin(), order_.end(), low, lower);
    return {begin, std::upper_bound(begin, order_.end(), high, upper)};
  }

 private:
  const std::vector<glm::dvec3>& position_;
  std::vector<std::size_t> order_;
};

/// The mean number of spots level with a vertex: the cost of painting each vertex.
double layers(std::span<const SweptGrid> grids, const std::vector<Spot>& spots) {
  double low = 1e300, high = -1e300;
  for (const SweptGrid& grid : grids) {
    for (const glm::dvec3& p : grid.position) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  }
  double sum = 0;
  for (const Spot& spot : spots) sum += 2 * reach_of(spot) < high - low ? 2 * reach_of(spot) / (high - low) : 1;
  return sum;
}

/// Seen from behind, an outline runs the other way around.
Spot seen_from_air(Spot spot, SideOf side) {
  spot.softness = std::max(spot.softness, min_slope);
  spot.strength = 1;
  if (side == SideOf::front) return spot;
  spot.normal = -spot.normal;
  for (glm::dvec2& wave : spot.waves) wave.y = -wave.y;
  return spot;
}

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g mm", metres * 1000);
  return text;
}

/// The longest edge, diagonals included, where the spots' centres may lie: a disc as wide as that holds a vertex.
double widest_cell(std::span<const SweptGrid> grids, const SpotSketch& sketch) {
  const double from = sketch.place ? sketch.place->along : sketch.along_from;
  const double to = sketch.place ? sketch.place->along : sketch.along_to;
  double widest = 0;
  for (const SweptGrid& grid : grids) {
    for (const glm::uvec3& t : grid.triangle) {
      const auto [min, max] = std::minmax({grid.along[t.x], grid.along[t.y], grid.along[t.z]});
      if (max < from || min > to) continue;
      for (int k = 0; k < 3; ++k) {
        widest = std::max(widest, glm::distance(grid.position[t[k]], grid.position[t[(k + 1) % 3]]));
      }
    }
  }
  return widest;
}

}  // namespace

std::vector<Spot> placed_spots(const Template& fruit, const SurfaceSketch& sketch, SideOf side,
                               std::span<const SweptGrid> grids, const SweepOptions& options) {
  std::vector<Spot> spots;
  const std::vector<SpotSketch>& kinds = side_of(sketch, side).spots;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const RandomStream random(options.key, "spots/" + sketch.name + "/" + name_of(side) + "/" + std::to_string(kind));
    for (const Dart& dart : darts_of(fruit, sketch, side, kinds[kind], grids, random, options.threads, options.key)) {
      spots.push_back(spot_at(dart, kinds[kind], random));
    }
  }
  if (layers(grids, spots) > max_layers) {
    refuse(fruit, sketch, std::string(name_of(side)) + " has more than 2 000 spots over one another",
           "make them smaller, or their spacing larger");
  }
  return spots;
}

std::vector<Color> with_spots(const SweptGrid& grid, std::vector<Color> ground, std::span<const Spot> spots) {
  const ByHeight by_height(grid.position);
  const std::vector<glm::dvec3> normals = unit_normals(grid);
  for (const Spot& spot : spots) {
    for (const std::size_t v : by_height.between(spot.center.y - reach_of(spot), spot.center.y + reach_of(spot))) {
      ground[v] = blended(ground[v], spot.color, cover_of(spot, grid.position[v], normals[v]));
    }
  }
  return ground;
}

std::vector<Spot> raised_spots(std::span<const Spot> spots, SideOf side) {
  std::vector<Spot> raised;
  for (const Spot& spot : spots)
    if (spot.relief != 0) raised.push_back(seen_from_air(spot, side));
  return raised;
}

std::vector<std::string> spot_warnings(const Template& fruit, const SweepOptions& options) {
  std::vector<std::string> warnings;
  for (const SurfaceSketch& sketch : fruit.surfaces) {
    if (sketch.front.spots.empty() && sketch.back.spots.empty()) continue;
    const std::vector<SweptGrid> grids = swept_grids(fruit, sketch, options);
    for (const SideOf side : {SideOf::front, SideOf::back}) {
      for (const SpotSketch& spots : side_of(sketch, side).spots) {
        const double cell = widest_cell(grids, spots), width = spots.size_min * std::min(1.0, spots.stretch);
        if (width >= cell) continue;
        warnings.push_back("surface \"" + sketch.name + "\": " + name_of(side) + " has spots " + millimetres(width) +
                           " wide, but up to " + millimetres(cell) +
                           " between vertices: some will be lost; raise \"around\" and \"along\"");
      }
    }
  }
  return warnings;
}

}  // namespace pomona
