// Positive mean values for draft and final: many lines, swept one by one.
#pragma once

#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/pmvc_value.h"
#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// Positive mean values from 2 * lines directions, the same for all points. Lines are summed in fixed blocks
/// and blocks in order, so that the threads have no influence.
/// \throws Error (bad_data) if more than 1024 parts are used.
std::vector<PmvcValue> line_pmvc(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                 std::span<const glm::vec3> points, int lines, Threads threads = {});

}  // namespace pomona
