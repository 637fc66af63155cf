// pomona scene: a composition.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver/command_report.h"
#include "cli/deliver/watch.h"
#include "cli/options/check_order.h"
#include "cli/options/file_kind.h"
#include "cli/options/find_style.h"
#include "cli/options/find_template.h"
#include "cli/options/order_options.h"
#include "cli/options/program_folders.h"
#include "cli/options/scene_order.h"
#include "cli/options/written_formats.h"
#include "generator/scene/compose.h"
#include "generator/scene/scene_file.h"
#include "render/deliver/deliver.h"
#include "render/deliver/ordered_diffuser.h"
#include "render/deliver/scene_page_files.h"

namespace pomona {

namespace {

struct SceneCommand {
  std::string scene;
  TypedOrder typed;
  Telling telling;
};

/// Adds the measurements to --stats.
void tell(const ComposeReport& composed, CommandReport& report) {
  for (const auto& [stage, milliseconds] : composed.stages) report.times.add(stage, milliseconds);
  for (const auto& [what, number] : composed.counts) report.times.count(what, number);
  report.warn(composed.warnings);
}

ExitStatus compose_scene(const SceneCommand& command) {
  // Refuse impossible outputs before anything is composed.
  const Order typed = read_order(command.typed, formats_of(OrderTaker::scene));
  check_order(typed, OrderTaker::scene, command.telling);
  CommandReport report(command.telling);
  report.warn(idle_options(typed, OrderTaker::scene));
  const std::unique_ptr<Diffuser> diffuser = ordered_diffuser(typed, report.told_progress());
  report.times.diffused_by(diffuser->name(), diffuser->device());

  const std::filesystem::path file = find_file("scenes", command.scene);
  check_kind(file, FileKind::scene);
  SceneDescription description = report.times.time("read", [&] { return read_scene(file); });
  const Order order = completed(typed, description);
  description.seed = *order.fruit.seed;
  const DeliverOptions how{.style = find_style(drawn_style(order.color)),
                           .texture_style = find_style(baked_style(order.color)),
                           .provenance = provenance_of(order.fruit),
                           .usual_size = {description.width, description.height},
                           .progress = report.told_progress()};

  // A .glb takes the solids as they are made, unless another output needs all of them at once.
  const auto streams = streams_of(order, how);
  ComposeOptions composing = compose_options(order, how.progress);
  if (!streams.empty()) {
    composing.take = [&](std::span<const Solid> solids) {
      for (const std::unique_ptr<StreamedGlb>& stream : streams) stream->take(solids);
    };
  }
  Composition composition = compose(description, diffuser.get(), composing);
  if (!description.paper) composition.scene.paper = how.style.paper;
  tell(composition.report, report);
  report.add(files({.placed = composition.scene, .streams = streams}, order, how));
  report.add(scene_page_files(description, composition.scene, order, how, find_template));
  write_files(report, order, command.telling);
  return ExitStatus::done;
}

/// The files that the command reads.
std::vector<std::string> read_by(const SceneCommand& command) {
  std::vector<std::string> words = command.typed.texts_of("style");
  words.push_back(command.scene);
  return words;
}

}  // namespace

DeclaredCommand scene_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("scene", "Compose a scene: many cut variants, settled");
  const auto options = std::make_shared<SceneCommand>();
  command->add_option("SCENE", options->scene, "A name from `pomona list --scenes`, or a scene file (.toml)")
      ->required();
  add_order_options(*command, OrderTaker::scene,
                    "What to write: .glb, .usda, .pov, .png, .svg, .ply, .obj, .stl, .html (a page), .xml (MuJoCo), "
                    ".urdf, or .json (the "
                    "layout)",
                    options->typed);
  add_telling_options(*command, options->telling);
  return {command, [options] {
            return made_or_watched(options->telling, options->typed.outputs, read_by(*options),
                                   [&] { return compose_scene(*options); });
          }};
}

}  // namespace pomona
