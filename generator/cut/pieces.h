// Pieces: what the knives leave, clipped skin and cut faces joined into solids.
#pragma once

#include <vector>

#include "generator/cut/cut_piece.h"
#include "generator/cut/section/cut_options.h"
#include "generator/cut/spared.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Of the fruit's inner surfaces nothing is taken but the walls of spared parts.
std::vector<CutPiece> pieces(const SparedFruit& cut, const DiffusionSurfaces& surfaces, const CutOptions& options);

}  // namespace pomona
