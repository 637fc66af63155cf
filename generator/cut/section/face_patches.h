// The patches of a cut face, and which bodies wind around them: what planes, strokes and closed knives ask alike.
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

  /// Bodies whose boundary does not close on the face, ascending. They have no winding: they fill the patches that
  /// their boundary parts from the outside and to which it turns its visible side for the greater part.
  std::vector<std::int32_t> open_body;

  std::size_t count() const { return triangle.size(); }
  bool is_open(std::int32_t body) const;

  /// The same, with nothing known yet of what the patches close.
  Regions regions() const;
};

FacePatches patches_of(const Face& face, const DiffusionSurfaces& surfaces, const Bodies& bodies);

}  // namespace pomona
