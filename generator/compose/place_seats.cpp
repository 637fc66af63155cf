#include "generator/compose/place_seats.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "generator/compose/cluster_seats.h"
#include "generator/surface/sweep/body_map.h"
#include "generator/surface/sweep/grid_place.h"
#include "generator/surface/sweep/law_seats.h"
#include "generator/surface/sweep/surface_grids.h"

namespace pomona {

namespace {

const LawSketch& law_of(const Template& fruit, const PlaceSketch& place) {
  return fruit.laws.at(static_cast<std::size_t>(place.law));
}

bool is_cluster(const LawSketch& law) { return law.kind == LawSketch::Kind::cluster; }

double room_of(const Template& fruit, const PlaceSketch& place) {
  const LawSketch& law = law_of(fruit, place);
  if (is_cluster(law)) return cluster_room(law);
  return law_room(law, fruit.surfaces.at(static_cast<std::size_t>(*place.surface)).vertical);
}

double own_triangles(const Template& fruit) {
  double sum = 0;
  for (const SurfaceSketch& surface : fruit.surfaces) {
    const std::size_t grids = surface.type == SurfaceType::in_fold ? surface.horizontal.size() : 1;
    sum += 2.0 * surface.around * surface.along * static_cast<double>(std::max<std::size_t>(1, grids));
  }
  return sum;
}

/// Seats in space, and where their stalks leave, both laid along the fruit's axis.
std::vector<PlaceSeat> seats_in_space(const Template& variant, const PlaceSketch& place, VariantKey key) {
  const LawSketch& law = law_of(variant, place);
  const BodyMap body(variant);
  const double low = law.envelope.points.front().y, high = law.envelope.points.back().y;
  std::vector<PlaceSeat> seats;
  for (const glm::dvec3& p : cluster_seats(law, key)) {
    PlaceSeat seat;
    seat.center = body(p);
    seat.along = high > low ? (p.y - low) / (high - low) : 0.5;
    if (place.stalk) seat.stalk_root = body({0, p.y + place.stalk->rise, 0});
    seat.normal = away_from_axis(p);
    seat.uphill = {0, 1, 0};
    seats.push_back(seat);
  }
  return seats;
}

std::vector<PlaceSeat> seats_on_surface(const Template& variant, const PlaceSketch& place,
                                        const SweepOptions& options) {
  const SurfaceSketch& surface = variant.surfaces.at(static_cast<std::size_t>(*place.surface));
  const LawSketch& law = law_of(variant, place);
  const std::vector<SweptGrid> grids = swept_grids(variant, surface, for_placing(options));
  std::vector<PlaceSeat> seats;
  if (grids.empty()) return seats;
  const GridPlaces places(grids.front());
  const BodyMap body(variant);
  for (const LawSeat& at : law_seats(law, surface.vertical, law_draws(law, options.key))) {
    const GridPoint point = places.at(at.along, at.azimuth);
    PlaceSeat seat;
    seat.center = point.position;
    seat.normal = place.on_front ? point.normal : -point.normal;
    seat.uphill = unit_across(point.uphill, seat.normal);
    seat.along = at.along;
    const double height = point_at(surface.vertical, at.along).y;
    if (place.stalk) seat.stalk_root = body({0, height + place.stalk->rise, 0});
    seats.push_back(seat);
  }
  return seats;
}

}  // namespace

double instance_room(const Template& fruit) {
  double sum = 0;
  for (const PlaceSketch& place : fruit.places) sum += room_of(fruit, place) * (1 + instance_room(*place.placed));
  return sum;
}

double instance_triangles(const Template& fruit) {
  double sum = 0;
  for (const PlaceSketch& place : fruit.places) {
    const double own = own_triangles(*place.placed) + instance_triangles(*place.placed);
    sum += room_of(fruit, place) * own * place.detail * place.detail;
  }
  return sum;
}

std::vector<PlaceSeat> place_seats(const Template& variant, const PlaceSketch& place, const SweepOptions& options) {
  if (is_cluster(law_of(variant, place))) return seats_in_space(variant, place, options.key);
  return seats_on_surface(variant, place, options);
}

}  // namespace pomona
