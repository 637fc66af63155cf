// Batch files: fruits, their numbers, knives and formats. Read like templates, with the same kind of errors.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/error.h"
#include "generator/diffusion/quality.h"
#include "generator/knife/knife.h"
#include "generator/order/option_table.h"

namespace pomona {

struct TemplateWanted {
  std::string name;
  SourcePlace place;
};

/// The order of a batch without any options: textures have only base colour.
Order usual_batch_order();

/// The options of a batch that are not lists: one value for all items of an entry.
std::vector<const OrderOption*> batch_options();

/// The quality and formats of items; those of [batch] are the defaults of all entries.
struct AssetOptions {
  std::vector<Format> formats{Format::glb};  ///< a file of each
  std::vector<Quality> qualities{Quality::draft};
  std::vector<int> textures{0};       ///< texels along a texture's edge; 0 = colours on vertices
  std::vector<int> lods{0};           ///< further levels of detail
  Order order = usual_batch_order();  ///< all other options, which do not multiply
  int thumbnail = 0;                  ///< pixels along its edge; 0 = none
  bool thumbnail_on_paper = false;
  bool on_table = false;  ///< pieces lie as pictures show them, side by side with their cut faces up
  bool apart = false;     ///< each piece has files of its own
};

/// All lists multiply, except for the formats.
struct BatchEntry {
  std::string name;
  SourcePlace place;
  bool all_templates = false;
  std::vector<TemplateWanted> templates;

  // One of the three says which variants.
  std::vector<std::uint64_t> seeds;  ///< seeds of each template, as on the command line
  int count = 0;                     ///< number of new variants of each template
  int total = 0;                     ///< number of new variants, of the templates in turn

  // An empty optional is the variant's own value.
  std::vector<std::optional<int>> folds{std::nullopt};
  std::vector<std::optional<double>> ripeness{std::nullopt};
  std::vector<double> browning{0};
  std::vector<std::vector<Knife>> knives{{}};  ///< alternatives, each of knives that cut one after another
  AssetOptions assets;
};

struct BatchDescription {
  std::string file;  ///< for messages
  std::string name, title;
  std::uint64_t seed = 0;
  std::vector<BatchEntry> entries;
};

/// \throws Error (bad_data) with all errors, also unknown keys, ordered by position.
BatchDescription parse_batch(std::string_view toml, const std::string& file);

/// The same from disk.
/// \throws Error (input_missing) if it cannot be read.
BatchDescription read_batch(const std::filesystem::path& file);

/// True for a .toml file with a table [batch] or an [[entry]].
bool is_batch_file(const std::filesystem::path& file);

}  // namespace pomona
