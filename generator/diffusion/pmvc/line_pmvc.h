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
  /// For all points. Neighbours in pairs (2 i, 2 i + 1) if there are `more`.
  std::vector<Line> lines;

  /// Additional lines, for points where colours scatter by more than `max_scatter`.
  std::vector<Line> more;

  /// Of the colour in any channel, linear or in sRGB, whichever is more: the root of the summed squares of what the
  /// lines of each pair add differently.
  double max_scatter = std::numeric_limits<double>::infinity();
};

/// Positive mean values from two directions for every line, the same for all points. Lines are summed in fixed blocks
/// and blocks in order, so that the threads have no influence. `fourth` is nothing, or for every vertex a further value
/// that spreads like a colour.
/// \throws Error (bad_data) if more than 1024 parts are used.
std::vector<PmvcValue> line_pmvc(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                 std::span<const glm::vec3> points, const LinePlan& plan, Threads threads = {},
                                 std::span<const float> fourth = {});

}  // namespace pomona
