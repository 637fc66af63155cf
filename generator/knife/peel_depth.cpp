#include "generator/knife/peel_depth.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/mesh/signed_volume.h"
#include "generator/surface/outer_bodies.h"

namespace pomona {

namespace {

/// The distance from a body's surface, metres, negative inside, as a "depth", and the direction in which it grows.
/// Outside, a surface farther than `within` counts as infinitely far.
PeelDepth::Place outside_of(const TriangleTree& body, const glm::dvec3& point, double within) {
  const bool inside = body.contains(point);
  const TriangleTree::Nearest near = inside ? body.nearest(point) : body.nearest(point, std::max(0.0, within));
  const glm::dvec3 way = inside ? near.point - point : point - near.point;
  const double distance = inside ? -near.distance : near.distance;
  return {distance, near.distance > 0 && std::isfinite(near.distance) ? way / near.distance : glm::dvec3(0)};
}

double volume_of(const TriangleTree& body) {
  return std::fabs(signed_volume(body.triangles(), [](const TriangleTree::Corners& t) { return t; }));
}

}  // namespace

PeelDepth::PeelDepth(const DiffusionSurfaces& surfaces, double thickness, double clearance)
    : skin_(surfaces), kept_(thickness + clearance) {
  if (!skin_.is_closed()) {
    throw Error(ExitStatus::bad_data, "a peeler needs a fruit whose skin is closed",
                "see docs/reference/formats.md on hidden sides");
  }

  box_ = skin().box();
  stays_ = outer_bodies(surfaces, skin()).body;
  // One of many berries or leaves would lose its skin, and the depth below all others would be measured for nothing.
  double beside = 0;
  for (const TriangleTree& body : stays_) beside += volume_of(body);
  if (beside > volume_of(skin()))
    throw Error(ExitStatus::usage,
                "a peeler follows one skin, and most of this fruit lies in " + std::to_string(stays_.size()) +
                    " bodies beside its largest",
                "peel what it is made of by itself, or cut it with another knife");
  for (const TriangleTree& body : stays_) box_.add(body.box());
}

PeelDepth::Place PeelDepth::at(const glm::dvec3& point) const {
  // Below the main body's skin the depth is the distance, outside the negative distance.
  Place place = outside_of(skin(), point, INFINITY);
  place = {-place.depth, -place.deeper};

  // Kept bodies make their surroundings as deep as the clearance requires; the deepest counts.
  for (const TriangleTree& body : stays_) {
    const Place beyond = outside_of(body, point, kept_ - place.depth);
    if (kept_ - beyond.depth > place.depth) place = {kept_ - beyond.depth, -beyond.deeper};
  }
  return place;
}

double PeelDepth::from_what_stays(const glm::dvec3& point, double within) const {
  double min = within;
  for (const TriangleTree& body : stays_) min = std::min(min, outside_of(body, point, min).depth);
  return min;
}

double PeelDepth::below_skin(const glm::dvec3& point) const { return -outside_of(skin(), point, INFINITY).depth; }

}  // namespace pomona
