// The stages of a cut: intersection, triangulation, diffusion, pieces; and its memory.
//   whole_cut [--json] [--runs N] [--triangles N] [--threads N] [NAME...]
// Names are those of templates, and "bench" for the seeded fruit; none means all. Every fruit is measured in a
// process of its own, so that its peak of memory is its own.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/own_process.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "generator/cut/cut.h"
#include "generator/cut/cut_observer.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/solid.h"
#include "tests/shapes/seeded_fruit.h"

namespace {

using namespace pomona;
using Json = nlohmann::ordered_json;

struct Settings {
  bool json = false;
  int runs = 7;
  int triangles = 0;  ///< 0 = as many as the template asks for
  Threads threads{2};
  std::vector<std::string> names;
};

struct Subject {
  DiffusionSurfaces sheets;
  Template fruit;
  std::vector<bench::BenchCut> cuts;
};

/// The plane of points_on_section_of_seeded_fruit(), as a knife: y = 5 % of the radius + 0.1 x + 0.03 z.
bench::BenchCut cut_of_bench_model() {
  const glm::dvec3 normal(-0.1, 1, -0.03);
  const CuttingPlane plane{glm::normalize(normal), 0.05 * 0.04 / glm::length(normal)};
  return {"slanted", {PlaneCut(PlaneKnife{plane}), "slanted"}};
}

Subject subject_of(const std::string& name, int triangles) {
  if (name == "bench") return {shapes::seeded_fruit(), {}, {cut_of_bench_model()}};
  bench::BenchFruit fruit = bench::grow_fruit(name, triangles > 0 ? bench::detail_for(name, triangles) : 1);
  std::vector<bench::BenchCut> cuts = {{"half", parse_knife("half")},
                                       {"across", parse_knife("across")},
                                       {"wedges:6", parse_knife("wedges:6")},
                                       {"slices:8", parse_knife("slices:8")},
                                       {"dice:4", parse_knife("dice:4")}};
  return {std::move(fruit.grown.sheets), std::move(fruit.drawn), std::move(cuts)};
}

/// Times of the stages that cut() reports: a list for each stage, an entry for each run.
class StageTimes final : public CutObserver {
 public:
  void took(std::string_view stage, double milliseconds) override { times_[std::string(stage)] += milliseconds; }

  /// The times since the last call.
  std::map<std::string, double> taken() { return std::exchange(times_, {}); }

 private:
  std::map<std::string, double> times_;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Json measured(const Subject& subject, const bench::BenchCut& how, const Settings& settings) {
  const std::vector<Knife> knives{how.knife};
  const CutOptions options{.threads = settings.threads};
  Json row;
  const auto time = [&](const std::string& name, const std::function<void()>& work) {
    const bench::Duration spent = bench::median_time(settings.runs, work);
    row[name] = {{"wall_ms", spent.wall}, {"processor_ms", spent.processor}};
  };

  // The stages of the cut, and the cut as a whole.
  std::map<std::string, std::vector<double>> stages;
  StageTimes stage_times;
  for (int run = 0; run < settings.runs; ++run) {
    cut(subject.sheets, knives, options, &stage_times);
    for (const auto& [stage, milliseconds] : stage_times.taken()) stages[stage].push_back(milliseconds);
  }
  for (const auto& [stage, milliseconds] : stages) row["steps"][stage] = median(milliseconds);
  const Cut result = cut(subject.sheets, knives, options);
  time("cut", [&] { cut(subject.sheets, knives, options); });

  // The stages after the cut.
  CrossSection section;
  for (const auto& [name, quality] : {std::pair("draft", Quality::draft), std::pair("final", Quality::final)}) {
    const auto diffuser = make_pmvc_diffuser({quality, settings.threads});
    time(name, [&] { section = colored(result.section, subject.sheets, *diffuser); });
  }
  time("solids", [&] { solids(result.pieces, section, subject.fruit, "fruit"); });
  row["surface_triangles"] = subject.sheets.triangle_count();
  row["interior_vertices"] = bench::interior_positions(section).size();
  row["section_triangles"] = section.triangle.size();
  row["pieces"] = result.pieces.size();
  return row;
}

Json measured(const std::string& name, const Settings& settings) {
  const Subject subject = subject_of(name, settings.triangles);
  Json rows = Json::array();
  for (const bench::BenchCut& how : subject.cuts) {
    Json row = {{"fruit", name}, {"knife", how.name}};
    row.update(measured(subject, how, settings));
    row["peak_megabytes"] = bench::peak_megabytes();
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The same, measured in a process of its own.
Json measured_apart(const std::string& name, const Settings& settings) {
  return Json::parse(bench::in_own_process([&] { return measured(name, settings).dump(); }));
}

void print(const Json& rows) {
  bench::TextTable table;
  table.head = {"fruit, cut", "faces", "inner",   "bodies", "split", "mesh",   "regions",    "clip",       "section",
                "pieces",     "cut",   "cut cpu", "draft",  "final", "solids", "all, draft", "all, final", "MB"};
  for (const Json& row : rows) {
    const Json& steps = row["steps"];
    const auto wall = [&](const char* what) { return row[what]["wall_ms"].get<double>(); };
    const auto step = [&](const char* what) { return bench::number(steps[what].get<double>(), 1); };
    const double rest = wall("cut") + wall("solids");
    table.rows.push_back(
        {row["fruit"].get<std::string>() + ", " + row["knife"].get<std::string>(),
         std::to_string(row["surface_triangles"].get<int>()), std::to_string(row["interior_vertices"].get<int>()),
         step("bodies"), bench::number(steps["split"].get<double>() + steps["segments"].get<double>(), 1),
         step("triangulate"), step("regions"), step("clip"), step("assemble"), step("pieces"),
         bench::number(wall("cut"), 1), bench::number(row["cut"]["processor_ms"], 1), bench::number(wall("draft"), 1),
         bench::number(wall("final"), 1), bench::number(wall("solids"), 1), bench::number(rest + wall("draft"), 1),
         bench::number(rest + wall("final"), 1), bench::number(row["peak_megabytes"], 0)});
  }
  std::printf("Milliseconds by the clock, medians.\n\n%s", bench::markdown(table).c_str());
}

int make_report(const Settings& settings) {
  Json rows = Json::array();
  for (const std::string& name : settings.names) {
    for (Json& row : measured_apart(name, settings)) rows.push_back(std::move(row));
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
  CLI::App app("The whole cut, stage by stage");
  Settings settings;
  app.add_option("FRUIT", settings.names,
                 "Names of templates, and \"bench\" for the seeded fruit; all if none is given");
  app.add_option("--runs", settings.runs, "Runs to take the median of")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--triangles", settings.triangles, "About so many triangles a fruit; 0 = as the template asks for")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  app.add_option("--threads", settings.threads.count, "0 = all there are")->capture_default_str();
  app.add_flag("--json", settings.json, "Print JSON");
  CLI11_PARSE(app, argc, argv);
  if (settings.names.empty()) {
    settings.names = bench::fruit_names();
    settings.names.insert(settings.names.begin(), "bench");
  }
  return bench::exit_status_of([&] { return make_report(settings); });
}
