// Colours by walks on spheres, kept on disk in small files, so that a stopped run continues where it was.
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
  double seconds = 0;                  ///< time of all walks, including earlier runs
};

struct WalkTruthOptions {
  std::filesystem::path folder;  ///< where the files are kept; created if missing
  double standard_error = 1;     ///< in parts of 255
  Threads threads;
  std::function<void(std::size_t done, std::size_t total)> progress;  ///< in points
};

/// Computes a few hundred points at a time and writes a file for each such group. If a group's file belongs to the same
/// surfaces, points and error, it is read instead.
WalkTruth walk_truth(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points,
                     const WalkTruthOptions& options);

}  // namespace pomona::bench
