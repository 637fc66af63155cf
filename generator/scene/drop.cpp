#include "generator/scene/drop.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

/// Draws of one piece: a block of counters to itself.
constexpr std::uint64_t draws_per_piece = 16;

/// Uniform over all rotations [Shoemake 1992].
glm::dquat any_rotation(const RandomStream& draw, std::uint64_t n) {
  const double u = draw.uniform(n), a = 2 * pi * draw.uniform(n + 1), b = 2 * pi * draw.uniform(n + 2);
  const double low = std::sqrt(1 - u), high = std::sqrt(u);
  return {high * reproducible::cos(b), low * reproducible::sin(a), low * reproducible::cos(a),
          high * reproducible::sin(b)};
}

glm::dquat about(const glm::dvec3& axis, double angle) {
  return {reproducible::cos(0.5 * angle), axis * reproducible::sin(0.5 * angle)};
}

/// The shortest turn that takes one unit direction to another.
glm::dquat turn(const glm::dvec3& from, const glm::dvec3& to) {
  const double w = 1 + glm::dot(from, to);
  if (w > 1e-9) return glm::normalize(glm::dquat(w, glm::cross(from, to)));
  const glm::dvec3 side = std::fabs(from.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return {0, glm::normalize(glm::cross(from, side))};
}

/// `up` towards the sky, up to a slight tilt, and any turn about it.
glm::dquat face_up(const glm::dvec3& up, const RandomStream& draw, std::uint64_t n) {
  constexpr double most_tilt = 0.35;
  const double tilt = most_tilt * draw.uniform(n), heading = 2 * pi * draw.uniform(n + 1);
  const glm::dvec3 target(reproducible::sin(tilt) * reproducible::cos(heading), reproducible::cos(tilt),
                          reproducible::sin(tilt) * reproducible::sin(heading));
  return about(target, 2 * pi * draw.uniform(n + 2)) * turn(glm::normalize(up), target);
}

struct Ball {
  glm::dvec3 center{0};
  double radius = 0;
};

/// The lowest height at which a ball over (x, z) clears all others.
double clear_height(std::span<const Ball> others, double x, double z, double radius, double lowest) {
  double height = lowest;
  for (const Ball& other : others) {
    const double dx = other.center.x - x, dz = other.center.z - z, reach = 1.02 * (other.radius + radius);
    const double rest = reach * reach - dx * dx - dz * dz;
    if (rest > 0) height = std::max(height, other.center.y + std::sqrt(rest));
  }
  return height;
}

/// Pieces by order, shuffled within it: a Fisher-Yates shuffle, then a stable sort.
std::vector<std::size_t> dropping_order(std::span<const DropPiece> pieces, const RandomStream& draw) {
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::uint64_t shuffle = draws_per_piece * pieces.size();
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[draw.below(shuffle + i, i)]);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return pieces[a].order < pieces[b].order; });
  return order;
}

}  // namespace

std::vector<Pose> drop_poses(std::span<const DropPiece> pieces, const DropSpace& space, const RandomStream& draw) {
  constexpr double golden_angle = 2.399963229728653;
  std::vector<Pose> poses(pieces.size());
  std::vector<Ball> balls;
  const double first_angle = 2 * pi * draw.uniform(draws_per_piece * pieces.size());
  int number = 0;
  for (const std::size_t i : dropping_order(pieces, draw)) {
    const DropPiece& piece = pieces[i];
    const std::uint64_t n = draws_per_piece * i;
    const bool any = piece.up == glm::dvec3(0);
    poses[i].rotation = any ? any_rotation(draw, n) : face_up(piece.up, draw, n);

    // Golden angles go around evenly; square roots of uniform numbers fill the disc evenly.
    const double angle = first_angle + golden_angle * number++;
    const double inner = piece.beside ? space.radius + piece.radius : 0;
    const double outer = piece.beside ? space.around : std::max(0.0, space.radius - piece.radius);
    const double share = draw.uniform(n + 3);
    const double radius = std::sqrt(inner * inner + share * std::max(0.0, outer * outer - inner * inner));
    const double x = radius * reproducible::cos(angle), z = radius * reproducible::sin(angle);
    const double floor = piece.beside ? 0 : space.height;
    const double y = clear_height(balls, x, z, piece.radius, floor + 1.05 * piece.radius);
    balls.push_back({{x, y, z}, piece.radius});
    poses[i].translation = balls.back().center - poses[i].rotation * piece.center;
  }
  return poses;
}

}  // namespace pomona
