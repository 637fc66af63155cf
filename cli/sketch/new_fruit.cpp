#include "cli/sketch/new_fruit.h"

#include <utility>

#include "cli/options/option_checks.h"
#include "cli/options/program_folders.h"
#include "cli/sketch/copy_beside.h"
#include "cli/sketch/picture_file.h"
#include "generator/base/error.h"
#include "generator/base/path_within.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

/// The picture in the folder or below, and its copy if it lies elsewhere.
SketchPicture picture_beside(const std::string& name, const fs::path& folder, std::vector<OutputFile>& copies) {
  const fs::path picture = existing_file(name);
  const std::string bytes = picture_bytes(picture, picture.string());
  const std::optional<fs::path> step = path_within(folder, picture);
  const LinkedPicture linked = linked_picture(step.value_or(picture.filename()), bytes, picture.string());
  if (step) return {linked.href, linked.size};

  if (auto copy = copy_beside(folder / picture.filename(), bytes, picture.string(),
                              "rename one of the two: pictures are copied beside the template"))
    copies.push_back(std::move(*copy));
  return {linked.href, linked.size};
}

}  // namespace

CLI::Option* add_new_fruit_options(CLI::App& command, NewFruit& fruit) {
  CLI::Option* pictures =
      command
          .add_option(
              "--picture", fruit.pictures,
              "Of a new fruit: a picture (.png) to draw over, for the side view; a second time for the top view")
          ->type_name("FILE")
          ->expected(1)
          ->allow_extra_args(false)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--picture-above", fruit.picture_above, "Of a new fruit: a picture for the top view alone")
      ->type_name("FILE")
      ->excludes(pictures);
  return command.add_option("--folds", fruit.folds, "Of a new fruit: it repeats itself so often")
      ->check(whole_between(1, 64));
}

BegunFruit begun(const fs::path& toml, const NewFruit& fruit) {
  if (fruit.pictures.size() > 2)
    throw Error(ExitStatus::usage, "--picture: there are two views, so two pictures are the most");
  BegunFruit begun;
  StartingSketchOptions options;
  options.name = fruit_name(toml);
  options.folds = fruit.folds;
  const auto beside = [&](const std::string& name) { return picture_beside(name, toml.parent_path(), begun.pictures); };
  if (!fruit.pictures.empty()) options.side = beside(fruit.pictures.front());
  if (fruit.pictures.size() > 1) options.top = beside(fruit.pictures.back());
  if (!fruit.picture_above.empty()) options.top = beside(fruit.picture_above);
  begun.texts = starting_sketch(options);
  return begun;
}

}  // namespace pomona
