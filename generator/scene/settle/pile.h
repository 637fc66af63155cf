// The fall of rigid bodies into a heap, by Bullet.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/piece/pose.h"
#include "generator/scene/settle/convex_parts.h"

namespace pomona {

/// A body in its own frame, and where it starts.
struct PileBody {
  std::vector<ConvexPart> parts;
  glm::dvec3 center{0};  ///< of mass
  double mass = 1;       ///< any unit, the same for all
  Pose start;
};

/// A round wall that keeps falling bodies over the bowl; it is taken away once they have come to rest.
struct Funnel {
  double radius = 0;  ///< metres about the axis; 0 = no funnel
  double low = 0;     ///< its lower end, metres above the ground
};

struct PileOptions {
  double unit = 0.05;  ///< metres that count as 1 in the simulation: about the size of a body
  int most_steps = 1600;
  double fastest = 0.06;  ///< units that a body may move in one step: less than the thinnest is thick
  double friction = 0.6;  ///< of every two surfaces
  double rolling_friction = 0.01;
  double margin = 0.006;  ///< units by which parts are shrunken and their corners rounded
  double at_rest = 2e-3;  ///< units a step: slower bodies count as still
};

struct Piled {
  std::vector<Pose> poses;
  bool at_rest = true;
  int steps = 0;
};

/// Lets the bodies fall onto the round stand whose upper surface is `stand` (distance from the axis, height; from
/// the axis outwards; the last height goes on for ever) until all are at rest. The same bits for the same input on any
/// x86-64: one thread, a fresh world, fixed steps, and none of the C library's functions in the motion.
Piled pile(std::span<const PileBody> bodies, std::span<const glm::dvec2> stand, const Funnel& funnel,
           const PileOptions& options = {});

}  // namespace pomona
