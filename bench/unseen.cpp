// Seeds that nobody has chosen: measures whether each fruit's halves and sections across are as good as the drawing's.
// docs/reports/unseen.md shows what it prints; scripts/unseen_sheet.py shows the worst as pictures.
//   unseen [FRUIT...] [--seeds 1-200] [--out FILE] [--json FILE] [--worst FILE] [--threads N]
#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/earlier_rows.h"
#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "bench/unseen_facts.h"
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
  std::string seeds = "1-200";
  std::string out, json, worst;
  int threads = 0;
};

/// What an unseen fruit is held to.
constexpr double short_side =
    0.5;  ///< min area of a part on a side, relative to the drawing's side that has less of it
constexpr double least_part = 0.003;   ///< parts with a smaller share of the drawn section are not regarded
constexpr double stated_drift = 5;     ///< max change of a tissue's colour differences, in 255ths
constexpr double stated_growth = 1.6;  ///< max factor between the diagonals of a variant and the drawing
constexpr double few_specks = 5;       ///< so many more than twice what is usual are too many

struct SeedRange {
  int first = 1, last = 200;
};

SeedRange range_of(const std::string& text) {
  SeedRange range;
  if (std::sscanf(text.c_str(), "%d-%d", &range.first, &range.last) != 2) range.last = range.first;
  return range;
}

Json json_of(const FaceFacts& face) {
  Json sides = Json::object();
  for (const auto& [part, shares] : face.sides) sides[part] = {shares.first, shares.second};
  return {{"area", face.area}, {"specks", face.specks}, {"sides", sides}};
}

/// The measurements of one fruit as they are kept in the file. Faults are computed from them in every run.
Json row_of(const std::string& name, int seed, const UnseenFacts& facts) {
  return {{"fruit", name},
          {"seed", seed},
          {"folds", facts.folds},
          {"diagonal", facts.diagonal},
          {"half", json_of(facts.half)},
          {"across", json_of(facts.across)},
          {"grains", facts.grains},
          {"crossings", facts.crossings},
          {"chambers", facts.chambers},
          {"empty_chambers", facts.empty_chambers},
          {"drift", facts.worst_drift.drift},
          {"drifting", {facts.worst_drift.first, facts.worst_drift.second}}};
}

/// A part that the half lacks on one side, and its area there relative to the drawing's side that has less of it.
struct Lack {
  std::string part;
  double share = 1;
};

/// What a half should show: the inner parts, and those of them that it may miss on one side.
struct PartsToShow {
  std::vector<std::string> inner;
  std::set<std::string> in_folds;
};

/// Both sides of parts that no fold holds count together, as two equal ones.
double lesser_side(const Json& row, const std::string& part, const PartsToShow& parts) {
  const Json& sides = row["half"]["sides"];
  if (!sides.contains(part)) return 0;
  const double left = sides[part][0], right = sides[part][1];
  return row["folds"] == 1 || !parts.in_folds.contains(part) ? 0.5 * (left + right) : std::min(left, right);
}

/// The inner part of which the half has least, compared with the drawing.
Lack worst_lack(const Json& row, const Json& drawn, const PartsToShow& parts) {
  Lack worst;
  for (const std::string& part : parts.inner) {
    const double least = lesser_side(drawn, part, parts);
    if (least < least_part / 3) continue;
    const Json& sides = drawn["half"]["sides"][part];
    if (sides[0].get<double>() + sides[1].get<double>() < least_part) continue;
    const double share = lesser_side(row, part, parts) / least;
    if (share < worst.share) worst = {part, share};
  }
  return worst;
}

/// Of the half and of the section across.
double specks_of(const Json& row) {
  return row["half"]["specks"].get<double>() + row["across"]["specks"].get<double>();
}

/// By how much it is larger or smaller than the drawing.
double growth(const Json& row, const Json& drawn) {
  const double ratio = row["diagonal"].get<double>() / drawn["diagonal"].get<double>();
  return std::max(ratio, 1 / ratio);
}

/// By name, each 0 if the fruit is sound.
using Faults = std::map<std::string, double>;

struct Fruit {
  std::string name;
  PartsToShow parts;
  std::vector<Json> rows;      ///< the drawing first
  std::vector<Faults> faults;  ///< of each row
};

double median_specks(const Fruit& fruit) {
  std::vector<double> specks;
  for (std::size_t i = 1; i < fruit.rows.size(); ++i) specks.push_back(specks_of(fruit.rows[i]));
  if (specks.empty()) return 0;
  const auto middle = specks.begin() + static_cast<std::ptrdiff_t>(specks.size() / 2);
  std::nth_element(specks.begin(), middle, specks.end());
  return *middle;
}

