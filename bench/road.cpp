// All stages of one item: a new variant of each template, cut, as the bytes of a .glb with vertex colours; on one
// thread.
//   road [--seeds N] [--runs N] [--quality draft|final] [--knife KNIFE] [--json] [NAME...]
// Each template and quality is measured in a process of its own, so that its peak of memory is its own.
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/own_process.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "generator/base/free_memory.h"
#include "generator/base/stage_clock.h"
#include "generator/compose/grow.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "generator/scene/scene.h"
#include "generator/template/read/read_template.h"
#include "render/export/gltf/write_glb.h"
#include "render/style/style_file.h"

namespace {

using namespace pomona;
using Json = nlohmann::ordered_json;

struct Settings {
  int seeds = 5;
  int runs = 3;
  std::vector<std::string> qualities;
  std::string knife = "half";
  bool json = false;
  std::vector<std::string> names;
};

/// In the order in which they run. "ready" is what a template needs once for all of its variants.
const std::vector<std::string> stages = {"read", "ready", "vary", "sweep", "cut", "diffuse", "style", "write"};

/// One item, in milliseconds: each stage by the clock, and the whole by the processor, including freeing memory.
struct ItemTimes {
  StageClock stages;
  double processor = 0;
};

/// All that `pomona cut` does for one fruit, except writing to the disk.
StageClock walk_road(const std::string& name, std::uint64_t seed, const Knife& knife, const Diffuser& diffuser) {
  StageClock clock;
  const VariantKey key{seed, 0};
  const std::vector<Knife> knives{knife};
  const Template drawn = clock.time("read", [&] { return read_template(bench::template_path(name)); });
  const Variation ready = clock.time("ready", [&] { return Variation(drawn); });
  const Template fruit = clock.time("vary", [&] { return variant_of(ready, key); });
  const GrownFruit grown = clock.time("sweep", [&] { return grow(fruit, key, {.threads = {1}}); });
  Slices slices = slice({grown, fruit, knives, name}, &diffuser, {.cut = {.threads = {1}}, .threads = {1}});
  clock.add(slices.times);
  const std::string bytes = clock.time("write", [&] {
    return write_glb(gathered(std::move(slices.pieces)), {.style = style_named("ink"), .threads = {1}});
  });
  return clock;
}

/// The quickest of several runs, because other programs use the machine, too.
ItemTimes quickest(const std::string& name, std::uint64_t seed, Quality quality, const Settings& settings) {
  const auto diffuser = make_pmvc_diffuser({quality, {1}});
  const Knife knife = parse_knife(settings.knife);
  ItemTimes best;
  for (int run = 0; run < settings.runs; ++run) {
    StageClock clock;
    const bench::Duration spent = bench::time_of([&] { clock = walk_road(name, seed, knife, *diffuser); });
    if (run == 0 || spent.processor < best.processor) best = {clock, spent.processor};
  }
  return best;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The medians of one template: each column's over the seeds.
Json measured(const std::string& name, Quality quality, const Settings& settings) {
  std::map<std::string, std::vector<double>> times;
  for (int seed = 1; seed <= settings.seeds; ++seed) {
    const ItemTimes item = quickest(name, static_cast<std::uint64_t>(seed), quality, settings);
    double sum = 0;
    for (const auto& [stage, milliseconds] : item.stages.stages()) sum += milliseconds;
    // Stages are timed by the clock, which other programs slow down, so their shares of the processor time are used.
    for (const auto& [stage, milliseconds] : item.stages.stages())
      times[stage].push_back(milliseconds / sum * item.processor);
    times["all"].push_back(item.processor);
  }
  Json row = {{"fruit", name}};
  for (const auto& [stage, milliseconds] : times) row[stage] = median(milliseconds);
  row["megabytes"] = bench::peak_megabytes();
  return row;
}

void print(const std::string& quality, const Json& rows, const Settings& settings) {
  // The columns: the stages, their sum, memory.
  std::vector<std::pair<std::string, std::string>> columns;
  for (const std::string& stage : stages) columns.emplace_back(stage, stage);
  columns.emplace_back("all", "all");
  columns.emplace_back("megabytes", "MB");
  bench::TextTable table{{"fruit"}, {}};
  for (const auto& [key, title] : columns) table.head.push_back(title);

  // A row for each fruit, and their mean.
  std::map<std::string, double> sums;
  for (const Json& row : rows) {
    std::vector<std::string> cells = {row["fruit"]};
    for (const auto& [key, title] : columns) {
      const double value = row[key].get<double>();
      sums[key] += value;
      cells.push_back(bench::number(value, value < 10 ? 1 : 0));
    }
    table.rows.push_back(std::move(cells));
  }
  std::vector<std::string> means = {"mean"};
  for (const auto& [key, title] : columns)
    means.push_back(bench::number(sums[key] / static_cast<double>(rows.size()), 1));
  table.rows.push_back(std::move(means));
  std::printf("%s, cut %s, one thread: milliseconds of the processor, medians over %d seeds.\n\n%s\n", quality.c_str(),
              settings.knife.c_str(), settings.seeds, bench::markdown(table).c_str());
}

int make_report(const Settings& settings) {
  Json report;
  for (const std::string& quality : settings.qualities) {
    Json rows = Json::array();
    for (const std::string& name : bench::fruit_names(settings.names)) {
      const Quality how = quality == "final" ? Quality::final : Quality::draft;
      rows.push_back(Json::parse(bench::in_own_process([&] { return measured(name, how, settings).dump(); })));
    }
    if (!settings.json) print(quality, rows, settings);
    report[quality] = std::move(rows);
  }
  if (settings.json) std::printf("%s\n", report.dump(2).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("The whole road of one item, stage by stage, on one thread");
  Settings settings;
  app.add_option("FRUIT", settings.names, "Names of templates; all if none is given");
  app.add_option("--seeds", settings.seeds, "From 1 to this")->check(CLI::Range(1, 1000))->capture_default_str();
  app.add_option("--runs", settings.runs, "Of each seed; the quickest counts")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("--quality", settings.qualities, "draft or final; both if not given")
      ->check(CLI::IsMember({"draft", "final"}))
      ->allow_extra_args(false);
  app.add_option("--knife", settings.knife, "What cuts it")->capture_default_str();
  app.add_flag("--json", settings.json, "Print JSON");
  CLI11_PARSE(app, argc, argv);
  keep_free_memory();  // as the program does
  if (settings.qualities.empty()) settings.qualities = {"draft", "final"};
  return bench::exit_status_of([&] { return make_report(settings); });
}
