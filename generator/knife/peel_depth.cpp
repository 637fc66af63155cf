#include "generator/knife/peel_depth.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/surface/shell_geometry.h"

namespace pomona {

namespace {

/// Share of the fruit's diagonal from which on a body that sticks out stays. Seeds and achenes in the skin are smaller,
/// and are peeled off with it.
constexpr double least_stem = 0.1;

/// The distance from a body's surface, metres, negative inside, as a "depth", and the direction in which it grows.
/// Outside, surface farther than `within` is not looked for, and the distance is then infinite.
PeelDepth::Place outside_of(const TriangleTree& body, const glm::dvec3& point, double within) {
  const bool inside = body.contains(point);
  const TriangleTree::Nearest near = inside ? body.nearest(point) : body.nearest(point, std::max(0.0, within));
  const glm::dvec3 way = inside ? near.point - point : point - near.point;
  const double distance = inside ? -near.distance : near.distance;
  return {distance, near.distance > 0 && std::isfinite(near.distance) ? way / near.distance : glm::dvec3(0)};
}

/// True if any triangle of the body begins outside the skin.
bool sticks_out(const TriangleTree& body, const TriangleTree& skin) {
  return std::any_of(body.triangles().begin(), body.triangles().end(),
                     [&](const TriangleTree::Corners& t) { return !skin.contains(t[0]); });
}

}  // namespace

PeelDepth::PeelDepth(const DiffusionSurfaces& surfaces, double thickness, double clearance)
    : skin_(surfaces), kept_(thickness + clearance) {
  if (!skin_.is_closed()) {
    throw Error(ExitStatus::bad_data, "a peeler needs a fruit whose skin is closed",
                "see docs/formats.md on hidden sides");
  }

  // Keep the bodies that are large and stick out. The main body itself, which is among the shells, is none of them.
  box_ = skin().box();
  const double size = glm::length(box_.high - box_.low);
  for (const Shell& shell : measured_shells(surfaces, find_shells(surfaces))) {
    if (!shell.closed || shell.volume <= 0 || glm::length(shell.bounds.size()) < least_stem * size) continue;
    const TriangleTree body(surfaces.position, shell.triangles);
    if (body.triangles() == skin().triangles() || !sticks_out(body, skin())) continue;
    stays_.push_back(body);
    box_.add(body.box());
  }
}

PeelDepth::Place PeelDepth::at(const glm::dvec3& point) const {
  // Below the main body's skin the depth is what the distance from it is outside, with the other sign.
  Place place = outside_of(skin(), point, INFINITY);
  place = {-place.depth, -place.deeper};

  // What stays makes its surroundings as deep as the clearance asks for; the deepest counts.
  for (const TriangleTree& body : stays_) {
    const Place beyond = outside_of(body, point, kept_ - place.depth);
    if (kept_ - beyond.depth > place.depth) place = {kept_ - beyond.depth, -beyond.deeper};
  }
  return place;
}

double PeelDepth::from_what_stays(const glm::dvec3& point, double within) const {
  double least = within;
  for (const TriangleTree& body : stays_) least = std::min(least, outside_of(body, point, least).depth);
  return least;
}

double PeelDepth::below_skin(const glm::dvec3& point) const { return -outside_of(skin(), point, INFINITY).depth; }

}  // namespace pomona
