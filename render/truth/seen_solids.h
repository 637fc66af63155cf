// All instances of a scene as a lens sees them.
#pragma once

#include <vector>

#include "generator/base/parallel.h"
#include "render/strokes/seen_solid.h"

namespace pomona {

/// One entry per instance.
inline std::vector<SeenSolid> seen_solids(const Scene& scene, const Lens& lens, Threads threads) {
  std::vector<SeenSolid> seen(scene.instances.size());
  parallel_for(seen.size(), threads, [&](std::size_t i) {
    const Instance& instance = scene.instances[i];
    seen[i] = seen_solid(scene.solids[static_cast<std::size_t>(instance.solid)], instance.pose, lens);
  });
  return seen;
}

}  // namespace pomona
