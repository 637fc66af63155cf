// From a template and a seed to everything the diffuser sees: the first half of the road in one verb.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/base/random.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/skin_depth.h"
#include "generator/surface/sweep/spot.h"
#include "generator/template/template.h"
#include "generator/variation/variation.h"

namespace pomona {

struct GrowOptions {
  bool as_drawn = false;                ///< keep the drawn curves, whatever the key; grains still follow the key
  double variation = 1.0;               ///< 0..2, see VariationOptions::amount
  bool curves_only = false;             ///< see VariationOptions
  std::optional<int> folds = {};        ///< another number of folds than drawn
  double detail = 1.0;                  ///< see SweepOptions
  std::optional<double> ripeness = {};  ///< 0..2 instead of what the key draws
  double browning = 0;                  ///< 0..1, of cut faces
  double scale = 1;                     ///< of all lengths of the variant
  Threads threads = {};                 ///< no result depends on them
};

/// The template's variant for `key`, with patterns of noise and detail of its own; with as_drawn the template itself,
/// or its folds repeated in turn, of the ripeness asked for.
Template variant_of(const Template& fruit, VariantKey key, const GrowOptions& options = {});

/// The same of a template that was made ready for many variants, never as drawn.
Template variant_of(const Variation& variation, VariantKey key, const GrowOptions& options = {});

/// A grown fruit at the stages of the road.
struct GrownFruit {
  DiffusionSurfaces swept;   ///< as drawn or varied: blur not split, no grains
  DiffusionSurfaces grains;  ///< blur not split
  DiffusionSurfaces sheets;  ///< everything the diffuser sees: blur split, grains included

  /// Of `swept`, where growing has made it already; else none.
  std::shared_ptr<const SkinDepth> skin = {};

  std::vector<Spot> raised = {};  ///< spots that stand out or are sunk (spots.h): pictures show it, no vertex does
};

/// Sweeps a variant, ripens its colours, splits its blur and scatters its grains.
GrownFruit grow(const Template& variant, VariantKey key, const GrowOptions& options = {});

}  // namespace pomona
