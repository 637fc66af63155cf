// Thousands of variants: whether anything crosses, stays open or is connected otherwise; whether folds and loops have
// the statistics of the samples; how different variants are, and whether species vary independently.
// docs/reports/variation.md shows what it prints.
//   variants [FRUIT...] [--count N] [--natural] [--out FILE] [--json FILE] [--threads N]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/earlier_rows.h"
#include "bench/exit_status.h"
#include "bench/fold_statistics.h"
#include "bench/fruits.h"
#include "bench/loop_statistics.h"
#include "bench/species_correlation.h"
#include "bench/text_table.h"
#include "bench/variant_checks.h"
#include "bench/variant_distances.h"
#include "cli/deliver/progress.h"
#include "generator/base/parallel.h"
#include "generator/template/read/read_template.h"
#include "render/export/output.h"

namespace {

using namespace pomona;
using namespace pomona::bench;
using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> fruits;
  int count = 1000;
  bool natural_only = false;
  std::string out, json;
  int threads = 0;
};

/// The least distance of two variants at variation 1, in percent of the size.
constexpr double stated_distance = 0.01;

/// Max correlation of the sizes or proportions of two species over this many seeds or more.
constexpr double stated_correlation = 0.15;
constexpr int seeds_for_correlation = 1000;

std::vector<VariantFacts> all_facts(const VariantChecks& checks, const VariantSettings& settings, Threads threads) {
  std::vector<VariantFacts> facts(static_cast<std::size_t>(settings.count));
  parallel_for(facts.size(), threads, [&](std::size_t i) { facts[i] = checks.facts(static_cast<int>(i) + 1); });
  return facts;
}

/// The faults of variants, each with the number of variants that have it.
Json defects_of(const std::vector<VariantFacts>& facts) {
  int crossing_curves = 0, crossing_surfaces = 0, open = 0, connected_otherwise = 0;
  std::map<std::string, int> where, max;
  for (const VariantFacts& variant : facts) {
    crossing_curves += !variant.crossing_curves.empty();
    crossing_surfaces += !variant.crossings.empty();
    open += variant.open_shells > 0;
    connected_otherwise += !variant.connected_as_drawn;
    for (const std::string& name : variant.crossing_curves) ++where["curve " + name];
    for (const auto& [pair, triangles] : variant.crossings) {
      ++where[pair];
      max[pair] = std::max(max[pair], triangles);
    }
  }
  Json list = Json::array();
  for (const auto& [name, variants] : where) {
    list.push_back({{"what", name}, {"variants", variants}, {"most_triangle_pairs", max[name]}});
  }
  return {{"crossing_curves", crossing_curves},
          {"crossing_surfaces", crossing_surfaces},
          {"open", open},
          {"connected_otherwise", connected_otherwise},
          {"list", list}};
}

Json folds_of(const std::vector<VariantFacts>& facts) {
  int folds = 0, stepped = 0, mean = 0, unsound = 0;
  for (const VariantFacts& variant : facts) {
    for (const FoldReport& fold : variant.folds) {
      ++folds;
      stepped += fold.rung > 0;
      mean += fold.rung >= 11;
      unsound += !fold.sound;
    }
  }
  return {{"folds", folds}, {"stepped", stepped}, {"mean_or_drawn", mean}, {"unsound", unsound}};
}

Json distances_of(const VariantChecks& checks, const std::vector<VariantFacts>& facts) {
  std::vector<std::vector<glm::vec3>> positions;
  for (const VariantFacts& variant : facts) positions.push_back(variant.some_positions);
  const VariantDistances distances =
      distances_between(positions, [&](int variant) { return checks.positions(variant + 1); });
  const double percent = 100 / checks.size();
  return {{"least_percent", distances.min * percent},
          {"mean_percent", distances.mean * percent},
          {"nearest_seeds", {distances.first + 1, distances.second + 1}}};
}

Json json_of(const FoldStatistics& s) {
  return {{"mean_error", s.mean_error},
          {"expected_mean_error", s.expected_mean_error},
          {"covariance_error", s.covariance_error},
          {"expected_covariance_error", s.expected_covariance_error},
          {"unclipped", s.unclipped},
          {"clipped", s.clipped},
          {"stepped", s.stepped},
          {"joined", s.joined},
          {"mean_shift", s.mean_shift}};
}

Json json_of(const LoopStatistics& s) {
  return {{"mean_shift", s.mean_shift},        {"least_deviation", s.min_deviation}, {"deviation", s.deviation},
          {"most_deviation", s.max_deviation}, {"drawn_power", s.drawn_power},       {"power", s.power}};
}

