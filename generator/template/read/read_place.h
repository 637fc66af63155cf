// Reads the [[place]] entries of a template file, with the templates that they place.
#pragma once

#include <filesystem>
#include <vector>

#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// The templates around one that is being read, and how many more may be read for all of them.
struct PlacedWithin {
  std::vector<std::filesystem::path> around;  ///< outermost first, the one that is being read last
  int* left = nullptr;
};

/// Reads root's places into the fruit, whose other keys have all been read: what is placed brings its parts along, with
/// their materials, densities, noise, details and changes of colour.
/// \throws Error (bad_data) for mistakes in what is placed, at their places
void read_places(const TomlTable& root, const PlacedWithin& within, Template& fruit);

/// Reads a template that others place (read_template.cpp).
Template read_placed_template(const std::filesystem::path& file, const PlacedWithin& within);

}  // namespace pomona
