// The distance of a point from a plane, with the exact sign for the doubles given.
#pragma once

#include "generator/knife/knife.h"

namespace pomona {

/// n.p - D in metres. Its sign (also 0) is that of the result without rounding; at least six digits are right. A
/// floating-point filter decides nearly always; else the sum is computed as an expansion of doubles (Shewchuk 1997,
/// "Adaptive precision floating-point arithmetic and fast robust geometric predicates"). Exact unless a product is
/// between 0 and 1e-290.
double exact_distance(const CuttingPlane& plane, const glm::dvec3& point);

}  // namespace pomona
