// pomona scene: a composition.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver.h"
#include "cli/diffusers.h"
#include "cli/file_kind.h"
#include "cli/find_template.h"
#include "cli/outputs.h"
#include "cli/program_folders.h"
#include "cli/scene_page.h"
#include "cli/version.h"
#include "cli/watch.h"
#include "generator/scene/compose.h"
#include "generator/scene/layout_file.h"
#include "generator/scene/scene_file.h"

namespace pomona {

namespace {

struct SceneCommand {
  std::string scene;
  std::vector<std::string> outputs;
  SharedOptions shared;
};

ComposeOptions compose_options(const SharedOptions& shared, Progress& progress) {
  ComposeOptions options;
  options.find_template = find_template;
  options.variation = shared.variation;
  options.curves_only = shared.curves_only;
  options.detail = shared.detail;
  options.threads = {shared.threads};
  options.keep_section_colors = wants_textures(shared);
  options.progress = [&progress](const std::string& stage, std::size_t done, std::size_t total) {
    progress.report(stage, done, total);
  };
  return options;
}

/// A path starts at the scene's folder.
std::string style_of(const SceneDescription& scene, const std::filesystem::path& file) {
  return scene.style.ends_with(".toml") ? (file.parent_path() / scene.style).string() : scene.style;
}

ExitStatus compose_scene(const SceneCommand& command) {
  // Outputs that cannot be are refused before anything is composed.
  const std::vector<Output> outputs = parse_outputs(command.outputs,
                                                    {Format::ply, Format::glb, Format::usda, Format::obj, Format::stl,
                                                     Format::pov, Format::png, Format::svg, Format::json, Format::html},
                                                    command.shared.format);
  check_exports(command.shared, outputs);
  check_picture_size(command.shared, outputs);
  check_aov(command.shared.aov, outputs);
  check_other_files(command.shared, outputs);
  Delivery delivery(command.shared);
  delivery.set_outputs(outputs);
  delivery.warn(idle_options(command.shared, outputs));
  const std::unique_ptr<Diffuser> diffuser = make_diffuser(command.shared, delivery.progress);
  delivery.times.diffused_by(diffuser->name(), diffuser->device());

  // The scene says what the command leaves open: seed, size and style.
  const std::filesystem::path file = find_file("scenes", command.scene);
  check_kind(file, FileKind::scene);
  SceneDescription description = delivery.times.time("read", [&] { return read_scene(file); });
  if (command.shared.seed_given) description.seed = command.shared.seed;
  delivery.set_seed(description.seed);
  delivery.set_default_size({description.width, description.height});
  if (!description.style.empty()) delivery.set_default_style(style_of(description, file));
  ComposeOptions how = compose_options(command.shared, delivery.progress);
  how.take = delivery.taker();
  Composition composition = compose(description, diffuser.get(), how);
  if (!description.paper) composition.scene.paper = delivery.style().paper;

  // The composition's figures go into --stats; its layout, or itself, into the outputs.
  for (const auto& [stage, milliseconds] : composition.report.stages) delivery.times.add(stage, milliseconds);
  for (const auto& [what, number] : composition.report.counts) delivery.times.count(what, number);
  delivery.warn(composition.report.warnings);

  for (const Output& output : outputs) {
    if (output.format == Format::json) {
      delivery.add(output.file, [&] { return write_layout(composition.scene); });
    } else if (output.format == Format::html) {
      const PageScene page = scene_for_page(description, composition.scene, command.shared, delivery);
      const std::string made_by = std::string("pomona ") + version + ", seed " + std::to_string(description.seed);
      delivery.add(output.file, [&] { return write_scene_page(page, {delivery.style(), {}, made_by}); });
    } else {
      delivery.add(output, composition.scene);
    }
  }
  delivery.finish();
  return ExitStatus::done;
}

/// What it reads by the words of the line.
std::vector<std::string> read_by(const SceneCommand& command) { return {command.scene, command.shared.style}; }

}  // namespace

DeclaredCommand scene_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("scene", "Compose a scene: many cut variants, settled");
  const auto options = std::make_shared<SceneCommand>();
  command->add_option("SCENE", options->scene, "A name from `pomona list --scenes`, or a scene file (.toml)")
      ->required();
  add_output_option(
      *command, options->outputs,
      "What to write: .glb, .usda, .pov, .png, .svg, .ply, .obj, .stl, .html (a page), or .json (the layout)");
  add_shared_options(*command, options->shared);
  add_watch_option(*command, options->shared);
  return {command, [options] {
            return made_or_watched(options->shared, options->outputs, read_by(*options),
                                   [&] { return compose_scene(*options); });
          }};
}

}  // namespace pomona
