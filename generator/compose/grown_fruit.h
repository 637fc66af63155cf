// A grown fruit, and the options of its growth.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/skin_depth.h"
#include "generator/surface/sweep/spot.h"

namespace pomona {

struct GrowOptions {
  bool as_drawn = false;                ///< keep the drawn curves, whatever the key; grains still follow the key
  double variation = 1.0;               ///< 0..2, see VariationOptions::amount
  bool curves_only = false;             ///< see VariationOptions
  std::optional<int> folds = {};        ///< another number of folds than drawn
  double detail = 1.0;                  ///< see SweepOptions
  std::optional<double> ripeness = {};  ///< 0..2, instead of a random one from the key
  double browning = 0;                  ///< browning of cut faces, 0..1
  double scale = 1;                     ///< factor of all lengths of the variant
  Threads threads = {};                 ///< the result does not depend on them
};

/// A grown fruit at several stages.
struct GrownFruit {
  DiffusionSurfaces swept;   ///< as drawn or varied: blur not split, no grains
  DiffusionSurfaces grains;  ///< blur not split
  DiffusionSurfaces sheets;  ///< everything the diffuser sees: blur split, grains included

  /// The skin depth of `swept`, if grow() has computed it; else null.
  std::shared_ptr<const SkinDepth> skin = {};

  std::vector<Spot> raised = {};  ///< spots with relief (spots.h): only for shading, no vertex moves
};

}  // namespace pomona
