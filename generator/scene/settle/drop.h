// From where, and in which rotation, pieces are dropped.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "generator/base/random.h"
#include "generator/scene/settle/height_map.h"
#include "generator/scene/settle/mesh_dish.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

/// Number of random numbers reserved for one drop of one piece.
constexpr std::uint64_t draws_per_drop = 64;

/// The pieces in the order in which they fall: sorted by `order`, in random order where that is equal.
std::vector<std::size_t> dropping_order(std::span<const int> order, const RandomStream& draw);

/// The smallest rotation that turns one direction of length 1 into another.
glm::dquat turn_between(const glm::dvec3& from, const glm::dvec3& to);

/// The rotation by an angle about an axis of length 1.
glm::dquat turn_about(const glm::dvec3& axis, double radians);

/// A random rotation, uniform over all. Where `up` is not zero: a random rotation that turns `up` upwards, with a
/// slight tilt.
/// \param n number of the first random number that is used.
glm::dquat random_rotation(const glm::dvec3& up, const RandomStream& draw, std::uint64_t n);

/// A ring on the ground into which pieces are dropped.
struct DropRing {
  double inner = 0;       ///< smallest distance of a piece's centre from the middle, metres
  double outer = 0;       ///< largest distance of a piece's centre from the middle, metres
  double rim_radius = 0;  ///< no piece starts above the cone that rises from this circle inwards, metres; 0 = no cone
  double rim_height = 0;  ///< height of that circle, metres; the cone's slope is the steepest at which pieces lie
  glm::dvec2 middle{0};   ///< middle of the ring, x and z; the cone always stands about the y axis
};

/// Cells of a dish into which pieces are dropped. No piece starts above the slope that rises inwards from their border.
using DropCells = std::vector<MeshDish::Place>;

using DropArea = std::variant<DropRing, DropCells>;

/// A place for the centre of a body that is already turned: the lowest of a few random places in the area. Nothing if
/// all are too high.
/// \param n number of the first random number that is used.
std::optional<glm::dvec3> random_place(const RigidBody& turned, const HeightMap& heap, const DropArea& area,
                                       const RandomStream& draw, std::uint64_t n);

}  // namespace pomona
