// Levels of detail of half of every fruit: how many triangles, how far off, how long they take.
//   lod [--error SHARE] [--color SHARE] [--levels N] [--knife KNIFE] [NAME...]
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/lod/levels_of_detail.h"
#include "generator/piece/piece_facts.h"
#include "generator/piece/slice.h"
#include "tests/piece/level_deviation.h"

namespace pomona::bench {
namespace {

/// The largest piece that the knife leaves.
Solid piece_of(const std::string& name, const std::string& knife) {
  const BenchFruit fruit = grow_fruit(name);
  const std::vector<Knife> knives{parse_knife(knife)};
  const auto diffuser = make_pmvc_diffuser({});
  return slice({fruit.grown, fruit.drawn, knives, name}, diffuser.get()).pieces.front();
}

void add_rows(const Solid& solid, const LodOptions& options, TextTable& table) {
  std::vector<Solid> levels;
  const Duration time = median_time(3, [&] { levels = levels_of_detail(solid, options); });
  const PieceFacts facts = facts_of(solid);
  const double size = glm::length(facts.high - facts.low);
  std::size_t wanted = solid.mesh.triangle.size();
  for (const Solid& level : levels) {
    wanted /= 2;
    const LevelDeviation off = deviation(level, solid, size / 200);
    const bool is_first = &level == &levels.front();
    table.rows.push_back(
        {is_first ? solid.name : "", is_first ? std::to_string(solid.mesh.triangle.size()) : "", std::to_string(wanted),
         std::to_string(level.mesh.triangle.size()), number(100 * off.distance / size, 2), number(off.color_rms, 1),
         number(100 * (level.volume / solid.volume - 1), 2), is_first ? number(time.processor, 0) : ""});
  }
}

}  // namespace
}  // namespace pomona::bench

int main(int argc, char** argv) {
  using namespace pomona;
  CLI::App app("Levels of detail: triangles, errors, time");
  LodOptions options{.levels = 3};
  std::string knife = "half";
  std::vector<std::string> names;
  app.add_option("--levels", options.levels, "How many");
  app.add_option("--error", options.error, "How far surface and borders may stray, of the solid's size");
  app.add_option("--color", options.color_error, "How far colours may");
  app.add_option("--knife", knife, "The largest piece of which");
  app.add_option("NAME", names, "Templates; none means all");
  CLI11_PARSE(app, argc, argv);
  return bench::exit_status_of([&] {
    bench::TextTable table{
        {"fruit", "triangles", "wanted", "level", "distance, % of size", "colour, rms of 255", "volume, %", "ms"}, {}};
    for (const std::string& name : bench::fruit_names(names))
      bench::add_rows(bench::piece_of(name, knife), options, table);
    std::printf("%s", bench::markdown(table).c_str());
    return 0;
  });
}
