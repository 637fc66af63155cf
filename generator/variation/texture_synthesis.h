// Texture synthesis by multiresolution sampling [De Bonet 1997], in one dimension and cyclic, as the paper's
// section 4.2 applies it to curves.
#pragma once

#include <vector>

#include "generator/base/random.h"
#include "generator/variation/laplacian_pyramid.h"

namespace pomona {

struct SynthesisOptions {
  /// How far apart parent structures may be, root mean square over features in units of their standard
  /// deviation: 0 turns the sample, 0.7 gives natural variants, above 1 the bands lose their phase.
  double threshold = 0.7;
  /// Number of the finest levels that follow their parents without a choice: they contain only roughness.
  int smooth_levels = 2;
  /// The coarsest band contains the large shape of the loop, of which there is only one sample. If true, it is a random
  /// mixture of rotated copies, which keeps the spectrum on average; else one rotated copy.
  bool mix_turns = true;
};

/// The value of the sample from which each value of the output is copied.
struct SourceMap {
  std::vector<std::vector<std::size_t>> level;  ///< [level][value]: index in the sample; level 0 is the finest
  std::vector<double> turns;                    ///< coefficient of each rotation of the coarsest band, about its mean
  std::size_t fewest_candidates = 0;            ///< never 0: the child of a value itself is always a candidate
};

/// Draws the map. All channels share it, so that what belongs together in the sample stays together. They have the same
/// length: a power of two, at least 16. Uses the random streams "vary/loop/level0", "vary/loop/level1", ...
SourceMap draw_source_map(const std::vector<CyclicSignal>& channels, VariantKey key, const SynthesisOptions& options);

/// The channel composed of the bands that the map selects.
CyclicSignal copied(const CyclicSignal& channel, const SourceMap& map);

}  // namespace pomona
