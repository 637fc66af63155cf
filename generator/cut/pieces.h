// Pieces: what the knives leave, clipped skin and cut faces joined into solids.
#pragma once

#include <vector>

#include "generator/cut/cut.h"
#include "generator/cut/section/cut_fruit.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Of the fruit's inner surfaces nothing is taken.
std::vector<CutPiece> pieces(const CutFruit& fruit, const DiffusionSurfaces& surfaces, const CutOptions& options);

}  // namespace pomona
