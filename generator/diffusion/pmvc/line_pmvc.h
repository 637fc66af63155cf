// Positive mean values for draft and final: many lines, swept one by one.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/pmvc/line_directions.h"
#include "generator/diffusion/pmvc_value.h"
#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// The lines along which rays are cast.
struct LinePlan {
  /// The lines for all points. Neighbours are pairs (2 i, 2 i + 1) if there are `more`.
  std::vector<Line> lines;

  /// Additional lines, for points where colours scatter by more than `max_scatter`.
  std::vector<Line> more;

  /// The limit of the scatter of a channel, linear or in sRGB, whichever is more: the root of the summed squares of the
  /// differences within pairs.
  double max_scatter = std::numeric_limits<double>::infinity();

  /// Whether points in one plane turn the lines' frames to it, which is faster: then values differ in their last bits
  /// from those of the same points among others. Without, a value depends on its point alone.
  bool follow_plane = true;
};

/// Positive mean values from two directions for every line, the same for all points. Lines are summed in fixed blocks
/// and blocks in order, so the result does not depend on the threads. `fourth` is empty, or has a further value for
/// every vertex that diffuses like a colour.
/// \throws Error (bad_data) if more than 1024 parts are used.
std::vector<PmvcValue> line_pmvc(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                 std::span<const glm::vec3> points, const LinePlan& plan, Threads threads = {},
                                 std::span<const float> fourth = {});

}  // namespace pomona
