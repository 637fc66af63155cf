// Triangles to pixels, exactly: integer edge tests on a fixed grid of samples.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/section/cross_section.h"
#include "render/picture/section_layout.h"

namespace pomona {

/// What of the section falls into one pixel.
struct SectionPixel {
  glm::dvec3 color_sum{0};    ///< linear, over the covered samples
  int samples = 0;            ///< covered ones, of section_samples
  std::uint16_t covered = 0;  ///< which; where a curved face lies on itself, the first triangle counts
  int face = -1;              ///< the face they belong to
  DetailGuide guide_sum;      ///< over the covered samples; 0 where the section has none
};

constexpr int section_samples = 16;  ///< 4 x 4 a pixel

/// Row by row; a sample on a shared edge belongs to exactly one of the two triangles.
std::vector<SectionPixel> rasterised(const CrossSection& section, const std::vector<PlacedFace>& faces, int width,
                                     int height, Threads threads);

}  // namespace pomona
