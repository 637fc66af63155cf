#include "generator/scene/settle/drop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/mesh/box.h"

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

Box<double> turned_box(const DropPiece& piece, const glm::dquat& rotation) {
  Box<double> box;
  for (const ConvexPart& part : piece.parts)
    for (const glm::dvec3& corner : part) box.add(rotation * corner);
  return box;
}

/// The lowest height for the box's lower face at which it clears all others.
double clear_height(std::span<const Box<double>> others, const Box<double>& box, double lowest) {
  double height = lowest;
  for (const Box<double>& other : others) {
    const bool apart =
        other.high.x < box.low.x || other.low.x > box.high.x || other.high.z < box.low.z || other.low.z > box.high.z;
    if (!apart) height = std::max(height, other.high.y);
  }
  return height;
}

/// Where boxes of pieces have been put so far, and where the next one may go.
class Column {
 public:
  Column(const DropSpace& space, double air) : space_(space), air_(air) {}

  /// Moves the box to the lowest of a few places drawn from counter n on; returns how far.
  glm::dvec3 placed(const Box<double>& box, bool beside, const RandomStream& draw, std::uint64_t n) {
    constexpr std::uint64_t tries = 6;
    const glm::dvec3 middle = box.center(), size = box.size();
    const double radius = 0.5 * std::sqrt(size.x * size.x + size.z * size.z);
    const double inner = beside ? space_.radius + radius : 0;
    const double outer = beside ? space_.around : std::max(0.0, space_.radius - radius);
    glm::dvec3 best(0, std::numeric_limits<double>::infinity(), 0);
    for (std::uint64_t k = 0; k < tries; ++k) {
      // Square roots of uniform numbers fill a disc evenly.
      const double share = draw.uniform(n + 2 * k), angle = 2 * pi * draw.uniform(n + 2 * k + 1);
      const double r = std::sqrt(inner * inner + share * std::max(0.0, outer * outer - inner * inner));
      glm::dvec3 move(r * reproducible::cos(angle) - middle.x, 0, r * reproducible::sin(angle) - middle.z);
      move.y = clear_height(boxes_, box.moved(move), beside ? 0 : space_.height) + air_ - box.low.y;
      if (move.y < best.y) best = move;
    }
    boxes_.push_back(box.moved(best));
    return best;
  }

 private:
  DropSpace space_;
  double air_;  ///< between boxes, metres
  std::vector<Box<double>> boxes_;
};

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
  std::vector<Pose> poses(pieces.size());
  Column column(space, 0.01 * space.radius);
  for (const std::size_t i : dropping_order(pieces, draw)) {
    const DropPiece& piece = pieces[i];
    const std::uint64_t n = draws_per_piece * i;
    const bool any = piece.up == glm::dvec3(0);
    poses[i].rotation = any ? any_rotation(draw, n) : face_up(piece.up, draw, n);
    poses[i].translation = column.placed(turned_box(piece, poses[i].rotation), piece.beside, draw, n + 3);
  }
  return poses;
}

}  // namespace pomona
