// Where and how pieces are let go.
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

/// Draws of one piece for one drop: a block of counters to itself.
constexpr std::uint64_t draws_per_drop = 64;

/// The pieces in the order in which they fall: lower ones of `order` first, within these as drawn.
std::vector<std::size_t> dropping_order(std::span<const int> order, const RandomStream& draw);

/// The shortest turn that takes one unit direction to another.
glm::dquat turn_between(const glm::dvec3& from, const glm::dvec3& to);

/// By an angle about an axis of length 1.
glm::dquat turn_about(const glm::dvec3& axis, double radians);

/// Any rotation, each as likely; or, where `up` is not zero, one that turns it towards the sky, up to a slight tilt.
/// Draws from counter n on.
glm::dquat drawn_rotation(const glm::dvec3& up, const RandomStream& draw, std::uint64_t n);

/// A ring on the ground into which pieces are dropped.
struct DropRing {
  double inner = 0, outer = 0;  ///< metres from its middle, of their centres
  double rim_radius = 0;        ///< no piece starts above a cone that rises inwards from this circle at the steepest
  double rim_height = 0;        ///< slope at which pieces lie on each other; a radius of 0: there is no such cone
  glm::dvec2 middle{0};         ///< x and z; the cone stands about the axis all the same
};

/// Cells of a dish into which pieces are dropped. No piece starts above what rises inwards from their border likewise.
using DropCells = std::vector<MeshDish::Place>;

using DropArea = std::variant<DropRing, DropCells>;

/// The lowest of a few places drawn in the area, for the centre of a turned body; none if all are too high. Draws from
/// counter n on.
std::optional<glm::dvec3> drawn_place(const RigidBody& turned, const HeightMap& heap, const DropArea& area,
                                      const RandomStream& draw, std::uint64_t n);

}  // namespace pomona
