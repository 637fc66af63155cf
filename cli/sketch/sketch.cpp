// pomona sketch: an SVG and a template to start from, and colours from the picture under a sketch.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver/outputs.h"
#include "cli/options/find_template.h"
#include "cli/options/program_folders.h"
#include "cli/sketch/copied_fruit.h"
#include "cli/sketch/copy_beside.h"
#include "cli/sketch/new_fruit.h"
#include "cli/sketch/sample_colors.h"
#include "generator/base/file_bytes.h"
#include "generator/template/read/read_example.h"
#include "generator/template/read/read_template.h"
#include "render/export/output.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

struct SketchCommand {
  std::string file;
  NewFruit fruit;
  std::string like;
  bool cylindrical = false;
  bool sample = false;
  bool force = false;
  bool quiet = false;
};

void say(const SketchCommand& command, const std::string& line) {
  if (!command.quiet) std::fprintf(stderr, "%s\n", line.c_str());
}

ExitStatus sample(const SketchCommand& command) {
  if (command.fruit.is_told() || !command.like.empty() || command.cylindrical || command.force) {
    throw Error(ExitStatus::usage, "--sample goes with no other option",
                "it takes colours for a template that is there already");
  }
  const fs::path file = existing_file(command.file);
  const SampledTemplate sampled = sample_colors(file);
  write_whole(file, sampled.toml);
  say(command, "took " + std::to_string(sampled.ramps) + (sampled.ramps == 1 ? " ramp" : " ramps") +
                   " of colours into " + file.string());
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
  if (!command.like.empty() && command.fruit.is_told()) {
    throw Error(ExitStatus::usage, "--like goes with no picture and no folds", "a copy has those of the original");
  }

  // Both files must be possible before either is made.
  const fs::path toml = command.file, svg = fs::path(toml).replace_extension(".svg");
  check_folder(toml);
  check_folder(svg);
  if (!command.force) {
    refuse_existing(toml);
    refuse_existing(svg);
  }

  // The drawing, the template and the pictures beside them appear together, or none does.
  BegunFruit made = command.like.empty() ? begun(toml, command.fruit)
                                         : BegunFruit{copied_fruit(find_template(command.like), fruit_name(toml)), {}};
  std::vector<OutputFile> files = std::move(made.pictures);
  for (const fs::path& example : made.texts.examples) {
    if (auto copy = copy_beside(toml.parent_path() / example.filename(), file_bytes(example, max_example_bytes),
                                example.string(), "rename one of the two: examples are copied beside the template"))
      files.push_back(std::move(*copy));
  }
  for (const OutputFile& copy : files) say(command, "copied " + copy.path.string());
  const bool is_drawn = !made.texts.svg.empty();
  if (is_drawn) files.push_back({svg, std::move(made.texts.svg)});
  files.push_back({toml, std::move(made.texts.toml)});
  write_whole(files);
  say(command, "wrote " + (is_drawn ? svg.string() + " and " : std::string()) + toml.string());
  say(command, (is_drawn ? "draw in " + svg.string() + " (inkscape)" : "change its curves and colours") +
                   ", then: pomona check " + toml.string());
  return ExitStatus::done;
}

}  // namespace

DeclaredCommand sketch_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("sketch", "Start a fruit: an SVG to draw in, and its template");
  const auto options = std::make_shared<SketchCommand>();
  command->add_option("FILE", options->file, "The template to write; its SVG comes to lie beside it")->required();
  CLI::Option* like =
      command->add_option("--like", options->like, "Begin with a copy of this template instead of a made-up fruit")
          ->type_name("NAME");
  CLI::Option* folds = add_new_fruit_options(*command, options->fruit);
  command->add_flag("--cylindrical", options->cylindrical, "The fruit looks the same from all sides (the default)")
      ->excludes(folds)
      ->excludes(like);
  command->add_flag("--sample", options->sample, "Take the colours of FILE, which is there, from the picture anew");
  command->add_flag("--force", options->force, "Write over what is there");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return options->sample ? sample(*options) : start(*options); }};
}

}  // namespace pomona
