#include "generator/compose/instance_pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/surface/sweep/grain_pose.h"

namespace pomona {

namespace {

using Heading = PlaceSketch::Heading;

constexpr std::uint64_t draws_per_instance = 4;

glm::dvec3 heading_of(const PlaceSketch& place, const PlaceSeat& seat) {
  switch (place.heading) {
    case Heading::out:
      break;
    case Heading::in:
      return -seat.normal;
    case Heading::along:
      return seat.uphill;
    case Heading::up:
      return {0, 1, 0};
    case Heading::down:
      return {0, -1, 0};
    case Heading::stalk:
      return glm::normalize(seat.stalk_root - seat.center);
  }
  return seat.normal;
}

glm::dvec3 foot_of(PlaceSketch::Foot foot, const Box<double>& own) {
  switch (foot) {
    case PlaceSketch::Foot::bottom:
      return {0, own.low.y, 0};
    case PlaceSketch::Foot::middle:
      return {0, 0.5 * (own.low.y + own.high.y), 0};
    case PlaceSketch::Foot::top:
      break;
  }
  return {0, own.high.y, 0};
}

}  // namespace

InstancePose instance_pose(const PlaceSketch& place, const PlaceSeat& seat, const Box<double>& own, std::size_t number,
                           const RandomStream& draws) {
  const auto draw = [&](std::uint64_t k) { return 2 * draws.uniform(draws_per_instance * number + k) - 1; };

  // The top leans uphill by the tilt; then the instance turns about its own axis.
  const glm::dvec3 heading = heading_of(place, seat);
  const glm::dvec3 uphill = across(heading, {seat.uphill, seat.normal, {0, 1, 0}, {0, 0, 1}});
  const double tilt = place.tilt + place.tilt_jitter * draw(0), turn = place.turn + place.turn_jitter * draw(1);
  const double cos_tilt = reproducible::cos(tilt), sin_tilt = reproducible::sin(tilt);
  const glm::dvec3 top = heading * cos_tilt + uphill * sin_tilt, front = uphill * cos_tilt - heading * sin_tilt;
  const glm::dvec3 side = glm::cross(top, front);
  const double cos_turn = reproducible::cos(turn), sin_turn = reproducible::sin(turn);

  InstancePose pose;
  pose.turn = glm::dmat3(side * cos_turn + front * sin_turn, top, front * cos_turn - side * sin_turn);
  pose.scale = place.size(seat.along) * std::max(0.1, 1 + place.size_jitter * draw(2));
  pose.foot = foot_of(place.foot, own);
  pose.at = seat.center - seat.normal * place.sink;
  return pose;
}

}  // namespace pomona
