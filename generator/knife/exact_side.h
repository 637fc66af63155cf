// How far a point lies from a plane, and on which side: the exact side for the doubles given.
#pragma once

#include "generator/knife/knife.h"

namespace pomona {

/// n.p - D in metres with the sign that it has without rounding, 0 included, and at least six digits right. A
/// floating-point filter answers nearly always; else the sum is carried out as an expansion of doubles (Shewchuk 1997,
/// "Adaptive precision floating-point arithmetic and fast robust geometric predicates"). Exact as long as no product is
/// below 1e-290 without being zero.
double exact_distance(const CuttingPlane& plane, const glm::dvec3& point);

}  // namespace pomona
