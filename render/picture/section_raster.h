// The triangles of a section to pixels, exactly: in fixed point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "render/image/triangle_raster.h"
#include "render/picture/section_layout.h"
#include "render/picture/stroke.h"

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

/// A triangle on the paper, in fixed point, clockwise as seen.
struct PaperTriangle {
  TriangleRaster<std::int64_t> raster;
  glm::uvec3 vertex;  ///< of the section
  int face = 0;
};

/// A section's triangles, ready to be drawn some rows at a time: a large picture's pixels are never held all at once.
class SectionRaster {
 public:
  /// Both must outlive it.
  SectionRaster(const CrossSection& section, const std::vector<PlacedFace>& faces, int width, int height);

  /// How many bands the picture has, and which rows each holds, from the top.
  std::size_t bands() const { return touching_.size(); }
  PictureRows rows(std::size_t band) const;

  /// The band's pixels, row by row; a sample on a shared edge belongs to exactly one of the two triangles. To be called
  /// from any thread.
  std::vector<SectionPixel> pixels(std::size_t band) const;

 private:
  const CrossSection& section_;
  int width_, height_;
  std::vector<PaperTriangle> triangles_;
  std::vector<std::vector<std::uint32_t>> touching_;  ///< the triangles of each band, in their order
};

}  // namespace pomona
