// Cutting: exact intersection, conforming Delaunay triangulation, splitting into front and back, and the
// pieces the knives leave (paper, section 3.2).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "generator/cut/section/cut_options.h"
#include "generator/knife/knife.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A piece before its cut faces have colours: its part of the skin, and its triangles of the section.
/// Vertices lie exactly where those of the section lie, so the piece closes by position.
struct CutPiece {
  // Skin and cavity walls, clipped. Triangles face air. Colours, parts are those of the hidden (air) side.
  std::vector<glm::vec3> position;
  std::vector<glm::vec3> normal;  ///< smooth, pointing to air
  std::vector<Color> color;
  std::vector<std::int32_t> part;   ///< per vertex; index into CrossSection::part_names
  std::vector<std::uint8_t> bared;  ///< per vertex: 1 on the wall of a spared part: freshly exposed, as a cut face is
  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> surface;  ///< per triangle

  struct CapTriangle {
    std::uint32_t triangle = 0;  ///< of the section
    bool reversed = false;       ///< the piece lies on the positive side, so that its triangle faces against the normal
  };
  std::vector<CapTriangle> caps;

  double volume = 0;  ///< cubic metres, the sum over bodies
  bool closed = true;
  bool crumb = false;
};

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
