// A fruit that is not there yet: what `sketch` and `studio` are told of it, and what it begins with.
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
  std::vector<std::string> pictures;  ///< to draw over: of the side view, then of the top view
  std::string picture_above;          ///< that of the top view alone
  std::optional<int> folds;

  bool is_told() const { return !pictures.empty() || !picture_above.empty() || folds.has_value(); }
};

/// Adds --picture, --picture-above and --folds. \returns the last of them, which others may exclude.
CLI::Option* add_new_fruit_options(CLI::App& command, NewFruit& fruit);

struct BegunFruit {
  StartingSketch texts;
  std::vector<OutputFile> pictures;  ///< copies, beside the template, of those that lie elsewhere
};

/// \param toml where the template is to be.
/// \throws Error (usage) for more than two pictures, (input_missing), (bad_data) for what is no PNG, (cannot_create) if
/// another file of a picture's name lies in the folder.
BegunFruit begun(const std::filesystem::path& toml, const NewFruit& fruit);

}  // namespace pomona