/// One line of the report.
Json measured(const std::string& name, const Template& fruit, const VariantSettings& settings, Threads threads) {
  const VariantChecks checks(fruit, settings);
  const std::vector<VariantFacts> facts = all_facts(checks, settings, threads);
  double vary_milliseconds = 0, sweep_milliseconds = 0;
  for (const VariantFacts& variant : facts) {
    vary_milliseconds += variant.vary_milliseconds / settings.count;
    sweep_milliseconds += variant.sweep_milliseconds / settings.count;
  }
  Json row = {{"fruit", name},
              {"variation", settings.how.amount},
              {"folds", settings.how.folds.value_or(0)},
              {"variants", settings.count},
              {"triangles", checks.triangle_count()},
              {"open_shells_as_drawn", checks.open_shells()},
              {"defects", defects_of(facts)},
              {"distance", distances_of(checks, facts)},
              {"vary_milliseconds", vary_milliseconds},
              {"sweep_milliseconds", sweep_milliseconds}};
  for (const VariantFacts& variant : facts) {
    row["size"].push_back(variant.size);
    row["slenderness"].push_back(variant.slenderness);
  }
  if (std::holds_alternative<CylindricalSymmetry>(fruit.symmetry)) {
    std::vector<std::vector<LoopShape>> loops;
    for (const VariantFacts& variant : facts) loops.push_back(variant.loops);
    const std::vector<LoopShape> drawn = loop_shapes(fruit);
    if (!drawn.empty()) row["loops"] = json_of(loop_statistics(drawn, loops));
  } else if (std::holds_alternative<FoldSymmetry>(fruit.symmetry)) {
    row["steps"] = folds_of(facts);
    row["blends"] = json_of(fold_statistics(fruit, settings, facts));
  }
  return row;
}

/// Natural, wild, and with other folds than drawn. Nothing where all variants are alike.
std::vector<VariantSettings> settings_for(const Template& fruit, int count, bool natural_only) {
  if (std::holds_alternative<NoSymmetry>(fruit.symmetry)) return {};
  if (natural_only) return {{count, {.amount = 1}}};
  const int some = std::max(2, count / 5), few = std::max(2, count / 10);
  std::vector<VariantSettings> all = {{count, {.amount = 1}}, {some, {.amount = 2}}};
  if (std::holds_alternative<FoldSymmetry>(fruit.symmetry)) {
    const int folds = fold_count(fruit);
    if (folds > 1) all.push_back({few, {.amount = 1, .folds = folds - 1}});
    all.push_back({few, {.amount = 1, .folds = folds + 2}});
  }
  return all;
}

bool is_natural(const Json& row) { return row["variation"].get<double>() == 1 && row["folds"].get<int>() == 0; }

std::string label(const Json& row) {
  std::string text = row["fruit"];
  const int folds = row["folds"];
  const double variation = row["variation"];
  if (variation != 1) text += ", --variation " + number(variation, 0);
  if (folds != 0) text += ", --folds " + std::to_string(folds);
  return text;
}

std::string share(const Json& row, const char* of, const char* in) {
  const double all = row["steps"][in];
  return number(100 * row["steps"][of].get<double>() / all, 1);
}

/// Numbers of defects, which must be 0, and distances of variants.
TextTable soundness(const std::vector<Json>& rows) {
  TextTable table{{"", "variants", "triangles", "with crossing curves", "with new crossings", "open",
                   "connected otherwise", "folds stepped down %", "least distance %", "mean %", "vary ms", "sweep ms"},
                  {}};
  for (const Json& row : rows) {
    const Json& defects = row["defects"];
    const auto count = [&](const char* key) { return std::to_string(defects[key].get<int>()); };
    table.rows.push_back({label(row), std::to_string(row["variants"].get<int>()),
                          std::to_string(row["triangles"].get<int>()), count("crossing_curves"),
                          count("crossing_surfaces"), count("open"), count("connected_otherwise"),
                          row.contains("steps") ? share(row, "stepped", "folds") : "-",
                          number(row["distance"]["least_percent"], 3), number(row["distance"]["mean_percent"], 2),
                          number(row["vary_milliseconds"], 1), number(row["sweep_milliseconds"], 1)});
  }
  return table;
}

/// For natural variants; `quantity` is "size" or "slenderness".
std::vector<SpeciesPair> correlations(const std::vector<Json>& rows, const char* quantity) {
  std::vector<SpeciesSeries> species;
  for (const Json& row : rows) {
    if (!is_natural(row)) continue;
    species.push_back({row["fruit"], row[quantity].get<std::vector<double>>()});
    if (species.back().values.size() != species.front().values.size()) return {};
  }
  return max_correlated(species);
}

TextTable independence(const std::vector<Json>& rows) {
  TextTable table{{"", "of size, most", "with", "of height over width, most", "with"}, {}};
  const std::vector<SpeciesPair> size = correlations(rows, "size"), slenderness = correlations(rows, "slenderness");
  for (std::size_t i = 0; i < std::min(size.size(), slenderness.size()); ++i) {
    table.rows.push_back({size[i].first, number(size[i].correlation, 3), size[i].second,
                          number(slenderness[i].correlation, 3), slenderness[i].second});
  }
  return table;
}

bool vary_by_themselves(const std::vector<Json>& rows) {
  for (const char* quantity : {"size", "slenderness"}) {
    for (const SpeciesPair& pair : correlations(rows, quantity)) {
      if (std::abs(pair.correlation) > stated_correlation) return false;
    }
  }
  return true;
}

