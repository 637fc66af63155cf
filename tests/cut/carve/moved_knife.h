// Exact signs for a knife that is moved by (e, e^2, e^3), in whole numbers: the tie rule must give the same.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/crossings/tie_rule.h"

namespace pomona::shapes {

/// Coordinates are whole numbers from 0 to `max_steps`. When the knife moves, their determinants change by less than
/// the smallest possible one, and no later power of e outweighs an earlier one.
constexpr int max_steps = 4;

/// A place in units of e^3, e = 1/64.
__extension__ using Wide = __int128;
using WidePoint = std::array<Wide, 3>;

WidePoint at_rest(const glm::dvec3& place);
WidePoint moved(const glm::dvec3& place);

/// The sign of det(b - a, c - a, d - a): 1 where abc is counter-clockwise seen from d.
int sign_of_volume(const WidePoint& a, const WidePoint& b, const WidePoint& c, const WidePoint& d);

/// Closed convex shapes with their corners at whole numbers: a box, an octahedron, a tetrahedron, and a prism whose
/// edges run along x, y and z.
std::vector<std::vector<Corners>> convex_shapes();

/// Places with whole coordinates from `low` to `high`.
std::vector<glm::dvec3> whole_places(int low, int high);

}  // namespace pomona::shapes
