// Hidden lines are left out: which stretches of an object's lines one sees.
#pragma once

#include <span>
#include <vector>

#include "render/strokes/identity_buffer.h"
#include "render/strokes/object_lines.h"

namespace pomona {

struct RunPoint {
  glm::dvec2 at{0};  ///< pixels
  double distance = 0;
  glm::dvec3 own{0};  ///< in the fruit's own frame, metres
  glm::dvec2 outwards{0};
  double opacity = 1;
  double heft = 1;  ///< times the pen's width: most where another thing or the ground lies behind
};

/// A stretch, its points about a pixel apart.
struct VisibleRun {
  std::vector<RunPoint> points;
  bool closed = false;
  LineKind kind = LineKind::contour;
  std::uint32_t instance = 0;
};

struct VisibilityOptions {
  double gap = 4;    ///< pixels: shorter hidden stretches between visible ones are seen, too
  double least = 4;  ///< pixels: shorter runs are dropped
};

/// A contour is seen where nothing nearer lies a pixel outside of it; another line, where it lies on the nearest
/// surface on it or beside it.
std::vector<VisibleRun> visible_runs(std::span<const ObjectLine> lines, const IdentityBuffer& buffer, const Lens& lens,
                                     const VisibilityOptions& options = {});

/// The stretches of a line for which `keep` is set, one entry per point; the line itself where it is set everywhere.
std::vector<VisibleRun> kept_stretches(const VisibleRun& line, const std::vector<std::uint8_t>& keep);

/// Turns stretches of less than `least` points that are not `value` to it, where they lie between such that are.
void close_gaps(std::vector<std::uint8_t>& flags, std::uint8_t value, double least, bool closed);

}  // namespace pomona
