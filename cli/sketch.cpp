// pomona sketch: an SVG and a template to start from, and colours from the picture under a sketch.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/option_checks.h"
#include "cli/outputs.h"
#include "cli/picture_file.h"
#include "cli/program_folders.h"
#include "cli/sample_colors.h"
#include "cli/starting_sketch.h"
#include "generator/template/read/read_template.h"
#include "render/export/output.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

struct SketchCommand {
  std::string file;
  std::vector<std::string> pictures;
  std::optional<int> folds;
  bool cylindrical = false;
  bool sample = false;
  bool force = false;
  bool quiet = false;
};

void say(const SketchCommand& command, const std::string& line) {
  if (!command.quiet) std::fprintf(stderr, "%s\n", line.c_str());
}

ExitStatus sample(const SketchCommand& command) {
  if (!command.pictures.empty() || command.folds || command.cylindrical || command.force) {
    throw Error(ExitStatus::usage, "--sample goes with no other option",
                "it takes colours for a template that is there already");
  }
  const fs::path file = existing_file(command.file);
  const SampledTemplate sampled = sample_colors(file);
  write_whole(file, sampled.toml);
  say(command, "took " + std::to_string(sampled.ramps) + " ramps of colours into " + file.string());
  return ExitStatus::done;
}

void refuse_existing(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(file, ignored))) return;
  throw Error(
      ExitStatus::cannot_create,
      {{{file.string(), 0, 0, {}}, "it is there already", "choose another name, or write over it with --force"}});
}

ExitStatus start(const SketchCommand& command) {
  // Both files must be possible before either is made.
  const fs::path toml = command.file, svg = fs::path(toml).replace_extension(".svg");
  StartingSketchOptions options;
  options.name = fruit_name(toml);
  options.folds = command.folds;
  check_folder(toml);
  check_folder(svg);
  if (!command.force) {
    refuse_existing(toml);
    refuse_existing(svg);
  }

  // Pictures are linked to, by their path from the sketch's folder.
  if (command.pictures.size() > 2) {
    throw Error(ExitStatus::usage, "--picture: there are two views, so two pictures are the most");
  }
  for (const std::string& name : command.pictures) {
    const LinkedPicture linked = linked_picture(existing_file(name), toml.parent_path());
    options.pictures.push_back({linked.href, linked.size});
  }

  // The drawing and the template appear together, or neither does.
  StartingSketch made = starting_sketch(options);
  const std::vector<OutputFile> files = {{svg, std::move(made.svg)}, {toml, std::move(made.toml)}};
  write_whole(files);
  say(command, "wrote " + svg.string() + " and " + toml.string());
  say(command, "draw in " + svg.string() + " (inkscape), then: pomona check " + toml.string());
  return ExitStatus::done;
}

}  // namespace

DeclaredCommand sketch_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("sketch", "Start a fruit: an SVG to draw in, and its template");
  const auto options = std::make_shared<SketchCommand>();
  command->add_option("FILE", options->file, "The template to write; its SVG comes to lie beside it")->required();
  command
      ->add_option("--picture", options->pictures,
                   "A picture (.png) to draw over: once for the side view, a second time for the top view")
      ->type_name("FILE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* folds =
      command->add_option("--folds", options->folds, "The fruit repeats itself so often")->check(whole_between(1, 64));
  command->add_flag("--cylindrical", options->cylindrical, "The fruit looks the same from all sides (the default)")
      ->excludes(folds);
  command->add_flag("--sample", options->sample, "Take the colours of FILE, which is there, from the picture anew");
  command->add_flag("--force", options->force, "Write over what is there");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return options->sample ? sample(*options) : start(*options); }};
}

}  // namespace pomona
