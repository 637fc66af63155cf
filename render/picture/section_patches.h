// A section as patches of uniform colour, for drawing programs.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/cut/section/cross_section.h"
#include "render/picture/section_layout.h"
#include "render/style/look.h"
#include "render/style/style.h"

namespace pomona {

struct PatchOptions {
  int width = 800, height = 600;  ///< width and height of the paper, pixels
  double finest = 2.5;            ///< edges shorter than this are not halved, pixels
  double coarsest = 8;            ///< edges longer than this are halved, so that no noise is missed, pixels
  int tolerance = 6;              ///< patches whose colours differ by less are not divided, 0 to 255
  Threads threads{};
};

/// A triangle on the paper.
struct SectionPatch {
  std::array<glm::dvec2, 3> corner{};  ///< pixels, y down
  glm::u8vec3 color{0};                ///< sRGB; each channel even, or 255
  std::int32_t part = 0;               ///< index into part_names
};

/// The section's triangles, halved at their longest edges until these are at most `coarsest`, and the colours at
/// corners and centre are equal or the edges are at most `finest`. Together they cover the faces without gaps or
/// overlaps. The result is the same for any number of threads.
std::vector<SectionPatch> section_patches(const CrossSection& section, const std::vector<PlacedFace>& faces,
                                          const Look& look, const Style& style, const PatchOptions& options = {});

}  // namespace pomona
