// A section's colours as patches of one colour each, for drawing programs.
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
  int width = 800, height = 600;  ///< of the paper, pixels
  double finest = 2.5;            ///< pixels: shorter edges are not halved
  double coarsest = 8;            ///< pixels: longer edges are halved, so that no noise falls between corners
  int tolerance = 6;              ///< of 255: a patch whose colours differ by less is one
  Threads threads{};
};

/// A triangle on the paper.
struct SectionPatch {
  std::array<glm::dvec2, 3> corner{};  ///< pixels, y down
  glm::u8vec3 color{0};                ///< sRGB; each channel even, or 255
  std::int32_t part = 0;               ///< index into part_names
};

/// The section's triangles, halved at their longest edges until they are no longer than `coarsest`, and the look at
/// their corners and centre is one colour or they are as small as `finest`. Together they are the faces, without gaps
/// or overlaps. Same section, same patches, for any threads.
std::vector<SectionPatch> section_patches(const CrossSection& section, const std::vector<PlacedFace>& faces,
                                          const Look& look, const Style& style, const PatchOptions& options = {});

}  // namespace pomona
