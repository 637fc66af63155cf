// A hundred thousand random and difficult cuts of every template at about 2 000 triangles: nothing aborts, no chain and
// no piece is open, areas and volumes agree with clipping triangles one by one.
// And thousands of cuts of turned blocks along their own faces.
//   cuts [FRUIT...] [--random N] [--degenerate N] [--pairs N] [--strokes N] [--solids N] [--peels N] [--blocks N]
//   [--triangles N] [--out FILE] [--json FILE] [--threads N]
#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/earlier_rows.h"
#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "cli/deliver/progress.h"
#include "generator/base/parallel.h"
#include "generator/knife/parse_knife.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/weld.h"
#include "generator/surface/bodies.h"
#include "render/export/output.h"
#include "tests/cut/cut_oracle.h"
#include "tests/cut/turned_blocks.h"

namespace {

using namespace pomona;
using namespace pomona::bench;
using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> fruits;
  int random = 80000, degenerate = 10000, pairs = 10000, strokes = 10000, solids = 2200, peels = 440, blocks = 20000;
  int triangles = 2000;
  std::string out, json;
  int threads = 0;
};

/// Errors allowed, relative: of areas, of volumes, and of volumes cut by curved solids and peels.
constexpr double max_area_error = 1e-9, max_volume_error = 1e-6, max_curved_volume_error = 1e-5;

/// The number of cuts between two saves of the figures.
constexpr int chunk = 250;

/// The triangles that stay, with all vertices.
DiffusionSurfaces with_only(const DiffusionSurfaces& fruit, const std::function<bool(std::size_t triangle)>& stays) {
  DiffusionSurfaces kept = fruit;
  std::size_t to = 0;
  for (std::size_t t = 0; t < fruit.triangle_count(); ++t) {
    if (!stays(t)) continue;
    kept.triangle[to] = fruit.triangle[t];
    kept.surface[to] = fruit.surface[t];
    kept.front_part[to] = fruit.front_part[t];
    kept.back_part[to++] = fruit.back_part[t];
  }
  kept.triangle.resize(to);
  for (auto* indices : {&kept.surface, &kept.front_part, &kept.back_part}) indices->resize(to);
  kept.instance.clear();  // cuts do not ask for it
  return kept;
}

/// Removes small parts (grains) until about `triangles` are left, if possible: all large parts stay, and every n-th
/// small one.
DiffusionSurfaces thinned(const DiffusionSurfaces& fruit, int triangles) {
  const std::vector<std::uint32_t> welded = weld(fruit.position);
  DisjointSets parts(fruit.vertex_count());
  for (const glm::uvec3& t : fruit.triangle) {
    parts.join(welded[t.x], welded[t.y]);
    parts.join(welded[t.x], welded[t.z]);
  }
  std::map<std::uint32_t, int> size;
  for (const glm::uvec3& t : fruit.triangle) ++size[parts.root(welded[t.x])];
  std::map<std::uint32_t, int> boundary;
  for (std::size_t t = 0; t < fruit.triangle_count(); ++t) {
    if (fruit.is_boundary(t)) ++boundary[parts.root(welded[fruit.triangle[t].x])];
  }
  std::uint32_t skin = 0;  // the largest part of the boundary; parts that are not much smaller stay, too
  for (const auto& [part, count] : boundary) {
    if (count > boundary[skin]) skin = part;
  }
  const int small = std::min(triangles / 10, size[skin] / 8);
  int in_small = 0, in_large = 0;
  for (const auto& [part, count] : size) (count <= small ? in_small : in_large) += count;
  const double share = std::clamp((triangles - in_large) / std::max(1.0, double(in_small)), 0.02, 1.0);

  std::map<std::uint32_t, bool> stays;
  double due = 0.5;
  for (const auto& [part, count] : size) {
    stays[part] = count > small;
    if (count > small) continue;
    due += share;
    stays[part] = due >= 1;
    if (due >= 1) due -= 1;
  }
  return with_only(fruit, [&](std::size_t t) { return stays[parts.root(welded[fruit.triangle[t].x])]; });
}

/// Without cavities that no skin holds: where the skin is this coarse, a few bubbles of a bread lie outside. They bound
/// nothing solid, but their walls would count in the piece that they touch.
DiffusionSurfaces without_lone_walls(const DiffusionSurfaces& fruit) {
  const Bodies bodies = find_bodies(fruit);
  return with_only(fruit, [&](std::size_t t) {
    const std::int32_t body = bodies.of_triangle[t];
    if (body == Bodies::none) return true;
    const Bodies::Body& of = bodies.bodies[static_cast<std::size_t>(body)];
    return !of.closed || of.volume > 0;
  });
}

