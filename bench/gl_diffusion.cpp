// Diffusion by OpenGL: the sections of all templates in one batch, the time, the device, and the difference from the
// CPU.
//   gl_diffusion [--quality draft|final|reference] [--points N] [--runs N] [--json] [TEMPLATE...]
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/color_errors.h"
#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "render/diffusion/gl_diffuser.h"

namespace {

using namespace pomona;
using namespace pomona::bench;

struct Options {
  std::string quality = "final";
  std::size_t points = 0;  // largest number of points of each section; 0 = all
  int runs = 3;
  bool without_reference = false;
  bool json = false;
  std::vector<std::string> templates;
};

/// One cut of one template.
struct Section {
  std::string fruit, cut;
  const DiffusionSurfaces* surfaces = nullptr;
  std::size_t interior = 0;  ///< vertices, of which `points` are used
  std::vector<glm::vec3> points;
};

struct Comparison {
  ColorErrors from_cpu;        ///< at the same quality
  ColorErrors from_reference;  ///< CPU
  std::size_t other_parts = 0;
};

std::vector<BenchFruit> grown(const std::vector<std::string>& names) {
  std::vector<BenchFruit> fruits;
  for (const std::string& name : fruit_names(names)) fruits.push_back(grow_fruit(name));
  return fruits;
}

std::vector<Section> sections_of(const std::vector<BenchFruit>& fruits, std::size_t max_points) {
  std::vector<Section> sections;
  for (const BenchFruit& fruit : fruits) {
    for (const BenchCut& way : standard_cuts(fruit.grown.sheets)) {
      const auto all = interior_positions(cut(fruit.grown.sheets, {&way.knife, 1}).section);
      Section section{fruit.name, way.name, &fruit.grown.sheets, all.size(), {}};
      const std::size_t step =
          max_points == 0 ? 1 : std::max<std::size_t>(1, (all.size() + max_points - 1) / max_points);
      for (std::size_t i = 0; i < all.size(); i += step) section.points.push_back(all[i]);
      sections.push_back(std::move(section));
    }
  }
  return sections;
}

std::vector<DiffusionTask> tasks_of(const std::vector<Section>& sections) {
  std::vector<DiffusionTask> tasks;
  for (const Section& section : sections) tasks.push_back({section.surfaces, section.points});
  return tasks;
}

std::vector<Comparison> compared(const std::vector<DiffusedColors>& gl, const std::vector<DiffusedColors>& cpu,
                                 const std::vector<DiffusedColors>& reference) {
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < gl.size(); ++i) {
    Comparison c{color_errors(gl[i].color, cpu[i].color), color_errors(gl[i].color, reference[i].color), 0};
    for (std::size_t p = 0; p < gl[i].part.size(); ++p) c.other_parts += gl[i].part[p] != cpu[i].part[p] ? 1 : 0;
    comparisons.push_back(c);
  }
  return comparisons;
}

/// The measurements of all sections together.
struct Measured {
  std::string device;
  bool hardware = false;
  Duration opening, first, batch, cpu;
  std::size_t points = 0, triangles = 0;
};

void print_text(const Options& options, const Measured& m, const std::vector<Section>& sections,
                const std::vector<Comparison>& comparisons) {
  std::printf("OpenGL by %s%s\n", m.device.c_str(), m.hardware ? "" : ": no hardware GPU here, this is software");
  std::printf("%zu sections of fruits with %zu triangles in all, %zu points, quality %s\n", sections.size(),
              m.triangles, m.points, options.quality.c_str());
  std::printf("opening %.0f ms, first batch %.0f ms, batch %.1f ms (median of %d); CPU %.1f ms\n", m.opening.wall,
              m.first.wall, m.batch.wall, options.runs, m.cpu.wall);
  std::printf("of processors: first batch %.0f ms, batch %.1f ms; CPU %.1f ms\n\n", m.first.processor,
              m.batch.processor, m.cpu.processor);
  TextTable table;
  table.head = {"section",  "triangles",      "vertices", "points", "RMS, CPU",
                "max, CPU", "RMS, reference", "p95",      "max",    "other part"};
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Comparison& c = comparisons[i];
    table.rows.push_back({sections[i].fruit + " " + sections[i].cut,
                          std::to_string(sections[i].surfaces->triangle_count()), std::to_string(sections[i].interior),
                          std::to_string(sections[i].points.size()), number(c.from_cpu.rms, 3),
                          number(c.from_cpu.max, 3), number(c.from_reference.rms, 3), number(c.from_reference.p95, 3),
                          number(c.from_reference.max, 3), std::to_string(c.other_parts)});
  }
  std::printf("%s", markdown(table).c_str());
}

