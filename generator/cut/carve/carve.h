// The cut along a closed surface: what lies inside it parts from what lies outside (paper, section 3.2, whose cutting
// surface may be any).
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/section/cut_fruit.h"
#include "generator/cut/section/size_field.h"
#include "generator/knife/knife_mesh.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// One closed knife among all knives.
struct ClosedKnife {
  KnifeMesh mesh;
  int number = 0;            ///< among all knives
  int plane = 0;             ///< its number as one more plane, in sets of planes
  std::uint32_t stride = 1;  ///< what lies inside is in the cell with a number that is greater by this
};

/// Lays the knife at a fruit that others have cut. Of the points of the fruit's mesh no two may share a place.
Cutting carve(CutFruit fruit, const ClosedKnife& knife, const DiffusionSurfaces& surfaces, const Bodies& bodies);

/// The knife's surface as fine as `limits` ask for, finer next to where it meets the fruit's surfaces.
KnifeMesh refined_for(const CutFruit& fruit, KnifeMesh knife, const SizeLimits& limits);

}  // namespace pomona
