// The cost of true diffusion on the grid: set-up, solution, sampling, memory; for the seeded fruit and every template.
//   harmonic_bench [--threads N] [--runs N] [--nodes N] [--bend B] [--quality NAME...] [--truth FILE...] [--json]
//   [FRUIT...]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "bench/color_errors.h"
#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "generator/base/free_memory.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/harmonic/solve_field.h"
#include "generator/diffusion/surface_tree.h"
#include "tests/shapes/seeded_fruit.h"

namespace {

using namespace pomona;

struct Subject {
  std::string name;
  DiffusionSurfaces surfaces;
  std::vector<glm::vec3> points;  ///< of sections
  std::vector<glm::vec3> known_points;
  std::vector<Color> known_colors;  ///< colours from walks, exact within `standard_error`
  double standard_error = 0;        ///< in 1/255
};

struct Row {
  std::string name;
  Quality quality = Quality::final;
  int nodes = 0;  ///< along the side of a cube as large as the fruit
  std::size_t triangles = 0, points = 0, grid_nodes = 0, patch_nodes = 0;
  bool is_sealed = false;
  bench::Duration set_up, solve, field, section, texels;
  double kept_megabytes = 0, levels_megabytes = 0;
  bench::ColorErrors errors;  ///< against walks on spheres; `rms` is without their noise
};

constexpr int texel_side = 640;
const char* const seeded_name = "seeded fruit";

Subject seeded_fruit() {
  Subject subject;
  subject.name = seeded_name;
  subject.surfaces = shapes::seeded_fruit();
  subject.points = shapes::points_on_section_of_seeded_fruit(3000);
  return subject;
}

Subject template_subject(const std::string& name) {
  const bench::BenchFruit fruit = bench::grow_fruit(name);
  Subject subject;
  subject.name = name;
  subject.surfaces = fruit.grown.sheets;
  for (const bench::BenchCut& knife : bench::standard_cuts(subject.surfaces)) {
    const Cut all = cut(subject.surfaces, {&knife.knife, 1});
    const auto points = bench::interior_positions(all.section);
    subject.points.insert(subject.points.end(), points.begin(), points.end());
  }
  return subject;
}

std::vector<glm::vec3> vectors_of(const nlohmann::json& rows) {
  std::vector<glm::vec3> vectors;
  for (const auto& row : rows) vectors.emplace_back(row[0].get<float>(), row[1].get<float>(), row[2].get<float>());
  return vectors;
}

/// Adds the colours that a file of walk_truth has for a subject.
void add_truth(Subject& subject, const std::string& file) {
  const nlohmann::json known = nlohmann::json::parse(std::ifstream(file));
  if (known["fruit"] != (subject.name == seeded_name ? "bench" : subject.name)) return;
  for (const glm::vec3& point : vectors_of(known["position"])) subject.known_points.push_back(point);
  for (const glm::vec3& color : vectors_of(known["color"])) subject.known_colors.push_back(color);
  double squares = 0;
  for (const auto& error : known["standard_error"]) squares += error.get<double>() * error.get<double>();
  subject.standard_error = std::sqrt(squares / static_cast<double>(known["standard_error"].size()));
}

/// A square of texels across the middle, two thirds as wide as the fruit, which lies inside every fruit.
std::vector<glm::vec3> texels_across(const DiffusionSurfaces& surfaces) {
  const Box<double> bounds = bounds_of(surfaces);
  std::vector<glm::vec3> texels;
  for (int y = 0; y < texel_side; ++y) {
    for (int x = 0; x < texel_side; ++x) {
      const glm::dvec3 part(0.17 + 0.66 * (x + 0.5) / texel_side, 0.503, 0.17 + 0.66 * (y + 0.5) / texel_side);
      texels.emplace_back(bounds.low + part * bounds.size());
    }
  }
  return texels;
}

Row measured(const Subject& subject, const HarmonicOptions& options, int runs) {
  Row row;
  row.name = subject.name;
  row.quality = options.quality;
  row.triangles = subject.surfaces.triangle_count();
  row.points = subject.points.size();
  const GridOptions grid = grid_options(subject.surfaces, options);

  // Times the two halves of the work separately, then a whole field.
  const glm::dvec3 size = bounds_of(subject.surfaces).size();
  row.nodes = static_cast<int>(std::max({size.x, size.y, size.z}) / grid.spacing + 0.5);
  std::optional<PreparedField> prepared;
  row.set_up = bench::median_time(runs, [&] { prepared = prepared_field(subject.surfaces, grid); });
  row.is_sealed = prepared->is_sealed;
  const SolvedLevels solved = solved_levels(prepared->snapped, std::move(prepared->levels), grid);
  for (std::size_t l = 0; l < solved.levels.size(); ++l) {
    const std::size_t nodes = solved.levels[l].blocks.node_count();
    if (l < solved.patch_count) row.patch_nodes += nodes;
    if (l == solved.patch_count) row.grid_nodes = nodes;
    row.levels_megabytes += 1e-6 * static_cast<double>(solved.levels[l].bytes());
  }
  std::vector<bench::Duration> solve_times;
  for (int i = 0; i < runs; ++i) {
    PreparedField again = prepared_field(subject.surfaces, grid);
    solve_times.push_back(bench::time_of([&] {
      const FieldSampler field = solved_field(std::move(again), grid);
      row.kept_megabytes = 1e-6 * static_cast<double>(field.bytes());
    }));
  }
  std::sort(solve_times.begin(), solve_times.end(), [](const auto& a, const auto& b) { return a.wall < b.wall; });
  row.solve = solve_times[solve_times.size() / 2];
  std::unique_ptr<ColorField> field;
  row.field = bench::median_time(runs, [&] { field = make_harmonic_diffuser(options)->field(subject.surfaces); });

  // Look up 3 000 points of the sections, and texels.
  std::vector<glm::vec3> section;
  for (std::size_t i = 0; i < 3000; ++i) section.push_back(subject.points[i * subject.points.size() / 3000]);
  row.section = bench::median_time(2 * runs, [&] { field->at(section); });
  const std::vector<glm::vec3> texels = texels_across(subject.surfaces);
  row.texels = bench::median_time(runs, [&] { field->at(texels); });
  if (!subject.known_points.empty()) {
    row.errors = bench::color_errors(field->at(subject.known_points).color, subject.known_colors);
    const double noise = subject.standard_error;
    row.errors.rms = std::sqrt(std::max(0.0, row.errors.rms * row.errors.rms - noise * noise));
  }
  return row;
}

void print_text(const std::vector<Row>& rows) {
  bench::TextTable table{
      {"fruit", "quality", "N", "triangles", "grid nodes", "patch nodes", "set-up ms", "solve ms", "all ms",
       "all cpu ms", "3000 points ms", "400k texels ms", "levels MB", "kept MB", "rms", "p95", "max"},
      {}};
  const auto ms = [](const bench::Duration& d) { return bench::number(d.wall, 1); };
  for (const Row& row : rows) {
    table.rows.push_back({row.name, name_of(row.quality), std::to_string(row.nodes), std::to_string(row.triangles),
                          std::to_string(row.grid_nodes), std::to_string(row.patch_nodes), ms(row.set_up),
                          ms(row.solve), ms(row.field), bench::number(row.field.processor, 1),
                          bench::number(row.section.wall, 2), ms(row.texels), bench::number(row.levels_megabytes, 0),
                          bench::number(row.kept_megabytes, 0), bench::number(row.errors.rms, 2),
                          bench::number(row.errors.p95, 2), bench::number(row.errors.max, 1)});
  }
  std::printf("%s\nErrors in parts of 255. Peak memory %.0f MB.\n", bench::markdown(table).c_str(),
              bench::peak_megabytes());
}

nlohmann::json json_of(const bench::Duration& d) { return {{"wall_ms", d.wall}, {"processor_ms", d.processor}}; }

void print_json(const std::vector<Row>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const Row& row : rows) {
    all.push_back({{"fruit", row.name},
                   {"quality", name_of(row.quality)},
                   {"nodes", row.nodes},
                   {"triangles", row.triangles},
                   {"points", row.points},
                   {"grid_nodes", row.grid_nodes},
                   {"patch_nodes", row.patch_nodes},
                   {"sealed", row.is_sealed},
                   {"set_up", json_of(row.set_up)},
                   {"solve", json_of(row.solve)},
                   {"field", json_of(row.field)},
                   {"points_3000", json_of(row.section)},
                   {"texels_409600", json_of(row.texels)},
                   {"levels_megabytes", row.levels_megabytes},
                   {"kept_megabytes", row.kept_megabytes},
                   {"rms", row.errors.rms},
                   {"p95", row.errors.p95},
                   {"max", row.errors.max}});
  }
  std::printf("%s\n", all.dump(2).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times of true diffusion on the grid");
  int threads = 2, runs = 5, nodes = 0;
  double bend = -1;
  bool as_json = false;
  std::vector<std::string> names, truth, qualities = {"draft", "final"};
  app.add_option("--threads", threads, "Threads to use")->capture_default_str();
  app.add_option("--runs", runs, "Runs to take the median of")->capture_default_str();
  app.add_option("--nodes", nodes, "Nodes along the side of a cube as large as the fruit; 0: as the quality says")
      ->capture_default_str();
  app.add_option(
         "--bend", bend,
         "Finer patches also where the solution bends by so many parts of 255; 0: nowhere; -1: as the quality says")
      ->capture_default_str();
  app.add_option("--quality", qualities, "draft, final, reference; draft and final unless said")
      ->check(CLI::IsMember(quality_names()));
  app.add_option("--truth", truth, "Files of walk_truth to take errors from");
  app.add_flag("--json", as_json, "Print JSON");
  app.add_option("fruit", names, "Templates; \"seeded\" for the bench model. All, if none is named");
  CLI11_PARSE(app, argc, argv);

  const bool all = names.empty();
  const bool with_seeded = all || std::erase(names, "seeded") > 0;
  keep_free_memory();  // as the program does
  return bench::exit_status_of([&] {
    std::vector<Subject> subjects;
    if (with_seeded) subjects.push_back(seeded_fruit());
    if (all || !names.empty()) {
      for (const std::string& name : bench::fruit_names(names)) subjects.push_back(template_subject(name));
    }
    std::vector<Row> rows;
    for (Subject& subject : subjects) {
      for (const std::string& file : truth) add_truth(subject, file);
      for (const std::string& quality : qualities) {
        rows.push_back(measured(
            subject,
            {.quality = *quality_named(quality), .threads = {threads}, .nodes = nodes, .refine_above = bend / 255},
            runs));
      }
    }
    if (as_json) {
      print_json(rows);
    } else {
      print_text(rows);
    }
    return 0;
  });
}
