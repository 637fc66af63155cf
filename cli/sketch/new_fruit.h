// Options and texts of a new fruit, for `sketch` and `studio`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/sketch/starting_sketch.h"
#include "render/export/output.h"

namespace pomona {

struct NewFruit {
  std::vector<std::string> pictures;  ///< pictures to draw over: the side view, then the top view
  std::string picture_above;          ///< picture of the top view alone
  std::optional<int> folds;

  bool is_told() const { return !pictures.empty() || !picture_above.empty() || folds.has_value(); }
};

/// Adds --picture, --picture-above and --folds.
/// \returns the last of them, which others may exclude.
CLI::Option* add_new_fruit_options(CLI::App& command, NewFruit& fruit);

struct BegunFruit {
  StartingSketch texts;
  std::vector<OutputFile> pictures;  ///< copies beside the template of pictures that lie elsewhere
};

/// \param toml path of the new template.
/// \throws Error (usage) for more than two pictures, (input_missing), (bad_data) for a file that is no PNG,
/// (cannot_create) if another file of a picture's name lies in the folder.
BegunFruit begun(const std::filesystem::path& toml, const NewFruit& fruit);

}  // namespace pomona
