// pomona check: all errors of files that people write, and of those that these name, at once.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/batch/wanted_batch.h"
#include "cli/command.h"
#include "cli/data/wanted_data.h"
#include "cli/options/find_style.h"
#include "cli/options/find_template.h"
#include "cli/options/program_folders.h"
#include "cli/sketch/picture_file.h"
#include "generator/base/beside.h"
#include "generator/base/file_bytes.h"
#include "generator/base/json_text.h"
#include "generator/base/printable.h"
#include "generator/base/small_ending.h"
#include "generator/compose/grow.h"
#include "generator/data/data_file.h"
#include "generator/scene/layout_file.h"
#include "generator/scene/make_parts.h"
#include "generator/scene/scene_file.h"
#include "generator/surface/bodies.h"
#include "generator/surface/crossing_layers.h"
#include "generator/surface/file/plain_mesh_file.h"
#include "generator/surface/file/surface_file.h"
#include "generator/surface/grains/grains.h"
#include "generator/surface/stray_surfaces.h"
#include "generator/surface/sweep/spots.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/half_wall.h"
#include "generator/template/read/read_template.h"
#include "generator/template/read/sketch_fault.h"
#include "generator/text/svg_drawing.h"
#include "generator/text/svg_path.h"
#include "render/style/style_file.h"

