// FLIP: how different two pictures look when they are shown in turn [Andersson, Nilsson, Akenine-Moeller, Oskarsson,
// Astrom, Fairchild: FLIP: A Difference Evaluator for Alternating Images, High Performance Graphics 2020].
#pragma once

#include <vector>

#include "generator/base/parallel.h"
#include "render/image/image.h"

namespace pomona {

struct FlipOptions {
  /// The viewing conditions. The default is the paper's: 0.7 m before a screen of 0.7 m and 3840 pixels.
  double pixels_per_degree = 67.02064327658225;
  Threads threads;
};

/// The difference at each pixel, 0 (none) to 1, row by row from the top left.
struct FlipMap {
  int width = 0;
  int height = 0;
  std::vector<float> error;
};

/// The same bits for any number of threads.
/// \throws Error (bad_data) for pictures of different sizes.
FlipMap flip(const Image& reference, const Image& result, const FlipOptions& options = {});

/// The mean over all pixels; 0 for an empty map.
double mean(const FlipMap& map);

}  // namespace pomona
