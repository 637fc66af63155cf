// Reads dishes from scene files: [bowl] and [[dishes]].
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/scene/dish_description.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// The table [bowl]. Errors are noted in the document.
BowlDescription read_bowl(const TomlTable& table);

/// All of [[dishes]]. \param folder of the scene, which holds their meshes. \param taken names they must differ from.
std::vector<DishDescription> read_dishes(const TomlValue& value, const std::filesystem::path& folder,
                                         std::vector<std::string> taken);

}  // namespace pomona
