// pomona grow: one whole fruit.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver.h"
#include "cli/family.h"
#include "cli/fruit_source.h"
#include "cli/live_fruit.h"
#include "cli/option_checks.h"
#include "cli/outputs.h"
#include "cli/ripeness_variants.h"
#include "cli/watch.h"
#include "generator/base/error.h"
#include "generator/piece/glass_surfaces.h"
#include "generator/piece/slice.h"
#include "generator/scene/stand.h"
#include "generator/surface/file/surface_file.h"
#include "render/page/page.h"

namespace pomona {

namespace {

struct GrowCommand {
  std::string fruit;
  std::vector<std::string> outputs;
  std::optional<int> folds;
  bool sheets = false;
  bool surfaces = false;
  int piece = 0;
  std::string seeds;
  bool cuttable = false;
  SharedOptions shared;
};

/// The shells of the fruit, cavity walls included, with nothing inside; or all its surfaces as glass.
std::vector<Solid> whole_fruit(const FruitSource& source, const GrowCommand& command, Delivery& delivery) {
  if (command.surfaces) return glass_surfaces(source.grown, source.fruit, source.name);
  Slices whole = sliced(source, slice_task(source, {}, command.piece), nullptr);
  check_piece(command.piece, whole);
  delivery.times.add(whole.times);
  delivery.warn(whole.warnings);
  return std::move(whole.pieces);
}

/// One whole fruit of each seed, side by side; on a page all are cut by the same knives.
ExitStatus grow_family(const GrowCommand& command, const std::vector<Output>& outputs, Delivery& delivery) {
  check_family(command.shared, outputs);
  std::vector<FruitSource> sources;
  for (const SharedOptions& one : each_seed(command.seeds, command.shared)) {
    sources.push_back(open_fruit(command.fruit, one, command.folds, delivery.times));
  }
  add_live(outputs, sources.front(), {}, command.shared, delivery, std::span(sources).subspan(1));
  if (!all_live(outputs)) {
    std::vector<Solid> solids;
    for (const FruitSource& source : sources) {
      std::vector<Solid> own = named_by_seed(whole_fruit(source, command, delivery), source.origin.key.seed);
      solids.insert(solids.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
    }
    add_row(std::move(solids), outputs, delivery);
  }
  delivery.finish();
  return ExitStatus::done;
}

ExitStatus grow_fruit(const GrowCommand& command) {
  // Outputs that cannot be are refused before anything is grown.
  const std::vector<Output> outputs =
      parse_outputs(command.outputs,
                    {Format::ply, Format::glb, Format::usda, Format::obj, Format::stl, Format::pov, Format::png,
                     Format::svg, Format::html, Format::pomona},
                    command.shared.format);
  check_exports(command.shared, outputs);
  check_picture_size(command.shared, outputs);
  check_aov(command.shared.aov, outputs);
  if (command.surfaces && !command.shared.aov.empty()) {
    throw Error(ExitStatus::usage, "--aov: what one sees through has no one surface at a pixel",
                "leave out --surfaces");
  }
  if (command.cuttable) {
    check_heeded("--cuttable", {Format::glb}, outputs);
    if (wants_textures(command.shared) || command.shared.lod > 0 || command.surfaces || command.piece > 0 ||
        !command.seeds.empty())
      throw Error(ExitStatus::usage, "--cuttable: the file holds the whole fruit, its colours at its vertices",
                  "leave out --texture, --texel, --lod, --surfaces, --piece and --seeds");
  }
  check_other_files(command.shared, outputs);
  Delivery delivery(command.shared);
  delivery.set_outputs(outputs);
  delivery.warn(idle_options(command.shared, outputs));
  delivery.warn(idle_variant_options(command.shared, command.seeds));
  const auto is_surfaces = [](const Output& output) { return output.format == Format::ply; };
  if (command.sheets && std::none_of(outputs.begin(), outputs.end(), is_surfaces))
    delivery.warn({"--sheets is about .ply: no output is one"});
  if (command.surfaces && std::all_of(outputs.begin(), outputs.end(), [&](const Output& output) {
        return is_surfaces(output) || is_live(output.format);
      }))
    delivery.warn({"--surfaces is about meshes and pictures: no output is one"});
  if (!command.seeds.empty()) return grow_family(command, outputs, delivery);
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
      std::vector<Solid> solids = whole_fruit(source, command, delivery);
      delivery.set_variants(
          ripeness_variants(solids, source, command.fruit, command.shared, command.folds, nullptr, delivery.times));
      scene = gathered(std::move(solids));
      scene->paper = delivery.style().paper;
    }
    if (command.cuttable && output.format == Format::glb) {
      add_cuttable(output, *scene, source, command.shared, delivery);
      continue;
    }
    // In a picture it stands on the table, unless one is to see through it.
    const bool is_picture = output.format == Format::png || output.format == Format::svg;
    delivery.add(output, is_picture && !command.surfaces ? standing(*scene) : *scene);
  }
  delivery.finish();
  return ExitStatus::done;
}

/// What it reads by the words of the line.
std::vector<std::string> read_by(const GrowCommand& command) { return {command.fruit, command.shared.style}; }

}  // namespace

DeclaredCommand grow_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("grow", "Grow one whole fruit");
  const auto options = std::make_shared<GrowCommand>();
  command->add_option("TEMPLATE", options->fruit, "A name from `pomona list`, a template file or a surface file (.ply)")
      ->required();
  add_output_option(
      *command, options->outputs,
      "What to write: .ply (surfaces), .glb, .usda, .obj, .stl, .pov, .png, .svg, .html or .pomona; - is standard "
      "output");
  command->add_option("--folds", options->folds, "Another number of folds than drawn")->check(whole_between(1, 64));
  command->add_flag("--sheets", options->sheets, ".ply: everything the diffuser sees, blur split, grains included");
  command->add_flag("--surfaces", options->surfaces, "Meshes and pictures: all surfaces, seen through each other");
  command->add_option("--piece", options->piece, "Of a fruit in several bodies, this one alone")
      ->check(whole_between(1, 1000000));
  command->add_flag("--cuttable", options->cuttable,
                    ".glb: carries the fruit's asset as well, for programs that cut it");
  add_index_options(*command, options->shared);
  add_ripeness_option(*command, options->shared);
  add_ripeness_variants_option(*command, options->shared);
  add_shared_options(*command, options->shared);
  add_seeds_option(*command, options->seeds);
  add_watch_option(*command, options->shared);
  return {command, [options] {
            return made_or_watched(options->shared, options->outputs, read_by(*options),
                                   [&] { return grow_fruit(*options); });
          }};
}

}  // namespace pomona
