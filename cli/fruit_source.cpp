#include "cli/fruit_source.h"

#include "cli/file_kind.h"
#include "cli/find_template.h"
#include "generator/base/error.h"
#include "generator/base/small_ending.h"
#include "generator/surface/file/surface_file.h"
#include "generator/surface/sheets.h"
#include "generator/template/read/read_template.h"
#include "render/plate/plate.h"

namespace pomona {

namespace {

FruitSource from_surface_file(const std::filesystem::path& file, const SharedOptions& options, std::optional<int> folds,
                              StageTimes& times) {
  if (folds) {
    throw Error(ExitStatus::usage, "--folds: " + file.string() + " holds surfaces, which have no folds to change");
  }
  if (options.ripeness || options.browning > 0) {
    throw Error(ExitStatus::usage,
                "--ripeness, --browning: " + file.string() + " holds surfaces, which do not say how they ripen");
  }
  FruitSource source;
  source.name = file.stem().string();
  source.file = file.string();
  source.fruit.name = source.name;
  source.fruit.title = words_of(source.name);
  source.grown.swept = times.time("read", [&] { return read_surfaces(file); });
  source.fruit.parts = source.grown.swept.part_names;
  source.grown.sheets = times.time("sweep", [&] { return sheets(source.grown.swept); });
  times.count("surface_triangles", static_cast<std::int64_t>(source.grown.sheets.triangle_count()));
  source.origin = {.source = source_word(file.string()), .growing = {.as_drawn = true}};
  return source;
}

}  // namespace

SliceTask slice_task(const FruitSource& source, std::span<const Knife> knives, int piece) {
  SliceTask task{
      .grown = source.grown, .variant = source.fruit, .knives = knives, .name = source.name, .origin = source.origin};
  if (piece == 0) return task;
  task.name += ".piece-" + std::to_string(piece);
  task.choice = PieceChoice{.only = piece};
  return task;
}

Slices sliced(const FruitSource& source, const SliceTask& task, const Diffuser* diffuser, const SliceOptions& options) {
  try {
    return slice(task, diffuser, options);
  } catch (const Error& error) {
    if (error.status() != ExitStatus::bad_data) throw;
    throw told_of(error, source.file);
  }
}

void check_piece(int piece, const Slices& slices) {
  if (piece == 0 || slices.piece_count > 0) return;
  throw Error(ExitStatus::usage, "--piece " + std::to_string(piece) + ": there are fewer pieces");
}

FruitSource fruit_of(const Template& drawn, const std::string& name, const std::string& word,
                     const SharedOptions& options, std::optional<int> folds, StageTimes& times) {
  // Seed 0 on the command line is the template as drawn; with an index it is a variant, as in scenes.
  const VariantKey key{options.seed, options.index.value_or(0)};
  const GrowOptions grow_options{.as_drawn = options.as_drawn || (options.seed == 0 && !options.index),
                                 .variation = options.variation,
                                 .curves_only = options.curves_only,
                                 .folds = folds,
                                 .detail = options.detail,
                                 .ripeness = options.ripeness,
                                 .browning = options.browning,
                                 .scale = options.scale,
                                 .threads = {options.threads}};
  FruitSource source;
  source.name = name;
  source.file = drawn.file;
  source.fruit = times.time("vary", [&] { return variant_of(drawn, key, grow_options); });
  source.grown = times.time("sweep", [&] { return grow(source.fruit, key, grow_options); });
  source.origin = {.source = source_word(word), .key = key, .growing = grow_options};
  times.count("surface_triangles", static_cast<std::int64_t>(source.grown.sheets.triangle_count()));
  return source;
}

FruitSource open_fruit(const std::string& name_or_path, const SharedOptions& options, std::optional<int> folds,
                       StageTimes& times) {
  const std::filesystem::path file = find_template(name_or_path);
  check_kind(file, FileKind::fruit);
  if (small_ending(file) == ".ply") return from_surface_file(file, options, folds, times);
  const Template drawn = times.time("read", [&] { return read_template(file); });
  return fruit_of(drawn, file.stem().string(), name_or_path, options, folds, times);
}

}  // namespace pomona
