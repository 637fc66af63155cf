// pomona list: templates, scenes, batches and styles.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/options/find_style.h"
#include "cli/options/find_template.h"
#include "cli/options/program_folders.h"
#include "generator/base/json_text.h"
#include "generator/base/printable.h"
#include "generator/batch/batch_file.h"
#include "generator/data/data_file.h"
#include "generator/scene/scene_file.h"
#include "generator/template/read/read_template.h"

namespace pomona {

namespace {

std::string symmetry_of(const Template& fruit) {
  if (std::holds_alternative<CylindricalSymmetry>(fruit.symmetry)) return "cylindrical";
  if (std::holds_alternative<NoSymmetry>(fruit.symmetry)) return "none";
  return std::to_string(fold_count(fruit)) + "-fold";
}

std::string joined_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

/// A line with tabs between its cells.
void print_row(const std::vector<std::string>& cells) {
  std::string row;
  for (const std::string& cell : cells) row += (row.empty() ? "" : "\t") + printable_line(cell);
  std::printf("%s\n", row.c_str());
}

ExitStatus list_styles(bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Style& style : all_known_styles()) {
    all.push_back({{"name", style.name}, {"title", style.title}});
    if (!json) print_row({style.name, style.title});
  }
  if (json) std::printf("%s\n", json_text(all, 2).c_str());
  return ExitStatus::done;
}

ExitStatus list_scenes(bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& file : own_files("scenes")) {
    if (is_batch_file(file) || is_data_file(file)) continue;
    const SceneDescription scene = read_scene(file);
    const std::string name = file.stem().string();
    all.push_back({{"name", name}, {"title", scene.title}});
    if (!json) print_row({name, scene.title});
  }
  if (json) std::printf("%s\n", json_text(all, 2).c_str());
  return ExitStatus::done;
}

ExitStatus list_batches(bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& file : own_files("scenes")) {
    if (!is_batch_file(file)) continue;
    const BatchDescription batch = read_batch(file);
    const std::string name = file.stem().string();
    all.push_back({{"name", name}, {"title", batch.title}});
    if (!json) print_row({name, batch.title});
  }
  if (json) std::printf("%s\n", json_text(all, 2).c_str());
  return ExitStatus::done;
}

ExitStatus list_templates(bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  std::vector<Diagnostic> wrong;
  std::vector<std::filesystem::path> files = all_templates();
  for (const std::filesystem::path& own : own_templates()) files.push_back(own);
  for (const auto& file : files) {
    try {
      const Template fruit = read_template(file);
      const std::string name = file.stem().string();
      all.push_back({{"name", name}, {"title", fruit.title}, {"symmetry", symmetry_of(fruit)}, {"parts", fruit.parts}});
      if (!json) print_row({name, symmetry_of(fruit), joined_names(fruit.parts)});
    } catch (const Error& error) {
      wrong.insert(wrong.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  }
  if (json) std::printf("%s\n", json_text(all, 2).c_str());
  if (!wrong.empty()) throw Error(ExitStatus::some_items_failed, wrong);
  return ExitStatus::done;
}

}  // namespace

DeclaredCommand list_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("list", "Print the templates: name, symmetry, parts; or the scenes, batches or styles");
  const auto json = std::make_shared<bool>(false);
  const auto scenes = std::make_shared<bool>(false);
  const auto styles = std::make_shared<bool>(false);
  const auto batches = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print them as JSON");
  CLI::Option* asks_for_scenes = command->add_flag("--scenes", *scenes, "Print the scenes instead: name, title");
  CLI::Option* asks_for_styles = command->add_flag("--styles", *styles, "Print the styles instead: name, title");
  CLI::Option* asks_for_batches = command->add_flag("--batches", *batches, "Print the batches instead: name, title");
  asks_for_styles->excludes(asks_for_scenes);
  asks_for_batches->excludes(asks_for_scenes)->excludes(asks_for_styles);
  return {command, [json, scenes, styles, batches] {
            if (*scenes) return list_scenes(*json);
            if (*batches) return list_batches(*json);
            return *styles ? list_styles(*json) : list_templates(*json);
          }};
}

}  // namespace pomona
