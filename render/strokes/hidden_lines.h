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
  double heft = 1;  ///< factor of the pen's width: largest where another object or the ground is behind
};

/// A visible run, with points about a pixel apart.
struct VisibleRun {
  std::vector<RunPoint> points;
  bool closed = false;
  LineKind kind = LineKind::contour;
  std::uint32_t instance = 0;
};

struct VisibilityOptions {
  double gap = 4;    ///< shorter hidden runs between visible ones count as visible, pixels
  double least = 4;  ///< shorter visible runs are dropped, pixels
};

/// A contour is visible where nothing nearer lies a pixel outside of it; another line is visible where its own surface
/// is the nearest, on the line or beside it.
std::vector<VisibleRun> visible_runs(std::span<const ObjectLine> lines, const IdentityBuffer& buffer, const Lens& lens,
                                     const VisibilityOptions& options = {});

/// The runs of a line where `keep` is set (one entry per point); the line itself if it is set everywhere.
std::vector<VisibleRun> kept_stretches(const VisibleRun& line, const std::vector<std::uint8_t>& keep);

/// Sets to `value` all runs of fewer than `least` points with another value, if they lie between points with this
/// value.
void close_gaps(std::vector<std::uint8_t>& flags, std::uint8_t value, double least, bool closed);

}  // namespace pomona
