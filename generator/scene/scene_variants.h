// Grows the variants of a scene's fruits.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/base/stage_clock.h"
#include "generator/piece/grow.h"
#include "generator/piece/piece_origin.h"
#include "generator/scene/make_parts.h"
#include "generator/template/template.h"
#include "generator/variation/variation.h"

namespace pomona {

/// For each entry with variants, its prepared template; entries with the same template share it.
std::vector<std::shared_ptr<const Variation>> variations_of(const SceneDescription& scene,
                                                            const std::vector<Template>& templates);

/// A grown variant.
struct GrownSceneVariant {
  Template variant;
  GrownFruit grown;
  PieceOrigin origin;
  StageClock clock;
};

/// An entry's n-th variant. \param variation of the template; none for pieces as drawn.
GrownSceneVariant grown_variant(const SceneDescription& scene, const PiecesDescription& pieces, int number,
                                const Template& fruit, const Variation* variation, const ComposeOptions& options);

/// "tomato-wedges-3"
std::string variant_name(const PiecesDescription& pieces, int number);

}  // namespace pomona