/// Alternates between a whole peel and one in a strip.
Knife random_peel(double size, const RandomStream& random, std::uint64_t number) {
  PeelKnife peel;
  peel.thickness = size * (0.005 + 0.03 * random.uniform(2 * number));
  if (number % 2 == 1) peel.strip = size * (0.1 + 0.15 * random.uniform(2 * number + 1));
  return {ClosedCut(peel), "a random peel"};
}

std::vector<Knife> knives_of(const oracle::CutOracle& oracle, const std::string& kind, const std::string& fruit,
                             int i) {
  const RandomStream random({6, 0}, "bench/cuts/" + kind + "/" + fruit);
  const auto number = static_cast<std::uint64_t>(i);
  if (kind == "degenerate") return {oracle.degenerate_plane(random, number)};
  if (kind == "random") return {oracle.random_plane(random, number)};
  if (kind == "strokes") return {oracle.random_stroke(random, number)};
  if (kind == "solids") return {oracle.random_solid(random, number)};
  if (kind == "peels") return {random_peel(oracle.size(), random, number)};
  return {oracle.random_plane(random, 2 * number), oracle.random_plane(random, 2 * number + 1)};
}

constexpr const char* block_name = "turned block";

/// Of a turned block, next to its faces.
oracle::CutFacts facts_of_block(std::uint64_t number) {
  const RandomStream random({6, 0}, "bench/cuts/blocks");
  const oracle::BlockFaults faults = oracle::faults_of(oracle::turned_block_cut(random, number));
  oracle::CutFacts facts;
  facts.open_pieces = std::max(faults.open, faults.without_volume);
  facts.volume_error = faults.volume_error;
  return facts;
}

/// Of cut number i.
using FactsOf = std::function<oracle::CutFacts(int i)>;

/// One chunk's figures.
Json measured(const FactsOf& facts_of, const std::string& kind, const std::string& fruit, int first, int count,
              Threads threads) {
  std::vector<oracle::CutFacts> facts(static_cast<std::size_t>(count));
  std::vector<std::string> abort(facts.size());
  std::vector<char> refused(facts.size(), 0);  // of a bunch no peel can be cut: that is told, and no fault
  parallel_for(facts.size(), threads, [&](std::size_t i) {
    try {
      facts[i] = facts_of(first + static_cast<int>(i));
    } catch (const Error& error) {
      refused[i] = kind == "peels" && error.status() == ExitStatus::usage;
      if (!refused[i]) abort[i] = error.what();
    } catch (const std::exception& error) {
      abort[i] = error.what();
    }
  });
  Json row = {{"fruit", fruit}, {"kind", kind}, {"first", first}, {"cuts", count}};
  double area = 0, volume = 0, side = 0;
  int chains = 0, pieces = 0, aborts = 0;
  const double max_volume = kind == "solids" || kind == "peels" ? max_curved_volume_error : max_volume_error;
  Json bad = Json::array(), why = Json::array();
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const oracle::CutFacts& f = facts[i];
    area = std::max(area, f.area_error);
    volume = std::max(volume, f.volume_error);
    side = std::max(side, f.side_error);
    chains += f.open_chains > 0;
    pieces += f.open_pieces > 0;
    aborts += !abort[i].empty();
    const bool sound = abort[i].empty() && f.open_chains == 0 && f.open_pieces == 0 && f.area_error <= max_area_error &&
                       f.volume_error <= max_volume && f.side_error <= max_volume_error;
    if (!sound) bad.push_back(first + static_cast<int>(i));
    if (!abort[i].empty()) why.push_back(abort[i]);
  }
  row.update({{"area_error", area},
              {"volume_error", volume},
              {"side_error", side},
              {"open_chains", chains},
              {"open_pieces", pieces},
              {"aborts", aborts},
              {"refused", std::count(refused.begin(), refused.end(), 1)},
              {"bad", bad},
              {"why", why}});
  return row;
}

bool is_done(const std::vector<Json>& rows, const std::string& fruit, const std::string& kind, int first, int count) {
  return std::any_of(rows.begin(), rows.end(), [&](const Json& row) {
    return row["fruit"] == fruit && row["kind"] == kind && row["first"] == first && row["cuts"] == count;
  });
}

