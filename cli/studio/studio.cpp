// pomona studio: draw a fruit in the browser, and see it cut.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver/outputs.h"
#include "cli/options/file_kind.h"
#include "cli/options/find_template.h"
#include "cli/options/program_folders.h"
#include "cli/sketch/copy_beside.h"
#include "cli/sketch/new_fruit.h"
#include "cli/studio/only_studio.h"
#include "cli/studio/studio_api.h"
#include "cli/studio/studio_page.h"
#include "generator/base/error.h"
#include "generator/base/free_memory.h"
#include "generator/base/parallel.h"
#include "generator/base/small_ending.h"
#include "generator/template/read/read_template.h"
#include "generator/text/toml_text.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

struct StudioCommand {
  std::string fruit;
  NewFruit starting;
};

/// What the studio opens: existing files, or texts for new files.
struct Opened {
  WorkspaceFiles files;
  std::optional<FruitTexts> starting;
  std::vector<OutputFile> beside;  ///< files that these texts read and that do not exist yet
};

Opened new_fruit(const fs::path& toml, const StudioCommand& command) {
  check_folder(toml);
  BegunFruit made = begun(toml, command.starting);
  return {workspace_files(toml, made.texts.toml), FruitTexts{std::move(made.texts.toml), std::move(made.texts.svg)},
          std::move(made.pictures)};
}

/// The text of a template. \throws Error (bad_data) for a file of another kind
std::string template_text(const fs::path& file) {
  if (small_ending(file) == ".ply")
    throw Error(ExitStatus::bad_data, {{{file.string(), 0, 0, {}},
                                        "holds surfaces, and no curves that could be drawn",
                                        "the studio opens templates (.toml)"}});
  check_kind(file, FileKind::fruit);
  return read_toml_text(file);
}

/// The template's meshes, which the studio does not hold as text, with their paths in `folder`.
std::vector<OutputFile> meshes_for_copy(const fs::path& original, const fs::path& folder) {
  std::vector<OutputFile> copies;
  for (const MeshSketch& mesh : read_template(original).meshes) {
    const fs::path step = fs::path(mesh.file->path).lexically_relative(original.parent_path());
    if (auto copy = copy_beside(folder / step, mesh.file->bytes, "the mesh of " + original.string(),
                                "rename it, or open the studio in another folder"))
      copies.push_back(std::move(*copy));
  }
  return copies;
}

/// The templates that it places, and what these place, with their paths in `folder`.
std::vector<OutputFile> placed_for_copy(const Template& fruit, const fs::path& home, const fs::path& folder) {
  std::vector<OutputFile> copies;
  for (const PlaceSketch& place : fruit.places) {
    const fs::path file = place.placed->file, step = file.lexically_relative(home);
    if (auto copy = copy_beside(folder / step, read_toml_text(file), "the template placed in " + fruit.file,
                                "rename it, or open the studio in another folder"))
      copies.push_back(std::move(*copy));
    for (OutputFile& more : placed_for_copy(*place.placed, home, folder)) copies.push_back(std::move(more));
  }
  return copies;
}

/// Opens a copy of one of the program's own fruits: saving writes it into the current folder.
Opened copy_of(const fs::path& original) {
  const std::string toml = template_text(original);
  const Workspace texts(workspace_files(original, toml), {});
  const fs::path here = original.filename();
  std::vector<OutputFile> beside = meshes_for_copy(original, {});
  for (OutputFile& more : placed_for_copy(read_template(original), original.parent_path(), {}))
    beside.push_back(std::move(more));
  return {workspace_files(here, toml), Workspace(texts.files(), {}).state().texts, std::move(beside)};
}

Opened opened(const StudioCommand& command) {
  const fs::path file = command.fruit;
  const bool is_path = small_ending(file) == ".toml" || file.has_parent_path();
  if (is_path && !fs::exists(file)) return new_fruit(file, command);
  if (command.starting.is_told())
    throw Error(ExitStatus::usage, "--picture and --folds are for a fruit that is not there yet",
                "choose another name, or leave them out");
  if (is_path) return {workspace_files(file, template_text(file)), {}, {}};
  const fs::path own = file.string() + ".toml";
  if (fs::exists(own)) return {workspace_files(own, template_text(own)), {}, {}};
  return copy_of(find_template(command.fruit));
}

ExitStatus open_studio(const StudioCommand& command) {
  share_heaps(resolved(Threads{}) + 1);  // one for each computing thread, one for requests in the meantime
  Opened fruit = opened(command);
  const OnlyStudio only(fruit.files.toml);
  write_whole(fruit.beside);
  Workspace workspace(fruit.files, std::move(fruit.starting));
  const std::string token = random_token();
  StudioPage page = studio_page(fruit.files.toml.stem().string(), token, random_token());
  StudioApi api(workspace, std::move(page.html));
  LoopbackServer server({.token = token, .page_policy = page.policy},
                        [&](const WebRequest& request) { return api.answer(request); });
  std::printf("http://127.0.0.1:%d/?token=%s\n", server.port(), token.c_str());
  std::fflush(stdout);
  std::fprintf(stderr,
               "open this address in a browser; Ctrl-C ends the studio, and edits that are not saved are kept\n");
  server.serve();
  return ExitStatus::done;
}

}  // namespace

DeclaredCommand studio_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("studio", "Draw a fruit in the browser, and see it cut");
  const auto options = std::make_shared<StudioCommand>();
  command
      ->add_option(
          "TEMPLATE", options->fruit,
          "A template file, one that is not there yet, or a name from `pomona list`, of which a copy is drawn on")
      ->required();
  add_new_fruit_options(*command, options->starting);
  return {command, [options] { return open_studio(*options); }};
}

}  // namespace pomona
