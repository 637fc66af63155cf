// pomona grow: one whole fruit.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver.h"
#include "cli/fruit_source.h"
#include "cli/live_fruit.h"
#include "cli/outputs.h"
#include "generator/piece/glass_surfaces.h"
#include "generator/piece/slice.h"
#include "generator/surface/file/surface_file.h"

namespace pomona {

namespace {

struct GrowCommand {
  std::string fruit;
  std::vector<std::string> outputs;
  std::optional<int> folds;
  bool sheets = false;
  bool surfaces = false;
  SharedOptions shared;
};

/// The shells of the fruit, cavity walls included, with nothing inside; or all its surfaces as glass.
std::vector<Solid> whole_fruit(const FruitSource& source, bool as_glass, Delivery& delivery) {
  if (as_glass) return glass_surfaces(source.grown, source.fruit, source.name);
  Slices whole = slice({source.grown, source.fruit, {}, source.name}, nullptr);
  delivery.times.add(whole.times);
  delivery.warn(whole.warnings);
  return std::move(whole.pieces);
}

ExitStatus grow_fruit(const GrowCommand& command) {
  // Outputs that cannot be are refused before anything is grown.
  const std::vector<Output> outputs = parse_outputs(
      command.outputs, {Format::ply, Format::glb, Format::pov, Format::png, Format::svg, Format::html, Format::pomona});
  check_levels(command.shared.lod, outputs);
  Delivery delivery(command.shared);
  const FruitSource source = open_fruit(command.fruit, command.shared, command.folds, delivery.times);

  // The drawn surfaces go out as they are; all other outputs share one scene of the whole fruit.
  delivery.set_plate_text({source.fruit.title, source.fruit.latin});
  std::optional<Scene> scene;
  add_live(outputs, source, {}, command.shared, delivery);
  for (const Output& output : outputs) {
    if (is_live(output.format)) continue;
    if (output.format == Format::ply) {
      const DiffusionSurfaces& surfaces = command.sheets ? source.grown.sheets : source.grown.swept;
      delivery.add(output.file, [&] { return write_surfaces(surfaces); });
      continue;
    }
    if (!scene) {
      scene = gathered(whole_fruit(source, command.surfaces, delivery));
      scene->paper = delivery.style().paper;
    }
    delivery.add(output, *scene);
  }
  delivery.finish();
  return ExitStatus::done;
}

}  // namespace

DeclaredCommand grow_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("grow", "Grow one whole fruit");
  const auto options = std::make_shared<GrowCommand>();
  command->add_option("TEMPLATE", options->fruit, "A name from `pomona list`, a template file or a surface file (.ply)")
      ->required();
  command
      ->add_option("-o,--output", options->outputs,
                   "What to write: .ply (surfaces), .glb, .pov, .png, .svg, .html or .pomona")
      ->type_name("FILE")
      ->required()
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--folds", options->folds, "Another number of folds than drawn")->check(CLI::Range(1, 64));
  command->add_flag("--sheets", options->sheets, ".ply: everything the diffuser sees, blur split, grains included");
  command->add_flag("--surfaces", options->surfaces, ".glb, .pov, .png: all surfaces, seen through each other");
  add_ripeness_option(*command, options->shared);
  add_shared_options(*command, options->shared);
  return {command, [options] { return grow_fruit(*options); }};
}

}  // namespace pomona
