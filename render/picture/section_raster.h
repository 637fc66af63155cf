// Rasteriser of sections: exact integer edge tests on a fixed grid of samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "render/image/triangle_raster.h"
#include "render/picture/section_layout.h"
#include "render/picture/stroke.h"

namespace pomona {

/// The part of the section in one pixel.
struct SectionPixel {
  glm::dvec3 color_sum{0};  ///< sum of linear colours over the covered samples
  int samples = 0;          ///< number of covered samples, of section_samples
  std::uint16_t covered =
      0;                  ///< a bit per covered sample; where a curved face overlaps itself, the first triangle counts
  int face = -1;          ///< the face they belong to
  DetailGuide guide_sum;  ///< sum over the covered samples; 0 if the section has no guides
};

constexpr int section_samples = 16;  ///< 4 x 4 a pixel

/// A triangle on the paper, in fixed point, clockwise as seen.
struct PaperTriangle {
  TriangleRaster<std::int64_t> raster;
  glm::uvec3 vertex;  ///< vertices of the section
  int face = 0;
};

/// A section's triangles, to be drawn in bands of rows, so that the pixels of a large picture are never in memory at
/// once.
class SectionRaster {
 public:
  /// Both must outlive it.
  SectionRaster(const CrossSection& section, const std::vector<PlacedFace>& faces, int width, int height);

  /// The number of bands of the picture, and the rows of each, from the top.
  std::size_t bands() const { return touching_.size(); }
  PictureRows rows(std::size_t band) const;

  /// The band's pixels, row by row. A sample on a shared edge belongs to exactly one of the two triangles. May be
  /// called from any thread.
  std::vector<SectionPixel> pixels(std::size_t band) const;

 private:
  const CrossSection& section_;
  int width_, height_;
  std::vector<PaperTriangle> triangles_;
  std::vector<std::vector<std::uint32_t>> touching_;  ///< the triangles of each band, in their order
};

}  // namespace pomona
