// The cut along a closed surface: it separates the inside from the outside (paper, section 3.2, which allows any
// cutting surface).
#pragma once

#include "generator/cut/carve/closed_knife.h"
#include "generator/cut/section/cut_fruit.h"
#include "generator/cut/section/size_field.h"
#include "generator/knife/knife_mesh.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// Cuts a fruit that other knives may have cut before. No two points of the fruit's mesh may have the same position.
Cutting carve(CutFruit fruit, const ClosedKnife& knife, const DiffusionSurfaces& surfaces, const Bodies& bodies);

/// The knife's surface, refined as `limits` ask for, and more where it intersects the fruit's surfaces.
KnifeMesh refined_for(const CutFruit& fruit, KnifeMesh knife, const SizeLimits& limits);

}  // namespace pomona
