// Grows the variants of a scene's fruits.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/base/random.h"
#include "generator/base/stage_clock.h"
#include "generator/compose/grow.h"
#include "generator/piece/piece_origin.h"
#include "generator/scene/compose_options.h"
#include "generator/scene/scene_file.h"
#include "generator/template/template.h"
#include "generator/variation/variation.h"

namespace pomona {

/// For each entry with variants, its prepared template; entries with the same template share it.
std::vector<std::shared_ptr<const Variation>> variations_of(const SceneDescription& scene,
                                                            const std::vector<Template>& templates,
                                                            const ComposeOptions& options);

/// A grown variant.
struct GrownSceneVariant {
  Template variant;
  GrownFruit grown;
  PieceOrigin origin;
  StageClock clock;
};

/// The key of an entry's n-th variant: the scene's seed, and an index drawn from the entry's name and n. So no
/// entry's variants depend on what else the scene holds, in which order, or how many it takes.
VariantKey variant_key(const SceneDescription& scene, const PiecesDescription& pieces, int n);

/// An entry's n-th variant. \param variation of the template; none for pieces as drawn.
GrownSceneVariant grown_variant(const SceneDescription& scene, const PiecesDescription& pieces, int number,
                                const Template& fruit, const Variation* variation, const ComposeOptions& options);

/// "tomato-wedges-3"
std::string variant_name(const PiecesDescription& pieces, int number);

}  // namespace pomona
