// The cut along a closed surface: what lies inside it parts from what lies outside (paper, section 3.2, whose cutting
// surface may be any).
#pragma once

#include "generator/cut/carve/closed_knife.h"
#include "generator/cut/section/cut_fruit.h"
#include "generator/cut/section/size_field.h"
#include "generator/knife/knife_mesh.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// Lays the knife at a fruit that others have cut. Of the points of the fruit's mesh no two may share a place.
Cutting carve(CutFruit fruit, const ClosedKnife& knife, const DiffusionSurfaces& surfaces, const Bodies& bodies);

/// The knife's surface as fine as `limits` ask for, finer next to where it meets the fruit's surfaces.
KnifeMesh refined_for(const CutFruit& fruit, KnifeMesh knife, const SizeLimits& limits);

}  // namespace pomona
