#include "render/export/collision/collision_shape.h"

#include "render/export/collision/convex_parts.h"
#include "render/export/piece_words.h"

namespace pomona {

std::vector<ConvexHull> collision_parts(const Solid& solid, int hulls) {
  if (!is_fruit(solid)) return convex_parts(solid, {.most = 256});
  if (hulls > 1) return convex_parts(solid, {.most = static_cast<std::size_t>(hulls)});
  ConvexHull hull = convex_hull(solid.mesh.position);
  return hull.triangle.empty() ? std::vector<ConvexHull>{} : std::vector<ConvexHull>{std::move(hull)};
}

}  // namespace pomona
