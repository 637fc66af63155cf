// A solid as a few convex parts, for the physics: an approximate convex decomposition by planes.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

struct ConvexPartsOptions {
  double tolerance = 0.02;  ///< how far a part may reach out of the solid, as a share of its box's diagonal
  int most = 12;            ///< parts of one solid
  double corner = 0.006;    ///< corners of a part nearer than this share are thinned out
};

/// The corners of one convex part, metres.
using ConvexPart = std::vector<glm::dvec3>;

/// Convex hulls that together cover the solid. The part that reaches farthest out of it is halved by a plane
/// through where it does so, again and again [after Mamou 2016, V-HACD; Wei et al. 2022, CoACD: here with
/// exact clipping of the surface and no sampling of the volume].
std::vector<ConvexPart> convex_parts(const TriangleTree& solid, const ConvexPartsOptions& options = {});

}  // namespace pomona
