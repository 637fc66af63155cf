// Solids as unions of convex parts, for programs that collide nothing else.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/piece/solid.h"
#include "render/export/convex_hull.h"

namespace pomona {

struct ConvexPartsOptions {
  std::size_t most = 64;   ///< parts
  double layer = 2e-4;     ///< metres: parts whose hull holds no more beyond them, spread over one of their two sides,
                           ///< are not cut again
  double overhang = 2e-4;  ///< metres: what stands out farther of a part at last is cut off
  std::size_t corners = 64;  ///< of a part, at least 14
};

/// Convex parts, in the solid's frame. Each body of the solid is cut by planes, where the hulls of what is left hold
/// the least, until they hold no more than asked for or there are as many as permitted [after Lien and Amato 2007];
/// then each hull is trimmed by planes that touch the solid where the hull stands out most. Of an open mesh, whose
/// inside is not known, the parts are hulls of what planes leave of its surface.
std::vector<ConvexHull> convex_parts(const Solid& solid, const ConvexPartsOptions& options = {});

}  // namespace pomona
