// Hulls of settled pieces, so that none begins within another.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "render/export/convex_hull.h"

namespace pomona {

/// Convex parts where they stand.
struct StandingHulls {
  std::vector<const ConvexHull*> parts;
  glm::dvec3 place{0};
  glm::dquat rotation{1, 0, 0, 0};
  bool gives_way = true;  ///< pieces do, dishes do not
};

/// What is left of the parts of a body that gave way.
struct TrimmedHulls {
  bool changed = false;
  std::vector<ConvexHull> parts;  ///< all of them, about the body's origin, where anything has changed
};

/// Settled pieces overlap by a little, and their hulls by more: the hull of a tomato reaches to the tip of its stem. A
/// simulator takes that for a blow, and throws them apart. Here each two parts that overlap are cut apart by a plane:
/// of many, the one that takes the least of both, in shares of their volumes. Parts of one body may overlap.
std::vector<TrimmedHulls> hulls_apart(std::span<const StandingHulls> bodies, Threads threads);

/// Each two bodies that hulls_apart() would cut, as indices in ascending order. Pieces that welds join must not collide
/// there: the hull of a ring is full, as that of a socket, and what lies in it lies in the hull.
std::vector<std::array<std::size_t, 2>> bodies_that_overlap(std::span<const StandingHulls> bodies, Threads threads);

}  // namespace pomona
