#include "generator/scene/scene_variants.h"

#include <optional>

#include "generator/base/random.h"

namespace pomona {

namespace {

/// A random value of the range, if there is a range.
std::optional<double> drawn_between(const std::optional<Within>& range, VariantKey key, const char* purpose) {
  if (!range) return {};
  return range->low + (range->high - range->low) * RandomStream(key, purpose).uniform(0);
}

}  // namespace

std::vector<std::shared_ptr<const Variation>> variations_of(const SceneDescription& scene,
                                                            const std::vector<Template>& templates,
                                                            const ComposeOptions& options) {
  std::vector<std::shared_ptr<const Variation>> ready(templates.size());
  for (std::size_t entry = 0; entry < ready.size(); ++entry) {
    if (scene.pieces[entry].as_drawn) continue;
    if (options.ready_template) {
      ready[entry] = options.ready_template(scene.pieces[entry].template_name).variation;
      continue;
    }
    for (std::size_t known = 0; known < entry && !ready[entry]; ++known) {
      if (scene.pieces[known].template_name == scene.pieces[entry].template_name) ready[entry] = ready[known];
    }
    if (!ready[entry]) ready[entry] = std::make_shared<Variation>(templates[entry]);
  }
  return ready;
}

VariantKey variant_key(const SceneDescription& scene, const PiecesDescription& pieces, int n) {
  const RandomStream names({0, static_cast<std::uint64_t>(n)}, "scene/pieces/" + pieces.name);
  return {scene.seed, names.bits(0) >> 32};
}

GrownSceneVariant grown_variant(const SceneDescription& scene, const PiecesDescription& pieces, int number,
                                const Template& fruit, const Variation* variation, const ComposeOptions& options) {
  GrownSceneVariant made;
  const VariantKey key = variant_key(scene, pieces, number);
  const GrowOptions how{.as_drawn = pieces.as_drawn,
                        .variation = pieces.variation * options.variation,
                        .curves_only = options.curves_only,
                        .folds = pieces.folds,
                        .detail = options.detail * pieces.detail,
                        .ripeness = drawn_between(pieces.ripeness, key, "scene/ripeness"),
                        .browning = drawn_between(pieces.browning, key, "scene/browning").value_or(0),
                        .scale = drawn_between(pieces.size, key, "scene/size").value_or(1)};
  made.variant = made.clock.time(
      "vary", [&] { return variation ? variant_of(*variation, key, how) : variant_of(fruit, key, how); });
  made.grown = made.clock.time("sweep", [&] { return grow(made.variant, key, how); });
  made.origin = {.source = source_word(pieces.template_name), .key = key, .growing = how, .entry = pieces.name};
  return made;
}

std::string variant_name(const PiecesDescription& pieces, int number) {
  return pieces.name + "-" + std::to_string(number + 1);
}

}  // namespace pomona
