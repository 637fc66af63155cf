#include "generator/piece/recolored.h"

#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/piece/brown.h"

namespace pomona {

namespace {

/// The side of a vertex on the surface itself: it follows from the vertex's part, or from its colour if both sides have
/// one part.
SurfaceSide side_of(const Solid& piece, std::uint32_t v, const DiffusionSurfaces& own, const SurfaceSide& at) {
  SurfaceSide across = at;
  across.side = at.side == SideOf::front ? SideOf::back : SideOf::front;
  const std::int32_t here = part_of(own, at), beyond = part_of(own, across);
  if (here != beyond) {
    const std::string& part = piece.look->part_names.at(static_cast<std::size_t>(piece.mesh.part[v]));
    return part == own.part_names.at(static_cast<std::size_t>(beyond)) ? across : at;
  }
  const glm::dvec3 color(piece.mesh.color[v]);
  return glm::distance(color_of(own, across), color) < glm::distance(color_of(own, at), color) ? across : at;
}

/// Vertices on surfaces that a knife has exposed, in the colours that they had inside.
class Bared {
 public:
  void add(const Solid& piece, std::uint32_t v) {
    vertex_.push_back(v);
    place_.push_back(piece.mesh.position[v]);
    fresh_.color.push_back(piece.mesh.color[v]);
    fresh_.part.push_back(piece.mesh.part[v]);
  }

  Solid browned_on(Solid piece, const DiffusionSurfaces& surfaces, const Template& fruit) && {
    const DiffusedColors brown = browned(std::move(fresh_), place_, surfaces, fruit);
    for (std::size_t i = 0; i < vertex_.size(); ++i) piece.mesh.color[vertex_[i]] = brown.color[i];
    return piece;
  }

 private:
  std::vector<std::uint32_t> vertex_;
  std::vector<glm::vec3> place_;
  DiffusedColors fresh_;
};

}  // namespace

Solid recolored(Solid piece, const DiffusionSurfaces& own, const DiffusionSurfaces& other, const Template& fruit) {
  if (own.position != other.position || own.triangle != other.triangle)
    throw Error(ExitStatus::bug, "the fruits differ in more than their colours");
  const SurfaceTree tree = make_surface_tree(own);
  std::vector<std::uint8_t> is_done(piece.mesh.position.size(), 0);
  Bared bared;
  for (std::size_t t = 0; t < piece.mesh.triangle.size(); ++t) {
    if (piece.mesh.cut_face[t] >= 0) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = piece.mesh.triangle[t][k];
      if (is_done[v] != 0) continue;
      is_done[v] = 1;
      const std::optional<SurfaceSide> at = nearest_side(own, tree, glm::dvec3(piece.mesh.position[v]));
      if (!at) continue;
      piece.mesh.color[v] = Color(color_of(other, side_of(piece, v, own, *at)));
      if (!own.is_boundary(at->triangle)) bared.add(piece, v);
    }
  }
  return std::move(bared).browned_on(std::move(piece), other, fruit);
}

}  // namespace pomona
