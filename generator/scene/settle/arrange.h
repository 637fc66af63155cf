// Arranging: pieces that are not dropped from places drawn, but begin where their scene says.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/base/random.h"
#include "generator/scene/settle/dish.h"
#include "generator/scene/settle/heap.h"
#include "generator/scene/settle/piece_arrangement.h"
#include "generator/scene/settle/piece_shape.h"

namespace pomona {

/// How a piece is turned before it falls, or where it is set.
enum class Attitude : std::uint8_t {
  any,      ///< as it comes to rest when it falls alone
  face_up,  ///< its largest cut face upwards
  upright   ///< as it grew
};

/// One piece to be arranged.
struct Arranged {
  std::size_t piece = 0;  ///< its number, which draws are made by
  const PieceShape* shape = nullptr;
  const Solid* solid = nullptr;
  Attitude attitude = Attitude::any;
  int fruit = 0;  ///< pieces of one cut fruit have the same; their shapes know where in it they were
};

/// Where a piece begins.
struct Start {
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 center{0};  ///< of mass, metres
};

struct ArrangeOptions {
  HeapOptions heap{};
  double unit = 0, widest = 0;     ///< metres: the mean size of all pieces, the radius of the widest
  std::vector<RigidBody> there{};  ///< what lies there already, which scattered pieces keep clear of
  Threads threads{};
};

/// Whether the dish has a mesh with triangles that look upwards, to scatter pieces on.
bool has_upper_side(const Dish& dish);

/// One start a piece, in their order: set down on the dish where they stay (rows, grids, scatterings), or where they
/// are to be let go (as cut). None where a scattered piece finds no room.
std::vector<std::optional<Start>> arranged(std::span<const Arranged> pieces, const PieceArrangement& how,
                                           const Dish& dish, const RandomStream& draw, const ArrangeOptions& options);

}  // namespace pomona