namespace pomona {

namespace {

struct CheckCommand {
  std::vector<std::string> files;
  bool json = false;
  bool quiet = false;
};

/// Checks a drawing: whether it can be read, and its curves.
void check_drawing(const std::filesystem::path& file) {
  constexpr std::size_t max = std::size_t{64} << 20;
  try {
    const SvgDrawing drawing = parse_svg(file_bytes(file, max), file.string());
    const SvgElement* at = nullptr;
    try {
      for (const SvgElement& element : drawing.elements) {
        at = &element;
        if (element.d && element.fault.empty()) parse_svg_path(*element.d, {.transform = element.to_page});
      }
    } catch (const BadPath& bad) {
      throw Error(ExitStatus::bad_data, {{{file.string(), at->line, at->column, {}}, bad.what(), bad.hint}});
    }
  } catch (const BadSketch& bad) {
    throw Error(ExitStatus::bad_data, {placed_fault(bad, file.string())});
  }
}

/// Reads a file that templates, scenes or `compare` use; returns its notes, or nothing for other files.
std::optional<std::vector<std::string>> check_part(const std::filesystem::path& file) {
  const std::string ending = small_ending(file);
  if (ending == ".obj" || ending == ".glb") {
    return read_plain_mesh(file).notes;
  } else if (ending == ".json") {
    read_layout(file);
  } else if (ending == ".png") {
    read_picture(file);
  } else if (ending == ".svg") {
    check_drawing(file);
  } else {
    return {};
  }
  return std::vector<std::string>{};
}

/// Checks the style that a scene names, if any.
void check_style(const SceneDescription& scene) {
  if (scene.style.empty()) return;
  try {
    find_style(style_beside(scene.file, scene.style));
  } catch (const Error& error) {
    if (error.status() != ExitStatus::input_missing) throw;
    const Diagnostic& what = error.diagnostics().front();
    throw Error(error.status(),
                {{{scene.file, 1, 1, {}}, "style \"" + scene.style + "\": " + what.message, what.hint}});
  }
}

/// Warnings about surfaces that do not bound closed bodies.
std::vector<std::string> body_warnings(const DiffusionSurfaces& surfaces, const std::filesystem::path& file) {
  try {
    const Bodies bodies = find_bodies(surfaces);
    std::vector<std::string> warnings = bodies.warnings;
    for (std::string& warning : stray_warnings(surfaces, bodies)) warnings.push_back(std::move(warning));
    return warnings;
  } catch (const Error& error) {
    throw told_of(error, file.string());
  }
}

/// Reads the file by its kind; surfaces and swept templates are also checked for solid bodies.
std::vector<std::string> check_file(const std::filesystem::path& file) {
  if (small_ending(file) == ".ply") return body_warnings(read_surfaces(file), file);
  if (const std::optional<std::vector<std::string>> notes = check_part(file)) return *notes;
  if (small_ending(file) != ".toml") {
    throw Error(ExitStatus::bad_data, {{{file.string(), 1, 1, {}},
                                        "has no ending of a file that is read here",
                                        "these are .toml .ply .obj .glb .svg .png .json"}});
  }
  if (is_data_file(file)) {
    wanted_data(file);
    return {};
  }
  if (is_scene_file(file)) {
    const SceneDescription scene = read_scene(file);
    check_style(scene);
    ComposeOptions options;
    options.find_template = find_template;
    return check_sources(scene, options);
  }
  if (is_batch_file(file)) {
    const BatchPlan plan = wanted_batch(file);
    styles_of(plan);
    return batch_warnings(plan);
  }
  if (is_style_file(file)) {
    read_style(file);
    return {};
  }
  const Template fruit = read_template(file);
  const DiffusionSurfaces swept = sweep(fruit);
  std::vector<std::string> warnings =
      body_warnings(fruit.places.empty() ? swept : grow(fruit, {}, {.as_drawn = true}).swept, file);
  scatter_grains(fruit, {});
  for (const std::string& warning : spot_warnings(fruit)) warnings.push_back(warning);
  for (const std::string& warning : half_wall_warnings(fruit)) warnings.push_back(warning);
  for (const std::string& warning : crossing_layer_warnings(fruit, swept)) warnings.push_back(warning);
  return warnings;
}

nlohmann::ordered_json as_json(const Diagnostic& diagnostic, const char* severity) {
  return {{"severity", severity},
          {"file", diagnostic.place.file},
          {"line", diagnostic.place.line},
          {"column", diagnostic.place.column},
          {"element", diagnostic.place.element},
          {"message", diagnostic.message},
          {"hint", diagnostic.hint}};
}

ExitStatus check(const CheckCommand& command) {
  nlohmann::ordered_json found = nlohmann::ordered_json::array();
  ExitStatus status = ExitStatus::done;
  for (const std::string& name : command.files) {
    try {
      const std::filesystem::path file = find_any_file(name);
      for (const std::string& warning : check_file(file)) {
        Diagnostic diagnostic;
        diagnostic.place.file = file.string();
        diagnostic.message = warning;
        found.push_back(as_json(diagnostic, "warning"));
        if (!command.json && !command.quiet)
          std::fprintf(stderr, "%s\n", printable_line(file.string() + ": warning: " + warning).c_str());
      }
      if (!command.json && !command.quiet) std::printf("%s: ok\n", printable_line(name).c_str());
    } catch (const Error& error) {
      // Bad files take precedence over missing ones for the status.
      if (status != ExitStatus::bad_data) status = error.status();
      for (const Diagnostic& diagnostic : error.diagnostics()) {
        found.push_back(as_json(diagnostic, "error"));
        if (!command.json) std::fprintf(stderr, "%s\n", to_string(diagnostic).c_str());
      }
    }
  }
  if (command.json) std::printf("%s\n", json_text(found, 2).c_str());
  return status;
}

}  // namespace

DeclaredCommand check_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "check", "Check templates, scenes, batches, data sets, styles and surface files; all errors at once");
  const auto options = std::make_shared<CheckCommand>();
  command
      ->add_option("FILE", options->files,
                   "Templates, scenes, batches, data sets and styles, or their names from `pomona list`; surface files "
                   "(.ply), and what "
                   "these name: meshes (.obj, .glb), drawings (.svg), layouts (.json), pictures (.png)")
      ->required();
  command->add_flag("--json", options->json, "Print what was found as JSON");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return check(*options); }};
}

}  // namespace pomona
