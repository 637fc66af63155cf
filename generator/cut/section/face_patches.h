// The patches of a cut face, and the winding numbers of bodies around them, for planes, strokes and closed knives.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/section/face.h"
#include "generator/cut/section/regions.h"
#include "generator/surface/bodies.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct FacePatches {
  std::vector<std::uint32_t> patch_of;               ///< per triangle of the face
  std::vector<std::vector<std::uint32_t>> triangle;  ///< per patch, ascending
  std::vector<std::vector<BodyWinding>> inside;      ///< per patch, ascending by body, no zeros

  /// Bodies whose boundary is not closed on the face, sorted. They have no winding numbers: they fill the patches that
  /// their boundary separates from the outside and to which the larger part of the boundary shows its visible side.
  std::vector<std::int32_t> open_body;

  std::size_t count() const { return triangle.size(); }
  bool is_open(std::int32_t body) const;

  /// The patches as regions, whose `closes` are still empty.
  Regions regions() const;
};

FacePatches patches_of(const Face& face, const DiffusionSurfaces& surfaces, const Bodies& bodies);

}  // namespace pomona
