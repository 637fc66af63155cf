// Cutting: exact intersection, conforming Delaunay triangulation, splitting into front and back, and the
// pieces the knives leave (paper, section 3.2).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/section/cross_section.h"
#include "generator/knife/knife.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// How finely the section is triangulated. Lengths are shares of the fruit's bounding-box diagonal.
struct CutOptions {
  double coarsest = 1.0 / 40;   ///< longest edge far from all surfaces
  double finest = 1.0 / 400;    ///< edges next to the finest surfaces are not made shorter than this
  double grading = 0.35;        ///< how fast edges may grow with the distance from cut segments
  double contrast = 18 / 255.;  ///< difference of colours between two surfaces that needs no vertices between them
  double crumb = 1e-6;          ///< share of the whole's volume below which a piece is a crumb
  Threads threads{};            ///< the result does not depend on them
};

/// A piece before its cut faces have colours: which skin it keeps, and which triangles of the section.
/// Vertices lie exactly where those of the section lie, so the piece closes by position.
struct CutPiece {
  // Skin and cavity walls, clipped. Triangles face air. Colours, parts are those of the hidden (air) side.
  std::vector<glm::vec3> position;
  std::vector<glm::vec3> normal;  ///< smooth, pointing to air
  std::vector<Color> color;
  std::vector<std::int32_t> part;  ///< per vertex; index into CrossSection::part_names
  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> surface;  ///< per triangle

  struct CapTriangle {
    std::uint32_t triangle = 0;  ///< of the section
    bool reversed = false;       ///< the piece lies on the positive side: it faces against the face's normal
  };
  std::vector<CapTriangle> caps;

  double volume = 0;  ///< cubic metres, bodies summed
  bool closed = true;
  bool crumb = false;
};

struct Cut {
  CrossSection section;               ///< interior vertices still without colour
  std::vector<CutPiece> pieces;       ///< ordered: cell by cell, larger before smaller within a cell
  std::vector<std::string> warnings;  ///< open boundaries, knives that miss
};

/// Cuts with all knives, one after another; with none, the whole fruit as pieces. `surfaces` are what the
/// diffuser sees: sheets() with grains.
Cut cut(const DiffusionSurfaces& surfaces, std::span<const Knife> knives, const CutOptions& options = {});

}  // namespace pomona
