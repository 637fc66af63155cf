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
  /// So many of the finest levels follow their parents without a choice: they only hold roughness.
  int smooth_levels = 2;
  /// The coarsest band holds the loop's large shape, of which the sample has only one: mix it at random out of
  /// its own turns, which keeps its spectrum on average, rather than only turn it.
  bool mix_turns = true;
};

/// Which value of the sample each value of the output is copied from, level by level, 0 the finest.
struct SourceMap {
  std::vector<std::vector<std::size_t>> level;
  std::vector<double> turns;          ///< how much of each turn of the coarsest band, about its mean
  std::size_t fewest_candidates = 0;  ///< never 0: a value's own child always qualifies
};

/// All channels have the same length, a power of two of at least 16, and share one map, so that what belongs
/// together in the sample stays together. Draws from the purposes "vary/loop/level0", "vary/loop/level1", ...
SourceMap draw_source_map(const std::vector<CyclicSignal>& channels, VariantKey key, const SynthesisOptions& options);

/// The channel with the bands that the map says.
CyclicSignal copied(const CyclicSignal& channel, const SourceMap& map);

}  // namespace pomona
