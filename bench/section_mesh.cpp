// Does the section mesh have its vertices where the field needs them? Measures the error of interpolation between them,
// and how many interior vertices a mesh of uniform size needs for the same error.
//   section_mesh [--json] [--samples N] [--no-uniform] [NAME...]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "bench/color_errors.h"
#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "generator/base/random.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"

namespace {

using namespace pomona;
using Json = nlohmann::ordered_json;

struct Settings {
  bool json = false;
  bool uniform = true;
  int samples = 4000;
  std::vector<std::string> names;
};

/// Places spread evenly over the section, and the colours that its mesh interpolates there.
struct Samples {
  std::vector<glm::vec3> position;
  std::vector<Color> color;
};

Samples spread(const CrossSection& section, int count) {
  std::vector<double> area_up_to;
  double area = 0;
  for (const glm::uvec3& t : section.triangle) {
    const glm::dvec3 a(section.position[t.x]), b(section.position[t.y]), c(section.position[t.z]);
    area += glm::length(glm::cross(b - a, c - a));
    area_up_to.push_back(area);
  }
  const RandomStream random({}, "bench/section mesh");
  Samples samples;
  for (int i = 0; i < count; ++i) {
    const auto key = static_cast<std::uint64_t>(3 * i);
    const double at = area * (i + random.uniform(key)) / count;
    const auto found = std::lower_bound(area_up_to.begin(), area_up_to.end() - 1, at);
    const glm::uvec3& t = section.triangle[static_cast<std::size_t>(found - area_up_to.begin())];
    const double root = std::sqrt(random.uniform(key + 1)), share = random.uniform(key + 2);
    const auto a = static_cast<float>(1 - root), b = static_cast<float>(root * (1 - share)), c = 1 - a - b;
    samples.position.push_back(a * section.position[t.x] + b * section.position[t.y] + c * section.position[t.z]);
    samples.color.push_back(a * section.color[t.x] + b * section.color[t.y] + c * section.color[t.z]);
  }
  return samples;
}

struct Measured {
  std::size_t interior = 0, vertices = 0, triangles = 0;
  bench::ColorErrors errors;
};

class Meter {
 public:
  Meter(const DiffusionSurfaces& surfaces, const Settings& settings)
      : surfaces_(surfaces), settings_(settings), field_(diffuser_->field(surfaces)) {}

  Measured measured(const Knife& knife, const CutOptions& options) const {
    CrossSection section = cut(surfaces_, std::vector{knife}, options).section;
    Measured result{bench::interior_positions(section).size(), section.position.size(), section.triangle.size(), {}};
    section = colored(std::move(section), surfaces_, *diffuser_);
    const Samples samples = spread(section, settings_.samples);
    result.errors = bench::color_errors(samples.color, field_->at(samples.position).color);
    return result;
  }

  /// Interior vertices of a uniform mesh with this error, interpolated between two sizes in logarithms.
  double uniform_for(const Knife& knife, double rms) const {
    constexpr double max_vertices = 60000;
    Measured coarser;
    for (double share = 1.0 / 20;; share /= 1.5) {
      CutOptions options;
      options.coarsest = options.finest = share;
      options.grading = 0;
      options.contrast = 1e9;
      const Measured finer = measured(knife, options);
      if (finer.errors.rms <= rms && coarser.interior == 0) return static_cast<double>(finer.interior);
      if (finer.errors.rms <= rms) {
        const double n0 = std::log(double(coarser.interior)), n1 = std::log(double(finer.interior));
        const double e0 = std::log(coarser.errors.rms), e1 = std::log(finer.errors.rms);
        return std::exp(n0 + (n1 - n0) * (e0 - std::log(rms)) / (e0 - e1));
      }
      if (static_cast<double>(finer.interior) > max_vertices) return NAN;
      coarser = finer;
    }
  }

 private:
  const DiffusionSurfaces& surfaces_;
  const Settings& settings_;
  std::unique_ptr<Diffuser> diffuser_ = make_pmvc_diffuser({Quality::final, {2}});
  std::unique_ptr<ColorField> field_;
};

Json row_of(const std::string& name, const bench::BenchCut& how, const Meter& meter, const Settings& settings) {
  const Measured now = meter.measured(how.knife, {});
  Json row = {{"fruit", name},
              {"knife", how.name},
              {"interior_vertices", now.interior},
              {"vertices", now.vertices},
              {"triangles", now.triangles},
              {"rms", now.errors.rms},
              {"mean", now.errors.mean},
              {"p95", now.errors.p95},
              {"max", now.errors.max}};
  row["uniform_interior_vertices"] = settings.uniform ? meter.uniform_for(how.knife, now.errors.rms) : NAN;
  return row;
}

void print(const Json& rows) {
  bench::TextTable table;
  table.head = {"fruit, cut", "triangles", "vertices", "interior", "RMS", "p95", "max", "uniform", "ratio"};
  for (const Json& row : rows) {
    const double uniform = row["uniform_interior_vertices"];
    const double own = row["interior_vertices"];
    table.rows.push_back({row["fruit"].get<std::string>() + ", " + row["knife"].get<std::string>(),
                          bench::number(row["triangles"], 0), bench::number(row["vertices"], 0), bench::number(own, 0),
                          bench::number(row["rms"], 2), bench::number(row["p95"], 2), bench::number(row["max"], 1),
                          bench::number(uniform, 0), bench::number(uniform / own, 1)});
  }
  std::printf(
      "Errors of interpolation in parts of 255, linear channels; uniform: interior vertices of a mesh of one size with "
      "the same RMS.\n\n%s",
      bench::markdown(table).c_str());
}

int make_report(const Settings& settings) {
  Json rows = Json::array();
  for (const std::string& name : bench::fruit_names(settings.names)) {
    const bench::BenchFruit fruit = bench::grow_fruit(name);
    const Meter meter(fruit.grown.sheets, settings);
    for (const bench::BenchCut& how : bench::standard_cuts(fruit.grown.sheets)) {
      if (how.name != "slanted") rows.push_back(row_of(name, how, meter, settings));
    }
  }
  if (settings.json) {
    std::printf("%s\n", rows.dump(2).c_str());
  } else {
    print(rows);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("What interpolation between a section's vertices costs, and how many a uniform mesh would need");
  Settings settings;
  app.add_option("FRUIT", settings.names, "Names of templates; all of them if none is given");
  app.add_option("--samples", settings.samples, "Places of a section at which errors are taken")
      ->check(CLI::Range(100, 10000000))
      ->capture_default_str();
  app.add_flag("!--no-uniform", settings.uniform, "Without the uniform mesh");
  app.add_flag("--json", settings.json, "Print JSON");
  CLI11_PARSE(app, argc, argv);
  return bench::exit_status_of([&] { return make_report(settings); });
}
