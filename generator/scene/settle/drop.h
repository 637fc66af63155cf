// Where pieces are let go: above the bowl, none touching another.
#pragma once

#include <span>
#include <vector>

#include "generator/base/random.h"
#include "generator/piece/pose.h"
#include "generator/scene/settle/convex_parts.h"

namespace pomona {

/// What is dropped, and the direction in its frame that should come to lie upwards.
struct DropPiece {
  std::span<const ConvexPart> parts;
  glm::dvec3 up{0};  ///< zero: any
  int order = 0;
  bool beside = false;
};

/// The space they are dropped into, about the axis.
struct DropSpace {
  double radius = 0;  ///< of the bowl's opening
  double height = 0;  ///< of its rim
  double around = 0;  ///< pieces beside it start within this distance from the axis
};

/// One pose each: lower orders lower, within an order as drawn; of a few places drawn for a piece the lowest free one.
std::vector<Pose> drop_poses(std::span<const DropPiece> pieces, const DropSpace& space, const RandomStream& draw);

}  // namespace pomona