void print_json(const Options& options, const Measured& m, const std::vector<Section>& sections,
                const std::vector<Comparison>& comparisons) {
  nlohmann::ordered_json json{{"device", m.device},
                              {"hardware", m.hardware},
                              {"quality", options.quality},
                              {"triangles", m.triangles},
                              {"points", m.points},
                              {"opening_ms", m.opening.wall},
                              {"first_batch_ms", m.first.wall},
                              {"batch_ms", m.batch.wall},
                              {"cpu_ms", m.cpu.wall},
                              {"first_batch_processor_ms", m.first.processor},
                              {"batch_processor_ms", m.batch.processor},
                              {"cpu_processor_ms", m.cpu.processor},
                              {"sections", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Comparison& c = comparisons[i];
    json["sections"].push_back({{"template", sections[i].fruit},
                                {"cut", sections[i].cut},
                                {"triangles", sections[i].surfaces->triangle_count()},
                                {"interior_vertices", sections[i].interior},
                                {"points", sections[i].points.size()},
                                {"rms_from_cpu", c.from_cpu.rms},
                                {"max_from_cpu", c.from_cpu.max},
                                {"rms", c.from_reference.rms},
                                {"p95", c.from_reference.p95},
                                {"max", c.from_reference.max},
                                {"other_parts", c.other_parts}});
  }
  std::printf("%s\n", json.dump(2).c_str());
}

void measure(const Options& options) {
  const std::map<std::string, Quality> qualities{
      {"draft", Quality::draft}, {"final", Quality::final}, {"reference", Quality::reference}};
  const Quality quality = qualities.at(options.quality);
  const std::vector<BenchFruit> fruits = grown(options.templates);
  const std::vector<Section> sections = sections_of(fruits, options.points);
  const std::vector<DiffusionTask> tasks = tasks_of(sections);

  Measured m;
  for (const Section& section : sections) m.points += section.points.size();
  for (const BenchFruit& fruit : fruits) m.triangles += fruit.grown.sheets.triangle_count();
  std::unique_ptr<Diffuser> gl;
  m.opening = time_of([&] { gl = make_gl_diffuser({.quality = quality}); });
  m.device = gl->device();
  m.hardware = !is_software_renderer(m.device);

  std::vector<DiffusedColors> by_gl, by_cpu, reference;
  m.first = time_of([&] { by_gl = gl->diffuse_all(tasks); });
  m.batch = options.runs == 0 ? m.first : median_time(options.runs, [&] { by_gl = gl->diffuse_all(tasks); });
  m.cpu = time_of([&] { by_cpu = make_pmvc_diffuser({quality, {}})->diffuse_all(tasks); });
  reference = options.without_reference ? by_cpu : make_pmvc_diffuser({Quality::reference, {}})->diffuse_all(tasks);
  (options.json ? print_json : print_text)(options, m, sections, compared(by_gl, by_cpu, reference));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Diffusion by OpenGL: all templates' sections in one batch, against the CPU", "gl_diffusion");
  app.add_option("--quality", options.quality)
      ->check(CLI::IsMember({"draft", "final", "reference"}))
      ->capture_default_str();
  app.add_option("--points", options.points, "At most so many of each section; 0 = all")->capture_default_str();
  app.add_option("--runs", options.runs, "Batches to take the median of, after the first; 0 = the first alone")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_flag("--without-reference", options.without_reference,
               "Compare with the CPU at this quality alone: the reference takes far longer than all else");
  app.add_flag("--json", options.json);
  app.add_option("TEMPLATE", options.templates, "Names of templates; all if none is given");
  CLI11_PARSE(app, argc, argv);
  return exit_status_of([&] {
    measure(options);
    return 0;
  });
}
