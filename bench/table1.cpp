// Table 1 of the paper for every template there is, on this machine, beside the paper's own; then what diffusion
// costs each way: ours, the paper's algorithm, the tetrahedral Poisson solve that the paper set aside, and the grid.
//   table1 [FRUIT...] [--out FILE] [--json FILE] [--threads N]
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/baselines/cube_maps.h"
#include "bench/baselines/tetrahedral_poisson.h"
#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/paper_table1.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "cli/deliver/progress.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/surface/file/surface_file.h"
#include "render/export/output.h"
#include "tests/shapes/seeded_fruit.h"

namespace {

using namespace pomona;
using namespace pomona::bench;

constexpr int runs = 5;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Options {
  std::vector<std::string> fruits;
  std::string out, json;
  int threads = 0;
};

/// All measurements of one model. Milliseconds by the clock unless noted; NaN where nothing was measured.
struct Row {
  std::string name, type;
  std::size_t vertices = 0, faces = 0;
  double kilobytes = 0;
  double cut = 0;  ///< section along `half`, diffused on the CPU at final quality
  std::size_t interior_vertices = 0;
  double draft = 0, final = 0;
  double cube_maps = nothing;  ///< extrapolated from some of the vertices
  std::string renderer;        ///< OpenGL's renderer that drew the cube maps
  double poisson = nothing, poisson_megabytes = nothing;
  std::string why_no_poisson;
  double grid_set_up = 0, grid_look_up = 0;
};

std::string type_of(const Template& fruit) {
  if (std::holds_alternative<NoSymmetry>(fruit.symmetry)) return "none";
  return std::holds_alternative<FoldSymmetry>(fruit.symmetry) ? "N-fold" : "cylindrical";
}

double milliseconds_of(const std::function<void()>& work) { return median_time(runs, work).wall; }

void measure_mean_values(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points, Threads threads,
                         Row& row) {
  const auto time = [&](Quality quality) {
    const auto diffuser = make_pmvc_diffuser({.quality = quality, .threads = threads});
    return milliseconds_of([&] { diffuser->diffuse(surfaces, points); });
  };
  row.draft = time(Quality::draft);
  row.final = time(Quality::final);
}

/// The paper's algorithm at some of the points only, because it takes milliseconds for each.
void measure_cube_maps(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points, Row& row) {
  constexpr std::size_t sample = 12;
  std::vector<glm::vec3> some;
  for (std::size_t i = 0; i < sample && i < points.size(); ++i) some.push_back(points[i * points.size() / sample]);
  const CubeMapColors drawn = cube_map_pmvc(surfaces, some);
  row.cube_maps = drawn.per_point * static_cast<double>(points.size());
  row.renderer = drawn.renderer;
}

void measure_poisson(const DiffusionSurfaces& surfaces, Row& row) {
  const TetrahedralPoisson solved(surfaces, {.cell_size = 0.05});
  row.why_no_poisson = solved.why_not();
  if (!row.why_no_poisson.empty()) return;
  row.poisson = 1000 * (solved.cost().meshing_seconds + solved.cost().solving_seconds);
  row.poisson_megabytes = static_cast<double>(solved.cost().storage_bytes) * 1e-6;
}

void measure_grid(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points, Threads threads, Row& row) {
  HarmonicOptions how;
  how.threads = threads;
  const auto diffuser = make_harmonic_diffuser(how);
  std::unique_ptr<ColorField> field;
  row.grid_set_up = milliseconds_of([&] { field = diffuser->field(surfaces); });
  row.grid_look_up = milliseconds_of([&] { field->at(points); });
}

/// A template's fruit, or a made-up one.
struct Model {
  std::string name, type;
  DiffusionSurfaces surfaces;
};

Model model_of(const std::string& template_name) {
  BenchFruit fruit = grow_fruit(template_name);
  return {template_name, type_of(fruit.drawn), std::move(fruit.grown.sheets)};
}

/// The seeded fruit without its septa: they cross its chambers, and tetrahedra need surfaces that do not cross. It
/// gives the table one line with all columns.
Model seeded_fruit_without_septa() {
  const DiffusionSurfaces whole = shapes::seeded_fruit();
  DiffusionSurfaces rest = whole;
  rest.triangle.clear();
  rest.surface.clear();
  rest.front_part.clear();
  rest.back_part.clear();
  for (std::size_t t = 0; t < whole.triangle_count(); ++t) {
    if (whole.surface_names[static_cast<std::size_t>(whole.surface[t])].starts_with("septum")) continue;
    rest.triangle.push_back(whole.triangle[t]);
    rest.surface.push_back(whole.surface[t]);
    rest.front_part.push_back(whole.front_part[t]);
    rest.back_part.push_back(whole.back_part[t]);
  }
  return {"(seeded)", "made up", std::move(rest)};
}

Row measured(const Model& model, Threads threads) {
  const DiffusionSurfaces& surfaces = model.surfaces;
  Row row;
  row.name = model.name;
  row.type = model.type;
  row.vertices = surfaces.vertex_count();
  row.faces = surfaces.triangle_count();
  row.kilobytes = static_cast<double>(write_surfaces(surfaces).size()) * 1e-3;

  // The section by `half`, and the points that all ways of diffusing share.
  const Knife half = parse_knife("half");
  const auto diffuser = make_pmvc_diffuser({.quality = Quality::final, .threads = threads});
  const CrossSection section = cut(surfaces, {&half, 1}).section;
  const std::vector<glm::vec3> points = interior_positions(section);
  row.interior_vertices = points.size();
  row.cut = milliseconds_of([&] { colored(cut(surfaces, {&half, 1}).section, surfaces, *diffuser); });

  measure_mean_values(surfaces, points, threads, row);
  measure_grid(surfaces, points, threads, row);
  measure_cube_maps(surfaces, points, row);
  measure_poisson(surfaces, row);
  return row;
}

/// The paper's columns, ours and its own.
TextTable paper_columns(const std::vector<Row>& rows) {
  TextTable table{{"model", "type", "vertices", "faces", "KB", "cut ms", "paper: vertices", "faces", "KB", "cut ms"},
                  {}};
  for (const Row& row : rows) {
    const std::optional<PaperRow> paper = paper_row(row.name);
    table.rows.push_back({row.name, row.type, std::to_string(row.vertices), std::to_string(row.faces),
                          number(row.kilobytes, 0), number(row.cut, 0), paper ? std::to_string(paper->vertices) : "-",
                          paper ? std::to_string(paper->faces) : "-", paper ? std::to_string(paper->kilobytes) : "-",
                          paper ? number(1000 * paper->cut_seconds, 0) : "-"});
  }
  return table;
}

/// The cost of diffusion, in milliseconds unless noted.
TextTable diffusion_columns(const std::vector<Row>& rows) {
  TextTable table{{"model", "interior vertices", "draft", "final", "cube maps", "/ final", "Poisson set-up s",
                   "storage MB", "grid set-up", "look-up", "Poisson / grid set-up"},
                  {}};
  for (const Row& row : rows) {
    table.rows.push_back({row.name, std::to_string(row.interior_vertices), number(row.draft, 1), number(row.final, 1),
                          number(row.cube_maps, 0), number(row.cube_maps / row.final, 0), number(row.poisson / 1000, 1),
                          number(row.poisson_megabytes, 0), number(row.grid_set_up, 1), number(row.grid_look_up, 1),
                          number(row.poisson / row.grid_set_up, 0)});
  }
  return table;
}

std::string text_of(const std::vector<Row>& rows) {
  std::string text = markdown(paper_columns(rows)) + "\n" + markdown(diffusion_columns(rows)) + "\n";
  if (!rows.empty()) text += "Cube maps drawn by: " + rows.front().renderer + "\n";
  for (const Row& row : rows) {
    if (!row.why_no_poisson.empty())
      text += "No tetrahedral Poisson for " + row.name + ": " + row.why_no_poisson + "\n";
  }
  return text;
}

/// NaN becomes null.
nlohmann::ordered_json json_of(const std::vector<Row>& rows) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json entry = {{"model", row.name},
                                    {"type", row.type},
                                    {"vertices", row.vertices},
                                    {"faces", row.faces},
                                    {"surface_file_kilobytes", row.kilobytes},
                                    {"cut_milliseconds", row.cut},
                                    {"interior_vertices", row.interior_vertices},
                                    {"draft_milliseconds", row.draft},
                                    {"final_milliseconds", row.final},
                                    {"cube_maps_milliseconds", row.cube_maps},
                                    {"cube_maps_renderer", row.renderer},
                                    {"poisson_milliseconds", row.poisson},
                                    {"poisson_megabytes", row.poisson_megabytes},
                                    {"why_no_poisson", row.why_no_poisson},
                                    {"grid_set_up_milliseconds", row.grid_set_up},
                                    {"grid_look_up_milliseconds", row.grid_look_up}};
    if (const std::optional<PaperRow> paper = paper_row(row.name)) {
      entry["paper"] = {{"type", paper->type},
                        {"vertices", paper->vertices},
                        {"faces", paper->faces},
                        {"kilobytes", paper->kilobytes},
                        {"cut_milliseconds", 1000 * paper->cut_seconds}};
    }
    json.push_back(entry);
  }
  return json;
}

int make_table(const Options& options) {
  std::vector<Row> rows;
  Progress progress(false);
  const std::vector<std::string> names = fruit_names(options.fruits);
  for (const std::string& name : names) {
    rows.push_back(measured(model_of(name), {options.threads}));
    progress.report("models", rows.size(), names.size());
  }
  if (options.fruits.empty()) {
    progress.line("tetrahedra for one more model; that takes minutes");
    rows.push_back(measured(seeded_fruit_without_septa(), {options.threads}));
  }
  const std::string text = text_of(rows);
  if (!options.out.empty()) write_whole(options.out, text);
  if (!options.json.empty()) write_whole(options.json, json_of(rows).dump(2) + "\n");
  std::printf("%s", text.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Table 1 of the paper on this machine, and what diffusion costs each way; medians of 5 runs");
  Options options;
  app.add_option("FRUIT", options.fruits, "Names of templates; all of them if none is given");
  app.add_option("--out", options.out, "Write the tables to this file too");
  app.add_option("--json", options.json, "Write the figures to this file as JSON");
  app.add_option("--threads", options.threads, "0 = all there are")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return exit_status_of([&] { return make_table(options); });
}