/// Usual is what the drawing has, or half of all seeds: the drawing is but one draw of where organs sit. The median is
/// itself held to the drawing.
double most_specks(const Fruit& fruit) {
  const auto most = [](double usual) { return 2 * usual + few_specks; };
  const double drawn = specks_of(fruit.rows.front()), median = median_specks(fruit);
  return median <= most(drawn) ? most(std::max(drawn, median)) : most(drawn);
}

std::vector<Faults> faults_of(const Fruit& fruit) {
  const Json& drawn = fruit.rows.front();
  const double specks_allowed = most_specks(fruit);
  std::vector<Faults> faults;
  for (const Json& row : fruit.rows) {
    const Lack lack = worst_lack(row, drawn, fruit.parts);
    // Chambers may be empty where the drawing has empty ones.
    const double empty = drawn["empty_chambers"] == 0 ? row["empty_chambers"].get<double>() : 0;
    const double specks = specks_of(row), drift = row["drift"], grown = growth(row, drawn);
    faults.push_back({{"size", grown > stated_growth ? grown : 0},
                      {"short", lack.share < short_side ? 1 - lack.share : 0},
                      {"crossings", row["crossings"].get<double>()},
                      {"empty", empty},
                      {"drift", drift > stated_drift ? drift : 0},
                      {"specks", specks > specks_allowed ? specks : 0}});
  }
  return faults;
}

Json measured_row(const UnseenFruit& fruit, const std::string& name, int seed) {
  return row_of(name, seed, fruit.facts(seed));
}

/// Rows by fruit and seed.
using KnownRows = std::map<std::pair<std::string, int>, Json>;

/// All rows of one template, those in `known` as they are.
std::vector<Json> rows_of(const std::string& name, const UnseenFruit& fruit, const SeedRange& range,
                          const KnownRows& known, Threads threads) {
  std::vector<int> seeds{0};
  for (int seed = range.first; seed <= range.last; ++seed) seeds.push_back(seed);
  std::vector<Json> rows(seeds.size());
  parallel_for(seeds.size(), threads, [&](std::size_t i) {
    const auto found = known.find({name, seeds[i]});
    rows[i] = found != known.end() ? found->second : measured_row(fruit, name, seeds[i]);
  });
  return rows;
}

struct FaultySeed {
  double by = 0;
  int seed = 0;
};

/// The seeds with this fault, the worst first.
std::vector<FaultySeed> faulty_seeds(const Fruit& fruit, const std::string& fault) {
  std::vector<FaultySeed> faulty;
  for (std::size_t i = 1; i < fruit.rows.size(); ++i) {
    const double by = fruit.faults[i].at(fault);
    if (by > 0) faulty.push_back({by, fruit.rows[i]["seed"].get<int>()});
  }
  std::stable_sort(faulty.begin(), faulty.end(), [](const auto& a, const auto& b) { return a.by > b.by; });
  return faulty;
}

std::string worst_seeds(const Fruit& fruit, const std::string& fault) {
  const std::vector<FaultySeed> faulty = faulty_seeds(fruit, fault);
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(faulty.size(), 3); ++i)
    text += " " + std::to_string(faulty[i].seed);
  return std::to_string(faulty.size()) + (text.empty() ? "" : ":" + text);
}

double mean(const Fruit& fruit, const char* key) {
  double sum = 0;
  for (std::size_t i = 1; i < fruit.rows.size(); ++i) sum += fruit.rows[i][key].get<double>();
  return sum / static_cast<double>(std::max<std::size_t>(1, fruit.rows.size() - 1));
}

/// The part that halves lack most often.
std::string most_lacking(const Fruit& fruit) {
  std::map<std::string, int> count;
  for (std::size_t i = 1; i < fruit.rows.size(); ++i) {
    const Lack lack = worst_lack(fruit.rows[i], fruit.rows.front(), fruit.parts);
    if (lack.share < short_side) ++count[lack.part];
  }
  std::string most = "-";
  int most_often = 0;
  for (const auto& [part, times] : count)
    if (times > most_often) most = part, most_often = times;
  return most;
}

double worst_of(const Fruit& fruit, const char* key) {
  double most = 0;
  for (const Json& row : fruit.rows) most = std::max(most, row[key].get<double>());
  return most;
}

double most_growth(const Fruit& fruit) {
  double most = 1;
  for (const Json& row : fruit.rows) most = std::max(most, growth(row, fruit.rows.front()));
  return most;
}

