// The slow truth, kept on disk piece by piece, so that a run that was stopped goes on where it was.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona::bench {

/// Walk on spheres at points; one entry per point.
struct WalkTruth {
  std::vector<Color> color;
  std::vector<double> standard_error;  ///< in parts of 255
  double seconds = 0;                  ///< that walking took, earlier runs included
};

struct WalkTruthOptions {
  std::filesystem::path folder;  ///< where pieces are kept; created if it is not there
  double standard_error = 1;     ///< in parts of 255
  Threads threads;
  std::function<void(std::size_t done, std::size_t total)> progress;  ///< in points
};

/// Walks at a few hundred points at a time, and writes each such piece as a file of its own. A piece whose file
/// belongs to the same surfaces, points and error is read instead.
WalkTruth walk_truth(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points,
                     const WalkTruthOptions& options);

}  // namespace pomona::bench
