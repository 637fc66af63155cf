// The pieces that the knives leave: clipped skin and cut faces joined to solids.
#pragma once

#include <vector>

#include "generator/cut/cut_piece.h"
#include "generator/cut/section/cut_options.h"
#include "generator/cut/spared.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Makes the pieces. Of the fruit's inner surfaces, only the walls of spared parts are used.
std::vector<CutPiece> pieces(const SparedFruit& cut, const DiffusionSurfaces& surfaces, const CutOptions& options);

}  // namespace pomona
