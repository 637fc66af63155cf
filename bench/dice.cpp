// The time of 64 dice against that of single cuts of the same fruit: along each of the nine planes of the dice, and
// `half` and `across`. The runs alternate, so that other work on the machine slows all of them alike.
//   dice [NAME...] [--triangles N] [--runs N] [--threads N]
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "generator/cut/cut.h"
#include "generator/knife/cut_planes.h"
#include "generator/knife/parse_knife.h"

namespace {

using namespace pomona;

struct Options {
  std::vector<std::string> fruits;
  int triangles = 20000, runs = 9;
  Threads threads{2};
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Milliseconds by the clock.
double time_of(const DiffusionSurfaces& fruit, const Knife& knife, Threads threads) {
  return bench::time_of([&] { cut(fruit, {&knife, 1}, {.threads = threads}); }).wall;
}

std::vector<Knife> planes_one_by_one(const Knife& dice, const DiffusionSurfaces& fruit) {
  const CutPlanes planes = cut_planes({&dice, 1}, bounds_of(fruit));
  std::vector<Knife> knives;
  for (const CutPlanes::Plane& plane : planes.planes) {
    knives.push_back({PlaneCut(PlaneKnife{plane.plane}), "a plane of the dice"});
  }
  return knives;
}

std::vector<std::string> measured(const std::string& name, const Options& options) {
  const DiffusionSurfaces fruit = bench::grow_fruit(name, bench::detail_for(name, options.triangles)).grown.sheets;
  const Knife dice = parse_knife("dice:4"), half = parse_knife("half"), across = parse_knife("across");
  const std::vector<Knife> planes = planes_one_by_one(dice, fruit);
  std::vector<double> of_dice, of_plane, of_half, of_across, to_plane, to_half, to_across;
  for (int run = 0; run < options.runs; ++run) {
    double sum = 0;
    for (const Knife& plane : planes) sum += time_of(fruit, plane, options.threads);
    of_plane.push_back(sum / static_cast<double>(planes.size()));
    of_half.push_back(time_of(fruit, half, options.threads));
    of_across.push_back(time_of(fruit, across, options.threads));
    of_dice.push_back(time_of(fruit, dice, options.threads));
    to_plane.push_back(of_dice.back() / of_plane.back());
    to_half.push_back(of_dice.back() / of_half.back());
    to_across.push_back(of_dice.back() / of_across.back());
  }
  std::vector<std::string> cells{name, std::to_string(fruit.triangle_count())};
  for (const auto& values : {of_plane, of_half, of_across, of_dice, to_plane, to_half, to_across}) {
    cells.push_back(bench::number(median(values), 1));
  }
  return cells;
}

int make_report(const Options& options) {
  bench::TextTable table{
      {"", "triangles", "one plane", "half", "across", "64 dice", "to one plane", "to half", "to across"}, {}};
  for (const std::string& name : bench::fruit_names(options.fruits)) table.rows.push_back(measured(name, options));
  std::printf("Milliseconds by the clock, and how many times as long the dice take; medians.\n\n%s",
              bench::markdown(table).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("64 dice against one cut");
  Options options;
  app.add_option("FRUIT", options.fruits, "Names of templates; all of them if none is given");
  app.add_option("--triangles", options.triangles, "About so many triangles a fruit")
      ->check(CLI::Range(100, 1000000))
      ->capture_default_str();
  app.add_option("--runs", options.runs, "Runs to take the median of")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--threads", options.threads.count, "0 = all there are")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return bench::exit_status_of([&] { return make_report(options); });
}
