// Cutting: exact intersection, conforming Delaunay triangulation, splitting into front and back, and the
// pieces the knives leave (paper, section 3.2).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/cut/cut_piece.h"
#include "generator/cut/section/cross_section.h"
#include "generator/cut/section/cut_options.h"
#include "generator/knife/knife.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct Cut {
  CrossSection section;               ///< interior vertices still without colour
  std::vector<CutPiece> pieces;       ///< ordered: cell by cell, larger before smaller within a cell
  std::vector<std::string> warnings;  ///< open boundaries, knives that miss
};

/// Observes the stages (cut_observer.h).
class CutObserver;

/// Cuts with all knives, one after another; with none, the whole fruit as pieces. `surfaces` are what the
/// diffuser sees: sheets() with grains.
/// \throws Error (usage) for knives that cannot be placed at this fruit: slices that it cannot give, strokes along
/// other knives' planes, peels thicker than the fruit, more than ten thousand cells.
Cut cut(const DiffusionSurfaces& surfaces, std::span<const Knife> knives, const CutOptions& options = {},
        CutObserver* observer = nullptr);

}  // namespace pomona
