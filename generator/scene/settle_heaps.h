// Settles the heaps of a scene, each in its dish.
#pragma once

#include <vector>

#include "generator/scene/make_parts.h"

namespace pomona {

struct SettledHeaps {
  std::vector<Pose> poses;  ///< poses of the dishes, then of the items, in the scene
  std::vector<Fit> fits;    ///< fits of the items, each within its heap
  int attempts = 0;         ///< largest number of any heap
  int steps = 0;
  std::size_t again = 0, heaps = 0;
};

/// Pieces of different dishes do not touch each other; pieces on the ground touch no dish except the bowl.
/// \throws Error as settle() does.
SettledHeaps settled_heaps(const SceneDescription& scene, const SceneParts& parts, const ComposeOptions& options);

}  // namespace pomona
