// The size field: the wanted edge length at each point of a cut face, and free points with this spacing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/color.h"

namespace pomona {

/// Lengths in metres.
struct SizeLimits {
  double coarsest = 0;
  double finest = 0;
  double grading = 0;   ///< growth of the size per metre of distance
  double contrast = 0;  ///< difference of colours, in linear channels, up to which linear interpolation is good enough
};

/// A segment, and the size that triangles should have next to it.
struct SizeSource {
  glm::dvec2 a{0}, b{0};
  double size = 0;
  Color left{0}, right{0};  ///< on either side of the direction from a to b
  bool has_color = true;    ///< false for lines in which planes intersect: the field passes through them
};

/// The size at a point: the minimum over all sources of (size of the source + distance from it * grading); and between
/// sources that face each other with different colours, also a share of the gap. It is stored on a grid, and depends
/// only on its input.
///
/// Between two surfaces whose colours differ by C, the field differs from a straight line by about a tenth of C. The
/// error of interpolation is the square of (edge length / gap) times that. So edge length / gap = sqrt(contrast / C);
/// if this is 1 or more, the gap needs no vertex.
class SizeField {
 public:
  /// \param across number of grid cells along the longer side of the sources' bounds.
  SizeField(std::span<const SizeSource> sources, const SizeLimits& limits, int across = 192);

  double at(const glm::dvec2& p) const;

  /// Points that are about one size apart from each other, and half a size from the sources: one row along the middle
  /// of a gap where that is enough; elsewhere a lattice, which is hexagonal where the size is constant. None outside
  /// the bounds of the sources.
  std::vector<glm::dvec2> samples() const;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int column(double x) const;
  int row(double y) const;
  glm::dvec2 center(int x, int y) const { return low_ + cell_ * glm::dvec2(x + 0.5, y + 0.5); }
  void draw_sources();
  void find_nearest();
  void find_gaps();
  void measure_gap(const glm::dvec2& center, std::size_t cell, const glm::dvec2& other_center, std::size_t other);
  void spread();
  void bucket_sources();
  bool is_clear_of_sources(const glm::dvec2& p, double size) const;

  /// A point in the middle of a gap for which one row of points is enough.
  struct MidGap {
    glm::dvec2 place{0};
    double size = 0;
  };

  std::vector<SizeSource> sources_;
  bool has_lines_ = false;  // sources without colours
  SizeLimits limits_;
  glm::dvec2 low_{0};
  double cell_ = 1;
  int width_ = 0, height_ = 0;
  std::vector<double> size_;
  std::vector<double> gap_size_;  // as the gap around the cell alone wants it
  std::vector<MidGap> mid_gap_;
  std::vector<std::uint8_t> on_source_;      // a source with colours passes through the cell
  std::vector<std::int32_t> nearest_;        // source with colours; -1 for none
  std::vector<double> distance_;             // from the cell's centre to it
  std::vector<std::uint32_t> bucket_start_;  // per cell, into bucket_
  std::vector<std::uint32_t> bucket_;        // sources that pass through the cell
};

}  // namespace pomona
