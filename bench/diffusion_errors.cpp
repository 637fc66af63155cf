// The errors of draft and final against the reference, which the documents state: every template, four cuts, in linear
// channels and in sRGB. Also the errors with other numbers of lines, to choose from.
//   diffusion_errors [FRUIT...] [--points N] [--lines N...] [--json FILE]
#include <algorithm>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/color_errors.h"
#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/pmvc/line_pmvc.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "render/export/output.h"
#include "tests/shapes/seeded_fruit.h"

namespace {

using namespace pomona;
using namespace pomona::bench;

struct Options {
  std::vector<std::string> fruits;
  std::vector<int> lines;
  int points = 400;  ///< of a section at most, evenly picked; 0 = all
  std::string json;
  int threads = 0;
};

/// One way to diffuse one section.
struct Entry {
  std::string fruit, cut, how;
  std::size_t points = 0;
  ColorErrors linear, srgb;
};

std::vector<glm::vec3> picked(const std::vector<glm::vec3>& points, int max) {
  if (max == 0 || points.size() <= static_cast<std::size_t>(max)) return points;
  std::vector<glm::vec3> some;
  for (std::size_t i = 0; i < static_cast<std::size_t>(max); ++i) {
    some.push_back(points[i * points.size() / static_cast<std::size_t>(max)]);
  }
  return some;
}

std::vector<Color> colors_by_lines(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points, int lines,
                                   const std::vector<Color>& truth) {
  const std::vector<PmvcValue> values =
      line_pmvc(surfaces, make_surface_tree(surfaces), points, {.lines = line_directions(lines), .more = {}});
  std::vector<Color> colors;
  for (std::size_t i = 0; i < values.size(); ++i) {
    colors.push_back(values[i].weight > 0 ? Color(values[i].color) : truth[i]);
  }
  return colors;
}

/// Adds an entry for every way.
void measure(const std::string& fruit, const std::string& cut, const DiffusionSurfaces& surfaces,
             const std::vector<glm::vec3>& all_points, const Options& options, std::vector<Entry>& entries) {
  const std::vector<glm::vec3> points = picked(all_points, options.points);
  if (points.empty()) return;
  const auto diffused = [&](Quality quality) {
    return make_pmvc_diffuser({.quality = quality, .threads = {options.threads}})->diffuse(surfaces, points).color;
  };
  const std::vector<Color> truth = diffused(Quality::reference);
  const auto add = [&](const std::string& how, const std::vector<Color>& colors) {
    entries.push_back(
        {fruit, cut, how, points.size(), color_errors(colors, truth), color_errors(colors, truth, Encoding::srgb)});
    const Entry& e = entries.back();
    std::fprintf(stderr, "%s %s %s: %.3f %.3f %.3f | %.3f %.3f %.3f\n", fruit.c_str(), cut.c_str(), how.c_str(),
                 e.linear.rms, e.linear.p95, e.linear.max, e.srgb.rms, e.srgb.p95, e.srgb.max);
  };
  add("draft", diffused(Quality::draft));
  add("final", diffused(Quality::final));
  for (const int lines : options.lines) {
    add(std::to_string(lines) + " lines", colors_by_lines(surfaces, points, lines, truth));
  }
}

std::vector<Entry> measured(const Options& options) {
  std::vector<Entry> entries;
  if (options.fruits.empty()) {
    const int count = options.points == 0 ? 3000 : options.points;
    measure("(bench model)", "slanted", shapes::seeded_fruit(), shapes::points_on_section_of_seeded_fruit(count),
            options, entries);
  }
  for (const std::string& name : fruit_names(options.fruits)) {
    const BenchFruit fruit = grow_fruit(name);
    const DiffusionSurfaces& surfaces = fruit.grown.sheets;
    std::vector<BenchCut> cuts = standard_cuts(surfaces);
    cuts.push_back({"wedges:6", parse_knife("wedges:6")});
    for (const BenchCut& at : cuts) {
      measure(name, at.name, surfaces, interior_positions(pomona::cut(surfaces, {&at.knife, 1}).section), options,
              entries);
    }
  }
  return entries;
}

TextTable table_of(const std::vector<Entry>& entries) {
  TextTable table{{"cut", "points", "how", "rms", "p95", "max", "sRGB: rms", "p95", "max"}, {}};
  for (const Entry& e : entries) {
    table.rows.push_back({e.fruit + ", " + e.cut, std::to_string(e.points), e.how, number(e.linear.rms, 3),
                          number(e.linear.p95, 3), number(e.linear.max, 2), number(e.srgb.rms, 3),
                          number(e.srgb.p95, 3), number(e.srgb.max, 2)});
  }
  return table;
}

nlohmann::ordered_json json_of(const std::vector<Entry>& entries) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Entry& e : entries) {
    json.push_back({{"fruit", e.fruit},
                    {"cut", e.cut},
                    {"points", e.points},
                    {"how", e.how},
                    {"linear", json_of(e.linear)},
                    {"srgb", json_of(e.srgb)}});
  }
  return json;
}

int make_report(const Options& options) {
  const std::vector<Entry> entries = measured(options);
  if (!options.json.empty()) write_whole(options.json, json_of(entries).dump(2) + "\n");
  std::printf("%s", markdown(table_of(entries)).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Errors of draft and final against the reference, in parts of 255"};
  app.add_option("fruits", options.fruits, "templates; all of them and the bench model if none is named");
  app.add_option("--points", options.points, "of a section at most; 0 = all")->check(CLI::NonNegativeNumber);
  app.add_option("--lines", options.lines, "other numbers of lines to measure")->check(CLI::PositiveNumber);
  app.add_option("--json", options.json, "file to write");
  app.add_option("--threads", options.threads);
  CLI11_PARSE(app, argc, argv);
  return exit_status_of([&] { return make_report(options); });
}