std::string scientific(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

TextTable table_of(const std::vector<Json>& rows) {
  TextTable table{
      {"", "cuts", "refused", "aborts", "open chains", "open pieces", "area", "volume", "volume of one side"}, {}};
  std::vector<std::string> names;
  for (const Json& row : rows) {
    for (const std::string& name : {row["fruit"].get<std::string>() + ", " + row["kind"].get<std::string>(),
                                    "all, " + row["kind"].get<std::string>()}) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    int counts[5] = {};
    double errors[3] = {};
    for (const Json& row : rows) {
      const std::string kind = row["kind"].get<std::string>();
      if (name != row["fruit"].get<std::string>() + ", " + kind && name != "all, " + kind) continue;
      const char* count_keys[] = {"cuts", "refused", "aborts", "open_chains", "open_pieces"};
      const char* error_keys[] = {"area_error", "volume_error", "side_error"};
      for (int i = 0; i < 5; ++i) counts[i] += row.value(count_keys[i], 0);
      for (int i = 0; i < 3; ++i) errors[i] = std::max(errors[i], row[error_keys[i]].get<double>());
    }
    std::vector<std::string> cells{name};
    for (const int count : counts) cells.push_back(std::to_string(count));
    for (const double error : errors) cells.push_back(scientific(error));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

int make_report(const Options& options) {
  std::vector<Json> rows = earlier_rows(options.json);
  Progress progress(false);
  const std::vector<std::string> names = fruit_names(options.fruits);
  const auto share = [&](int all) {
    return (all + static_cast<int>(names.size()) - 1) / static_cast<int>(names.size());
  };
  const auto add = [&](const FactsOf& facts_of, const std::string& kind, const std::string& fruit, int all) {
    for (int first = 0; first < all; first += chunk) {
      const int count = std::min(chunk, all - first);
      if (is_done(rows, fruit, kind, first, count)) continue;
      rows.push_back(measured(facts_of, kind, fruit, first, count, {options.threads}));
      if (!options.json.empty()) write_whole(options.json, Json(rows).dump(1) + "\n");
    }
  };
  add([](int i) { return facts_of_block(static_cast<std::uint64_t>(i)); }, "blocks", block_name, options.blocks);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    const double detail = detail_for(name, options.triangles);
    const DiffusionSurfaces fruit =
        without_lone_walls(thinned(grow_fruit(name, detail).grown.sheets, options.triangles));
    const oracle::CutOracle oracle(fruit);
    for (const auto& [kind, all] : {std::pair("degenerate", options.degenerate), std::pair("pairs", options.pairs),
                                    std::pair("strokes", options.strokes), std::pair("solids", options.solids),
                                    std::pair("peels", options.peels), std::pair("random", options.random)}) {
      add([&, kind = std::string(kind)](int n) { return oracle.facts(knives_of(oracle, kind, name, n)); }, kind, name,
          share(all));
    }
    progress.report("fruits", i + 1, names.size());
  }
  const std::string text = markdown(table_of(rows));
  if (!options.out.empty()) write_whole(options.out, text);
  std::printf("%s", text.c_str());
  return std::all_of(rows.begin(), rows.end(), [](const Json& row) { return row["bad"].empty(); }) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Whether cuts hold whatever the plane. Exits with 1 if any does not");
  Options options;
  app.add_option("FRUIT", options.fruits, "Names of templates; all of them if none is given");
  app.add_option("--random", options.random, "Cuts along a random plane")->capture_default_str();
  app.add_option("--degenerate", options.degenerate, "Cuts through vertices, along edges, in triangles, tangent")
      ->capture_default_str();
  app.add_option("--pairs", options.pairs, "Cuts along two random planes")->capture_default_str();
  app.add_option("--strokes", options.strokes, "Cuts along a random stroke")->capture_default_str();
  app.add_option("--solids", options.solids, "Cuts along a closed surface, by turns out for trouble")
      ->capture_default_str();
  app.add_option("--peels", options.peels, "Peels, every other one in a strip")->capture_default_str();
  app.add_option("--blocks", options.blocks, "Cuts of turned blocks next to two to six of their faces")
      ->capture_default_str();
  app.add_option("--triangles", options.triangles, "About so many triangles a fruit")->capture_default_str();
  app.add_option("--out", options.out, "Write the table to this file too");
  app.add_option("--json", options.json, "Write the figures to this file as JSON; cuts already there are kept");
  app.add_option("--threads", options.threads, "0 = all there are")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return exit_status_of([&] { return make_report(options); });
}
