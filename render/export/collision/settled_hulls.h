// What the pieces of a scene collide with where they lie, in files for engines and in USD.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/scene/scene.h"
#include "render/export/convex_hull.h"

namespace pomona {

/// Whether the things of the scene came to rest; pieces of a fruit that is only cut lie where they grew.
bool is_settled(const Scene& scene);

/// Convex parts of each instance, in its solid's frame, that leave room for those of others (hulls_apart.h); none where
/// the solid's do. \param parts of each solid.
std::vector<std::vector<ConvexHull>> settled_hulls(const Scene& scene, std::span<const std::vector<ConvexHull>> parts,
                                                   Threads threads);

/// Each two instances, as indices in ascending order, whose parts overlap [hulls_apart.h: bodies_that_overlap()].
/// \param parts of each solid.
std::vector<std::array<std::size_t, 2>> instances_that_overlap(const Scene& scene,
                                                               std::span<const std::vector<ConvexHull>> parts,
                                                               Threads threads);

}  // namespace pomona
