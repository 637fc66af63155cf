#include "generator/surface/sweep/grain_pose.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

using Heading = GrainStance::Heading;
using Flat = GrainStance::Flat;

/// Indices of the random numbers for looks.
enum Draw : std::uint64_t { tilt_draw, length_draw, width_draw, look_draw };

const glm::dvec3 upwards(0, 1, 0);

glm::dvec3 turned(const glm::dvec3& from, const glm::dvec3& towards, double angle) {
  return from * reproducible::cos(angle) + towards * reproducible::sin(angle);
}

/// The direction away from the axis; +X on the axis.
glm::dvec3 outwards(const glm::dvec3& center) {
  const double radius = std::sqrt(center.x * center.x + center.z * center.z);
  return radius > 0 ? glm::dvec3(center.x / radius, 0, center.z / radius) : glm::dvec3(1, 0, 0);
}

glm::dvec3 heading_of(const GrainStance& stance, const GrainSeat& seat) {
  switch (stance.heading) {
    case Heading::towards_axis:
      return -outwards(seat.center);
    case Heading::from_axis:
      return outwards(seat.center);
    case Heading::up:
      return upwards;
    case Heading::down:
      return -upwards;
    case Heading::along:
      break;
  }
  return seat.tangent;
}

/// The direction of the flat side, across the heading.
glm::dvec3 facing_of(const GrainStance& stance, const GrainSeat& seat, const glm::dvec3& heading) {
  if (stance.heading == Heading::along && stance.flat == Flat::surface) return seat.normal;
  const glm::dvec3 out = outwards(seat.center), around = glm::cross(upwards, out);
  switch (stance.flat) {
    case Flat::around:
      return across(heading, {around, upwards, out});
    case Flat::up:
      return across(heading, {upwards, around, out});
    case Flat::surface:
      break;
  }
  return across(heading, {seat.normal, around, upwards});
}

/// Columns whose products add up to the ellipsoid's matrix.
glm::dmat3 spread(const GrainPose& pose) {
  const auto square = [](const glm::dvec3& a) { return glm::dmat3(a * a.x, a * a.y, a * a.z); };
  return square(pose.thickness) + square(pose.length) + square(pose.width);
}

}  // namespace

GrainDraws grain_draws(VariantKey key, const std::string& name) {
  return {RandomStream(key, "grains/" + name), RandomStream(key, "grains/" + name + "/looks"),
          RandomStream(key, "grains/" + name + "/folds")};
}

double min_radius(const GrainPose& pose) {
  return std::min({glm::length(pose.thickness), glm::length(pose.length), glm::length(pose.width)});
}

double max_radius(const GrainPose& pose) {
  return std::max({glm::length(pose.thickness), glm::length(pose.length), glm::length(pose.width)});
}

glm::dvec3 across(const glm::dvec3& axis, std::initializer_list<glm::dvec3> wishes) {
  for (const glm::dvec3& wish : wishes) {
    const glm::dvec3 side = wish - glm::dot(wish, axis) * axis;
    const double size = glm::length(side);
    if (size > 0.1) return side / size;
  }
  const glm::dvec3 other = std::fabs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : upwards;
  return glm::normalize(glm::cross(axis, other));
}

GrainPose scaled(GrainPose pose, double factor) {
  pose.thickness *= factor;
  pose.length *= factor;
  pose.width *= factor;
  return pose;
}

int drawn_look(const GrainSketch& sketch, std::uint64_t number, const GrainDraws& draws) {
  if (sketch.looks.empty()) return GrainPose::own_look;
  const double draw = draws.looks.uniform(draws_per_candidate * number + look_draw);
  double before = 0;
  for (std::size_t i = 0; i < sketch.looks.size(); ++i) {
    before += sketch.looks[i].share;
    if (draw < before) return static_cast<int>(i);
  }
  return GrainPose::own_look;
}

GrainPose grain_pose(const GrainSketch& sketch, const GrainSeat& seat, const GrainDraws& draws) {
  const std::uint64_t first = draws_per_candidate * seat.number;
  const auto place_draw = [&](std::uint64_t k) { return 2 * draws.places.uniform(first + k) - 1; };
  const auto draw = [&](Draw k) { return 2 * draws.looks.uniform(first + k) - 1; };
  const GrainForm& form = sketch.form;
  const GrainStance& stance = sketch.stance;

  // Turns about the flat side's normal, then lifts towards it.
  const glm::dvec3 heading = heading_of(stance, seat), facing = facing_of(stance, seat, heading);
  const glm::dvec3 sideways = glm::cross(facing, heading);
  const glm::dvec3 flat = turned(heading, sideways, stance.angle + stance.angle_jitter * place_draw(3));
  const double tilt = stance.tilt + stance.tilt_jitter * draw(tilt_draw);
  const glm::dvec3 tip = turned(flat, facing, tilt);
  const glm::dvec3 up = turned(facing, -flat, tilt);

  GrainPose pose;
  pose.look = drawn_look(sketch, seat.number, draws);
  double scale = 0.5 * std::max(0.1, 1 + form.size_jitter * place_draw(4)) * form.size(seat.along);
  if (pose.look >= 0) scale *= sketch.looks[static_cast<std::size_t>(pose.look)].scale;
  pose.thickness = up * (scale * form.thickness);
  pose.length = tip * (scale * form.length * (1 + form.length_jitter * draw(length_draw)));
  pose.width = glm::cross(up, tip) * (scale * form.width * (1 + form.width_jitter * draw(width_draw)));
  return pose;
}

bool ellipsoids_overlap(const glm::dvec3& center, const GrainPose& pose, const glm::dvec3& other_center,
                        const GrainPose& other) {
  // Their inner balls overlap.
  const glm::dvec3 away = other_center - center;
  const double inner = 0.999 * (min_radius(pose) + min_radius(other));
  if (glm::dot(away, away) < inner * inner) return true;

  // They are apart if the contact function, concave in t, reaches 1 anywhere.
  const glm::dmat3 mine = spread(pose), theirs = spread(other);
  const auto contact = [&](double t) {
    const glm::dmat3 blend = mine * (1 - t) + theirs * t;
    return t * (1 - t) * glm::dot(away, glm::inverse(blend) * away);
  };
  double low = 0, high = 1, at_low = 0, at_high = 0;
  for (int step = 0; step < 24; ++step) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    const double at_a = contact(a), at_b = contact(b);
    if (at_a >= 1 || at_b >= 1) return false;
    // Its maximum lies beyond a or before b; a concave function has at least a third of the rise at a third of the way.
    if (std::max(3 * at_a - 2 * at_low, 3 * at_b - 2 * at_high) < 0.999) return true;
    if (at_a < at_b) {
      low = a, at_low = at_a;
    } else {
      high = b, at_high = at_b;
    }
  }
  return true;
}

}  // namespace pomona
