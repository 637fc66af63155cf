// How fine the triangulation of a cut face should be where, and free points that are spread accordingly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

/// Lengths in metres.
struct SizeLimits {
  double coarsest = 0;
  double finest = 0;
  double grading = 0;  ///< growth of the size per metre of distance
  double gap = 0;      ///< share of the distance between two sources that face each other
};

/// A segment, and the size that triangles should have next to it.
struct SizeSource {
  glm::dvec2 a{0}, b{0};
  double size = 0;
};

/// Size as a function of place: the smallest over all sources of their size and the distance from them times the
/// grading; and between sources that face each other, a share of the gap. Kept on a grid; a function of its input
/// alone.
class SizeField {
 public:
  /// The grid has `across` cells along the longer side of the sources' bounds.
  SizeField(std::span<const SizeSource> sources, const SizeLimits& limits, int across = 160);

  double at(const glm::dvec2& p) const;

  /// Points about a size apart from each other, and half a size from the sources; on a hexagonal lattice wherever
  /// the size is even. None outside the sources' bounds.
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
  void spread();
  void bucket_sources();
  bool is_clear_of_sources(const glm::dvec2& p, double size) const;

  std::vector<SizeSource> sources_;
  SizeLimits limits_;
  glm::dvec2 low_{0};
  double cell_ = 1;
  int width_ = 0, height_ = 0;
  std::vector<double> size_;
  std::vector<double> gap_size_;             // as the gap around the cell alone wants it
  std::vector<std::uint8_t> on_source_;      // a source passes through the cell
  std::vector<std::int32_t> nearest_;        // source; -1 for none
  std::vector<double> distance_;             // from the cell's centre to it
  std::vector<std::uint32_t> bucket_start_;  // per cell, into bucket_
  std::vector<std::uint32_t> bucket_;        // sources that pass through the cell
};

}  // namespace pomona
