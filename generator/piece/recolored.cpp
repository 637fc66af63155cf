#include "generator/piece/recolored.h"

#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/diffusion/nearest_side.h"

namespace pomona {

Solid recolored(Solid piece, const DiffusionSurfaces& own, const DiffusionSurfaces& other) {
  if (own.position != other.position || own.triangle != other.triangle)
    throw Error(ExitStatus::bug, "the fruits differ in more than their colours");
  const SurfaceTree tree = make_surface_tree(own);
  std::vector<std::uint8_t> is_done(piece.position.size(), 0);
  for (std::size_t t = 0; t < piece.triangle.size(); ++t) {
    if (piece.cut_face[t] >= 0) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = piece.triangle[t][k];
      if (is_done[v] != 0) continue;
      is_done[v] = 1;
      std::optional<SurfaceSide> at = nearest_side(own, tree, glm::dvec3(piece.position[v]));
      if (!at) continue;

      // On the surface itself a side is not told by the place, but by the colour that the vertex has of it.
      SurfaceSide across = *at;
      across.side = at->side == SideOf::front ? SideOf::back : SideOf::front;
      const glm::dvec3 color(piece.color[v]);
      const bool is_across = glm::distance(color_of(own, across), color) < glm::distance(color_of(own, *at), color);
      piece.color[v] = Color(color_of(other, is_across ? across : *at));
    }
  }
  return piece;
}

}  // namespace pomona
