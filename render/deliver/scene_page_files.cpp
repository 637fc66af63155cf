#include "render/deliver/scene_page_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "generator/base/beside.h"
#include "generator/base/error.h"
#include "generator/template/read/read_template.h"
#include "render/page/make_asset.h"
#include "render/page/page_scene.h"

namespace pomona {

namespace {

using FindTemplate = std::function<std::filesystem::path(const std::string& name)>;

/// The template of an entry, found as in composing.
std::filesystem::path template_of(const SceneDescription& scene, const std::string& entry,
                                  const FindTemplate& find_template) {
  for (const PiecesDescription& pieces : scene.pieces) {
    if (pieces.name != entry) continue;
    const auto beside = found_beside(scene.file, pieces.template_name);
    return beside ? *beside : find_template(pieces.template_name);
  }
  throw Error(ExitStatus::bug, "no entry of the scene is called " + entry);
}

Asset grown_asset(const Template& fruit, const PieceOrigin& origin, Threads threads) {
  GrowOptions growing = origin.growing;
  growing.threads = threads;
  const Template variant = variant_of(fruit, origin.key, growing);
  const GrownFruit grown = grow(variant, origin.key, growing);
  return make_asset({grown, variant, origin.variant, origin.key.seed},
                    {.quality = Quality::draft, .diffuser = nullptr, .threads = threads});
}

/// One piece of each fruit, and the fruit of each solid; -1 for dishes.
struct FruitsOfScene {
  std::vector<const PieceOrigin*> origin;
  std::vector<int> of_solid;
};

FruitsOfScene fruits_of(const Scene& scene) {
  FruitsOfScene fruits;
  std::map<std::string, int> known;
  for (const Solid& solid : scene.solids) {
    if (solid.origin.source.empty() || solid.origin.variant.empty()) {
      fruits.of_solid.push_back(-1);
      continue;
    }
    const auto [at, is_new] = known.try_emplace(solid.origin.variant, static_cast<int>(fruits.origin.size()));
    if (is_new) fruits.origin.push_back(&solid.origin);
    fruits.of_solid.push_back(at->second);
  }
  return fruits;
}

PageScene page_scene(const SceneDescription& description, const Scene& scene, const Order& order,
                     const DeliveryProgress& progress, const FindTemplate& find_template, Delivered& delivered) {
  const FruitsOfScene fruits = fruits_of(scene);
  check_fits_a_page(scene, fruits.origin.size());
  PageScene page{.scene = scene,
                 .name = description.name,
                 .title = description.title.empty() ? description.name : description.title,
                 .fruits = {},
                 .fruit_of = {},
                 .command = {}};
  std::map<std::filesystem::path, Template> read;
  std::vector<int> number(fruits.origin.size(), -1);
  for (std::size_t k = 0; k < number.size(); ++k) {
    if (progress) progress("fruits", k, number.size());
    const PieceOrigin& origin = *fruits.origin[k];
    const std::filesystem::path file = template_of(description, origin.entry, find_template);
    if (!read.contains(file)) read.emplace(file, read_template(file));
    try {
      page.fruits.push_back(
          delivered.times.time("asset", [&] { return grown_asset(read.at(file), origin, order.threads); }));
      number[k] = static_cast<int>(page.fruits.size()) - 1;
    } catch (const Error& error) {
      if (error.status() != ExitStatus::bad_data) throw;
      delivered.warnings.push_back("pieces of " + origin.variant +
                                   " can be looked at in the page, not cut: " + error.diagnostics().front().message);
    }
  }
  for (std::size_t s = 0; s < scene.solids.size(); ++s) {
    const Solid& solid = scene.solids[s];
    page.fruit_of.push_back(fruits.of_solid[s] < 0 ? -1 : number[static_cast<std::size_t>(fruits.of_solid[s])]);
    page.command.push_back(fruits.of_solid[s] < 0 ? "" : command_for(solid.origin, solid.name + ".glb"));
  }
  return page;
}

}  // namespace

Delivered scene_page_files(const SceneDescription& description, const Scene& scene, const Order& order,
                           const DeliverOptions& how, const FindTemplate& find_template) {
  Delivered delivered;
  if (!any_is(order.outputs, {Format::html})) return delivered;
  const PageScene page = page_scene(description, scene, order, how.progress, find_template, delivered);
  for (const Output& output : order.outputs) {
    if (output.format == Format::html)
      delivered.add(output.file, [&] { return write_scene_page(page, {how.style, {}, made_by(how.provenance)}); });
  }
  return delivered;
}

}  // namespace pomona
