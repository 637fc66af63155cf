// pomona list: templates, scenes, batches and styles.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
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

/// \param title_of nothing where the file is not of the wanted kind.
ExitStatus list_scene_files(bool json, std::optional<std::string> (*title_of)(const std::filesystem::path& file)) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& file : own_files("scenes")) {
    const std::optional<std::string> title = title_of(file);
    if (!title) continue;
    const std::string name = file.stem().string();
    all.push_back({{"name", name}, {"title", *title}});
    if (!json) print_row({name, *title});
  }
  if (json) std::printf("%s\n", json_text(all, 2).c_str());
  return ExitStatus::done;
}

std::optional<std::string> title_of_scene(const std::filesystem::path& file) {
  if (!is_scene_file(file)) return {};
  return read_scene(file).title;
}

std::optional<std::string> title_of_batch(const std::filesystem::path& file) {
  if (!is_batch_file(file)) return {};
  return read_batch(file).title;
}

std::optional<std::string> title_of_data_set(const std::filesystem::path& file) {
  if (!is_data_file(file)) return {};
  return read_data(file).title;
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
  CLI::App* command = app.add_subcommand(
      "list", "Print the templates: name, symmetry, parts; or the scenes, batches, data sets or styles");
  const auto json = std::make_shared<bool>(false);
  const auto scenes = std::make_shared<bool>(false);
  const auto styles = std::make_shared<bool>(false);
  const auto batches = std::make_shared<bool>(false);
  const auto data_sets = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print them as JSON");
  CLI::Option* asks_for_scenes = command->add_flag("--scenes", *scenes, "Print the scenes instead: name, title");
  CLI::Option* asks_for_styles = command->add_flag("--styles", *styles, "Print the styles instead: name, title");
  CLI::Option* asks_for_batches = command->add_flag("--batches", *batches, "Print the batches instead: name, title");
  CLI::Option* asks_for_data_sets =
      command->add_flag("--data-sets", *data_sets, "Print the data sets instead: name, title");
  asks_for_styles->excludes(asks_for_scenes);
  asks_for_batches->excludes(asks_for_scenes)->excludes(asks_for_styles);
  asks_for_data_sets->excludes(asks_for_scenes)->excludes(asks_for_styles)->excludes(asks_for_batches);
  return {command, [json, scenes, styles, batches, data_sets] {
            if (*scenes) return list_scene_files(*json, title_of_scene);
            if (*batches) return list_scene_files(*json, title_of_batch);
            if (*data_sets) return list_scene_files(*json, title_of_data_set);
            return *styles ? list_styles(*json) : list_templates(*json);
          }};
}

}  // namespace pomona
