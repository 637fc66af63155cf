#include "generator/scene/settle/drop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

/// Uniform over all rotations [Shoemake 1992].
glm::dquat any_rotation(const RandomStream& draw, std::uint64_t n) {
  const double u = draw.uniform(n), a = 2 * pi * draw.uniform(n + 1), b = 2 * pi * draw.uniform(n + 2);
  const double low = std::sqrt(1 - u), high = std::sqrt(u);
  return {high * reproducible::cos(b), low * reproducible::sin(a), low * reproducible::cos(a),
          high * reproducible::sin(b)};
}

/// A random rotation about `up`, and then one that turns `up` upwards, with a slight tilt.
glm::dquat face_up(const glm::dvec3& up, const RandomStream& draw, std::uint64_t n) {
  constexpr double max_tilt = 0.35;
  const double tilt = max_tilt * draw.uniform(n), heading = 2 * pi * draw.uniform(n + 1);
  const glm::dvec3 target(reproducible::sin(tilt) * reproducible::cos(heading), reproducible::cos(tilt),
                          reproducible::sin(tilt) * reproducible::sin(heading));
  return turn_about(target, 2 * pi * draw.uniform(n + 2)) * turn_between(glm::normalize(up), target);
}

/// A place to drop a piece.
struct DropPlace {
  glm::vec2 at{0};                                           ///< x and z, metres
  double highest = std::numeric_limits<double>::infinity();  ///< the piece's lowest point starts at most here, metres
};

/// The steepest slope at which pieces lie on each other.
constexpr double max_slope = 0.7;

DropPlace spot_in(const DropRing& ring, double share, double turn) {
  // Square roots of uniform numbers fill a ring evenly.
  const double angle = 2 * pi * turn;
  const double radius =
      std::sqrt(ring.inner * ring.inner + share * std::max(0.0, ring.outer * ring.outer - ring.inner * ring.inner));
  DropPlace spot;
  spot.at = {static_cast<float>(ring.middle.x + radius * reproducible::cos(angle)),
             static_cast<float>(ring.middle.y + radius * reproducible::sin(angle))};
  const double out = ring.middle == glm::dvec2(0) ? radius : static_cast<double>(glm::length(spot.at));
  if (ring.rim_radius > 0) spot.highest = ring.rim_height + max_slope * (ring.rim_radius - out);
  return spot;
}

DropPlace spot_in(const DropCells& cells, double share, double) {
  const auto last = static_cast<double>(cells.size() - 1);
  const MeshDish::Place& place =
      cells[static_cast<std::size_t>(std::min(last, share * static_cast<double>(cells.size())))];
  return {glm::vec2(place.at), place.level + max_slope * place.inset};
}

}  // namespace

glm::dquat turn_about(const glm::dvec3& axis, double radians) {
  return {reproducible::cos(0.5 * radians), axis * reproducible::sin(0.5 * radians)};
}

glm::dquat turn_between(const glm::dvec3& from, const glm::dvec3& to) {
  const double w = 1 + glm::dot(from, to);
  if (w > 1e-9) return glm::normalize(glm::dquat(w, glm::cross(from, to)));
  const glm::dvec3 side = std::fabs(from.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return {0, glm::normalize(glm::cross(from, side))};
}

std::vector<std::size_t> dropping_order(std::span<const int> order, const RandomStream& draw) {
  // A Fisher-Yates shuffle, then a stable sort.
  constexpr std::uint64_t behind_all_drops = std::uint64_t{1} << 40;
  std::vector<std::size_t> pieces(order.size());
  std::iota(pieces.begin(), pieces.end(), std::size_t{0});
  for (std::size_t i = pieces.size(); i > 1; --i) std::swap(pieces[i - 1], pieces[draw.below(behind_all_drops + i, i)]);
  std::stable_sort(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) { return order[a] < order[b]; });
  return pieces;
}

glm::dquat random_rotation(const glm::dvec3& up, const RandomStream& draw, std::uint64_t n) {
  return up == glm::dvec3(0) ? any_rotation(draw, n) : face_up(up, draw, n);
}

std::optional<glm::dvec3> random_place(const RigidBody& turned, const HeightMap& heap, const DropArea& area,
                                       const RandomStream& draw, std::uint64_t n) {
  constexpr std::uint64_t usual = 12, max_tries = 24;  // more only while none is low enough
  if (const auto* cells = std::get_if<DropCells>(&area); cells && cells->empty()) return {};
  std::optional<glm::dvec3> best;
  for (std::uint64_t k = 0; k < max_tries && (k < usual || !best); ++k) {
    const double share = draw.uniform(n + 2 * k), turn = draw.uniform(n + 2 * k + 1);
    const DropPlace spot = std::visit([&](const auto& each) { return spot_in(each, share, turn); }, area);
    const double height = heap.resting_height(turned, spot.at.x, spot.at.y);
    const double lowest = height + (static_cast<double>(turned.box.low.y) - turned.center.y);
    if (lowest > spot.highest) continue;
    if (!best || height < best->y) best = glm::dvec3(spot.at.x, height, spot.at.y);
  }
  return best;
}

}  // namespace pomona
