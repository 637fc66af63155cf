// Start poses of pieces that the scene arranges; all others are dropped at random.
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
#include "generator/scene/settle/piece_arrangement.h"
#include "generator/scene/settle/piece_shape.h"
#include "generator/scene/settle/rigid_body_world.h"

namespace pomona {

/// The orientation of a piece at its start.
enum class Attitude : std::uint8_t {
  any,      ///< the one in which it comes to rest when it falls alone
  face_up,  ///< its largest cut face points up
  upright   ///< the one in which it grew
};

/// One piece to be arranged.
struct ArrangedPiece {
  std::size_t piece = 0;  ///< its number; it selects the random numbers
  const PieceShape* shape = nullptr;
  const Solid* solid = nullptr;
  Attitude attitude = Attitude::any;
  int fruit = 0;  ///< number of the fruit it was cut from; the shape's frame is that of the fruit
};

/// The start pose of a piece.
struct StartPose {
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 center{0};  ///< centre of mass, metres
};

struct ArrangeOptions {
  WorldOptions world{};
  double unit = 0;                     ///< mean size of all pieces, metres
  double widest = 0;                   ///< largest radius of a piece, metres
  std::vector<RigidBody> obstacles{};  ///< bodies that lie there already; scattered pieces do not touch them
  Threads threads{};
};

/// Whether the dish has a mesh with triangles that face upwards, to scatter pieces on.
bool has_upper_side(const Dish& dish);

/// One start pose for each piece, in their order. Pieces of rows, grids and scatterings lie on the dish and stay there;
/// pieces "as cut" start above it and fall. Nothing for a scattered piece that finds no room.
std::vector<std::optional<StartPose>> arrange(std::span<const ArrangedPiece> pieces, const PieceArrangement& how,
                                              const Dish& dish, const RandomStream& draw,
                                              const ArrangeOptions& options);

}  // namespace pomona