TextTable table_of(const std::vector<Fruit>& fruits) {
  TextTable table{
      {"", "seeds", "out of size", "most, times", "short of a part", "most often", "with grains crossed", "crossed of",
       "a fruit", "with an empty chamber", "tissues apart", "most, of 255", "with specks", "specks, drawn", "median"},
      {}};
  for (const Fruit& fruit : fruits) {
    table.rows.push_back({fruit.name, std::to_string(fruit.rows.size() - 1), worst_seeds(fruit, "size"),
                          number(most_growth(fruit), 2), worst_seeds(fruit, "short"), most_lacking(fruit),
                          worst_seeds(fruit, "crossings"), number(mean(fruit, "crossings"), 1),
                          number(mean(fruit, "grains"), 0), worst_seeds(fruit, "empty"), worst_seeds(fruit, "drift"),
                          number(worst_of(fruit, "drift"), 1), worst_seeds(fruit, "specks"),
                          number(specks_of(fruit.rows.front()), 0), number(median_specks(fruit), 0)});
  }
  return table;
}

/// Number of variants with any fault.
int fallen_out(const std::vector<Fruit>& fruits) {
  int fallen = 0;
  for (const Fruit& fruit : fruits) {
    for (std::size_t i = 1; i < fruit.rows.size(); ++i) {
      const Faults& faults = fruit.faults[i];
      fallen += std::any_of(faults.begin(), faults.end(), [](const auto& fault) { return fault.second > 0; });
    }
  }
  return fallen;
}

/// The worst fruits by each number, at most two of a template: for pictures of them.
Json worst_fruits(const std::vector<Fruit>& fruits) {
  constexpr std::size_t of_all = 10, of_one = 2;
  Json list = Json::array();
  for (const char* fault : {"size", "short", "crossings", "empty", "drift", "specks"}) {
    std::vector<std::tuple<double, std::string, int>> worst;
    for (const Fruit& fruit : fruits) {
      const std::vector<FaultySeed> faulty = faulty_seeds(fruit, fault);
      for (std::size_t i = 0; i < std::min(faulty.size(), of_one); ++i)
        worst.emplace_back(-faulty[i].by, fruit.name, faulty[i].seed);
    }
    std::sort(worst.begin(), worst.end());
    worst.resize(std::min(worst.size(), of_all));
    for (const auto& [by, name, seed] : worst)
      list.push_back({{"number", fault}, {"fruit", name}, {"seed", seed}, {"by", -by}});
  }
  return list;
}

int make_report(const Options& options) {
  KnownRows known;
  const auto keep = [&](const Json& row) { known.insert_or_assign({row["fruit"], row["seed"]}, row); };
  for (const Json& row : earlier_rows(options.json)) keep(row);
  std::vector<Fruit> fruits;
  Progress progress(false);
  const std::vector<std::string> names = fruit_names(options.fruits);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Template fruit = read_template(template_path(names[i]));
    if (std::holds_alternative<NoSymmetry>(fruit.symmetry)) continue;  // nothing varies
    const UnseenFruit unseen(fruit);
    fruits.push_back({names[i],
                      {unseen.inner_parts(), unseen.parts_in_folds()},
                      rows_of(names[i], unseen, range_of(options.seeds), known, {options.threads}),
                      {}});
    fruits.back().faults = faults_of(fruits.back());
    for (const Json& row : fruits.back().rows) keep(row);
    Json all = Json::array();
    for (const auto& [key, row] : known) all.push_back(row);
    if (!options.json.empty()) write_whole(options.json, all.dump() + "\n");
    progress.report("fruits", i + 1, names.size());
  }
  const int fallen = fallen_out(fruits);
  const std::string text = markdown(table_of(fruits)) + "\n" + std::to_string(fallen) + " fruits fall out.\n";
  if (!options.out.empty()) write_whole(options.out, text);
  if (!options.worst.empty()) write_whole(options.worst, worst_fruits(fruits).dump(1) + "\n");
  std::printf("%s", text.c_str());
  return fallen == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("What seeds that nobody has chosen show. Exits with 1 if any falls out");
  Options options;
  app.add_option("FRUIT", options.fruits, "Names of templates; all of them if none is given");
  app.add_option("--seeds", options.seeds, "First and last, as in 101-140")->capture_default_str();
  app.add_option("--out", options.out, "Write the table to this file too");
  app.add_option("--json", options.json, "Write the figures to this file as JSON; rows already there are kept");
  app.add_option("--worst", options.worst, "Write the worst by each number to this file as JSON");
  app.add_option("--threads", options.threads, "0 = all there are")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return exit_status_of([&] { return make_report(options); });
}
