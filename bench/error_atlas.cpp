// Where positive mean values and the grid differ from true diffusion: a picture and three numbers for every template
// and three cuts. The truth comes from walks on spheres, kept on disk; a stopped run continues where it was.
//   error_atlas [FRUIT...] [--out FOLDER] [--keep FOLDER] [--standard-error E] [--json FILE]
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/atlas_picture.h"
#include "bench/color_errors.h"
#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "bench/walk_truth_store.h"
#include "cli/deliver/progress.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "render/export/output.h"
#include "render/image/png.h"

namespace {

using namespace pomona;
using namespace pomona::bench;

/// Differences of this many parts of 255 and more are black in the pictures.
constexpr double full_scale = 32;

struct Options {
  std::vector<std::string> fruits;
  std::filesystem::path out = "out/atlas";
  std::filesystem::path keep = "out/atlas/walks";
  std::string json;
  double standard_error = 1;
  int panel = 240;
  int threads = 0;
};

/// One fruit, one cut.
struct Entry {
  std::string fruit, cut;
  std::size_t points = 0;
  double standard_error = 0;  ///< RMS over the points, parts of 255
  double walk_seconds = 0;
  ColorErrors positive_mean_values, grid;  ///< against the walk
};

double rms_of(const std::vector<double>& values) {
  double squares = 0;
  for (const double value : values) squares += value * value;
  return values.empty() ? 0 : std::sqrt(squares / static_cast<double>(values.size()));
}

Entry measured(const BenchFruit& fruit, const BenchCut& at, const Options& options, Progress& progress) {
  const std::string name = fruit.name + "_" + at.name;
  const DiffusionSurfaces& surfaces = fruit.grown.sheets;
  const CrossSection section = cut(surfaces, {&at.knife, 1}).section;
  const std::vector<glm::vec3> points = interior_positions(section);

  // Diffuse in three ways at the same points.
  const WalkTruth truth =
      walk_truth(surfaces, points,
                 {.folder = options.keep / name,
                  .standard_error = options.standard_error,
                  .threads = {options.threads},
                  .progress = [&](std::size_t done, std::size_t total) { progress.report(name, done, total); }});
  const std::vector<Color> mean_values =
      make_pmvc_diffuser({.quality = Quality::final, .threads = {options.threads}})->diffuse(surfaces, points).color;
  HarmonicOptions grid_options;
  grid_options.threads = {options.threads};
  const std::vector<Color> grid = make_harmonic_diffuser(grid_options)->diffuse(surfaces, points).color;

  // Side by side: mean values, grid, walk; then where the first two differ from the third.
  const std::vector<CrossSection> panels{with_colors(section, mean_values), with_colors(section, grid),
                                         with_colors(section, truth.color),
                                         with_differences(section, mean_values, truth.color, full_scale),
                                         with_differences(section, grid, truth.color, full_scale)};
  write_whole(options.out / (name + ".png"), write_png(side_by_side(panels, options.panel, options.panel)));

  return {fruit.name,
          at.name,
          points.size(),
          rms_of(truth.standard_error),
          truth.seconds,
          color_errors(mean_values, truth.color),
          color_errors(grid, truth.color)};
}

TextTable table_of(const std::vector<Entry>& entries) {
  TextTable table{{"cut", "points", "walk's s.e.", "walk s", "mean values: mean", "p95", "max", "grid: mean", "p95",
                   "max", "rms without walk's"},
                  {}};
  for (const Entry& e : entries) {
    const double grid_variance = e.grid.rms * e.grid.rms - e.standard_error * e.standard_error;
    table.rows.push_back({e.fruit + ", " + e.cut, std::to_string(e.points), number(e.standard_error, 2),
                          number(e.walk_seconds, 1), number(e.positive_mean_values.mean, 2),
                          number(e.positive_mean_values.p95, 1), number(e.positive_mean_values.max, 1),
                          number(e.grid.mean, 2), number(e.grid.p95, 2), number(e.grid.max, 1),
                          number(std::sqrt(std::max(grid_variance, 0.0)), 2)});
  }
  return table;
}

nlohmann::ordered_json json_of(const std::vector<Entry>& entries) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Entry& e : entries) {
    json.push_back({{"fruit", e.fruit},
                    {"cut", e.cut},
                    {"points", e.points},
                    {"standard_error", e.standard_error},
                    {"walk_seconds", e.walk_seconds},
                    {"positive_mean_values", json_of(e.positive_mean_values)},
                    {"grid", json_of(e.grid)}});
  }
  return json;
}

int make_atlas(const Options& options) {
  std::filesystem::create_directories(options.out);
  std::vector<Entry> entries;
  Progress progress(false);
  for (const std::string& name : fruit_names(options.fruits)) {
    const BenchFruit fruit = grow_fruit(name);
    for (const BenchCut& at : standard_cuts(fruit.grown.sheets)) {
      entries.push_back(measured(fruit, at, options, progress));
    }
  }
  const std::string table = markdown(table_of(entries));
  write_whole(options.out / "atlas.md", table);
  if (!options.json.empty()) write_whole(options.json, json_of(entries).dump(2) + "\n");
  std::printf("%s", table.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Positive mean values and the grid against a walk on spheres, in parts of 255 (linear)");
  Options options;
  app.add_option("FRUIT", options.fruits, "Names of templates; all of them if none is given");
  app.add_option("--out", options.out, "Folder for the pictures and atlas.md")->capture_default_str();
  app.add_option("--keep", options.keep, "Folder in which walks are kept, so that a run can be resumed")
      ->capture_default_str();
  app.add_option("--standard-error", options.standard_error, "Of the walk, in parts of 255")
      ->check(CLI::Range(0.05, 50.0))
      ->capture_default_str();
  app.add_option("--panel", options.panel, "Pixels along one section's picture")
      ->check(CLI::Range(64, 1024))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "0 = all there are")->capture_default_str();
  app.add_option("--json", options.json, "Write the figures to this file too");
  CLI11_PARSE(app, argc, argv);
  return exit_status_of([&] { return make_atlas(options); });
}