/// Percent throughout.
TextTable blending(const std::vector<Json>& rows) {
  TextTable table{{"", "mean: error", "by chance", "covariance: error", "by chance", "variance unclipped", "clipped",
                   "stepped down", "joined", "shift of the mean"},
                  {}};
  for (const Json& row : rows) {
    if (!row.contains("blends") || !is_natural(row)) continue;
    std::vector<std::string> cells = {row["fruit"]};
    for (const char* key : {"mean_error", "expected_mean_error", "covariance_error", "expected_covariance_error",
                            "unclipped", "clipped", "stepped", "joined", "mean_shift"}) {
      cells.push_back(number(100 * row["blends"][key].get<double>(), 1));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Power in percent of the drawing's.
TextTable synthesis(const std::vector<Json>& rows) {
  TextTable table{{"", "shift of the mean %", "deviation over the drawn", "least", "most", "harmonics 1-3: drawn",
                   "variants", "4-15: drawn", "variants", "16-63: drawn", "variants"},
                  {}};
  for (const Json& row : rows) {
    if (!row.contains("loops")) continue;
    const Json& s = row["loops"];
    std::vector<std::string> cells = {label(row), number(100 * s["mean_shift"].get<double>(), 2),
                                      number(s["deviation"], 2), number(s["least_deviation"], 2),
                                      number(s["most_deviation"], 2)};
    for (std::size_t band = 0; band < 3; ++band) {
      cells.push_back(number(100 * s["drawn_power"][band].get<double>(), 2));
      cells.push_back(number(100 * s["power"][band].get<double>(), 2));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string defect_list(const std::vector<Json>& rows) {
  std::string text;
  for (const Json& row : rows) {
    for (const Json& defect : row["defects"]["list"]) {
      text += "- " + label(row) + ": " + defect["what"].get<std::string>() + " in " +
              std::to_string(defect["variants"].get<int>()) + " variants, up to " +
              std::to_string(defect["most_triangle_pairs"].get<int>()) + " pairs of triangles\n";
    }
  }
  return text.empty() ? "None.\n" : text;
}

std::string text_of(const std::vector<Json>& rows) {
  std::vector<Json> natural, other;
  for (const Json& row : rows) (is_natural(row) ? natural : other).push_back(row);
  return "Natural variants (--variation 1)\n\n" + markdown(soundness(natural)) +
         "\nWild variants, and other numbers of folds\n\n" + markdown(soundness(other)) + "\nBlended folds, %\n\n" +
         markdown(blending(rows)) + "\nSynthesised loops\n\n" + markdown(synthesis(rows)) +
         "\nCorrelation between species at equal seeds\n\n" + markdown(independence(rows)) +
         "\nWhat crosses that does not as drawn\n\n" + defect_list(rows);
}

/// The rows that an earlier run has left.
bool is_of(const Json& row, const std::string& name, const VariantSettings& settings) {
  return row["fruit"].get<std::string>() == name && row["variants"].get<int>() == settings.count &&
         row["variation"].get<double>() == settings.how.amount &&
         row["folds"].get<int>() == settings.how.folds.value_or(0);
}

/// True if the variants of this line are sound. Distances are only promised for natural variants.
bool is_sound(const Json& row) {
  const Json& defects = row["defects"];
  for (const char* key : {"crossing_curves", "crossing_surfaces", "open", "connected_otherwise"}) {
    if (defects[key].get<int>() != 0) return false;
  }
  return !is_natural(row) || row["distance"]["least_percent"].get<double>() >= stated_distance;
}

int make_report(const Options& options) {
  std::vector<Json> known = earlier_rows(options.json), rows;
  Progress progress(false);
  const std::vector<std::string> names = fruit_names(options.fruits);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Template fruit = read_template(template_path(names[i]));
    for (const VariantSettings& settings : settings_for(fruit, options.count, options.natural_only)) {
      const auto same = [&](const Json& row) { return is_of(row, names[i], settings); };
      const auto found = std::find_if(known.begin(), known.end(), same);
      rows.push_back(found != known.end() ? *found : measured(names[i], fruit, settings, {options.threads}));
      if (found != known.end()) continue;
      known.push_back(rows.back());
      if (!options.json.empty()) write_whole(options.json, Json(known).dump(2) + "\n");
    }
    progress.report("fruits", i + 1, names.size());
  }
  const std::string text = text_of(rows);
  if (!options.out.empty()) write_whole(options.out, text);
  std::printf("%s", text.c_str());
  const bool independent = options.count < seeds_for_correlation || vary_by_themselves(rows);
  return independent && std::all_of(rows.begin(), rows.end(), is_sound) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("What a thousand variants of each fruit show. Exits with 1 if any is not sound");
  Options options;
  app.add_option("FRUIT", options.fruits, "Names of templates; all of them if none is given");
  app.add_option("--count", options.count, "Variants of each; a fifth of them wild, a tenth with other folds")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  app.add_flag("--natural", options.natural_only, "No wild ones, and none with other folds");
  app.add_option("--out", options.out, "Write the tables to this file too");
  app.add_option("--json", options.json, "Write the figures to this file as JSON; lines already there are kept");
  app.add_option("--threads", options.threads, "0 = all there are")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return exit_status_of([&] { return make_report(options); });
}
