// True colours at points of a fruit's section, by walks on spheres, to compare others with.
//   walk_truth FRUIT CUT FILE.json [POINTS [STANDARD_ERROR]]
// FRUIT is a template, or "bench" for the seeded fruit (CUT is then "-"); CUT one of half, across, slanted.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "bench/fruits.h"
#include "bench/timing.h"
#include "generator/base/error.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/walk/walk_on_spheres.h"
#include "tests/shapes/seeded_fruit.h"

namespace {

using namespace pomona;

struct Question {
  DiffusionSurfaces surfaces;
  std::vector<glm::vec3> points;
};

Question question_of(const std::string& fruit, const std::string& cut_name) {
  if (fruit == "bench") return {shapes::seeded_fruit(), shapes::points_on_section_of_seeded_fruit(3000)};
  const bench::BenchFruit grown = bench::grow_fruit(fruit);
  for (const bench::BenchCut& way : bench::standard_cuts(grown.grown.sheets)) {
    if (way.name != cut_name) continue;
    const Cut result = cut(grown.grown.sheets, {&way.knife, 1});
    return {grown.grown.sheets, bench::interior_positions(result.section)};
  }
  throw Error(ExitStatus::usage, "there is no cut \"" + cut_name + "\"");
}

/// At most `count` points, evenly picked out of all.
std::vector<glm::vec3> some_of(const std::vector<glm::vec3>& points, std::size_t count) {
  if (points.size() <= count) return points;
  std::vector<glm::vec3> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(points[i * points.size() / count]);
  return some;
}

std::vector<std::vector<float>> rows_of(const std::vector<glm::vec3>& values) {
  std::vector<std::vector<float>> rows;
  for (const glm::vec3& value : values) rows.push_back({value.x, value.y, value.z});
  return rows;
}

void run(int argc, char** argv) {
  const std::string fruit = argv[1], cut_name = argv[2], file = argv[3];
  const std::size_t count = argc > 4 ? std::strtoul(argv[4], nullptr, 10) : 400;
  const double standard_error = argc > 5 ? std::atof(argv[5]) : 0.3;

  const Question question = question_of(fruit, cut_name);
  const std::vector<glm::vec3> points = some_of(question.points, count);
  WalkResult result;
  const bench::Duration time =
      bench::time_of([&] { result = WalkOnSpheres(question.surfaces, {.standard_error = standard_error}).at(points); });

  nlohmann::ordered_json json;
  json["fruit"] = fruit;
  json["cut"] = cut_name;
  json["position"] = rows_of(points);
  json["color"] = rows_of(result.color);
  json["standard_error"] = result.standard_error;
  json["part"] = result.part;
  std::ofstream(file) << json << '\n';

  double walks = 0, misses = 0;
  for (std::size_t i = 0; i < points.size(); ++i) walks += result.walks[i], misses += result.misses[i];
  std::printf("%s %s: %zu triangles, %zu of %zu points, %.0f walks each, %.2f %% missed, %.1f s, %.2f us a walk\n",
              fruit.c_str(), cut_name.c_str(), question.surfaces.triangle_count(), points.size(),
              question.points.size(), walks / static_cast<double>(points.size()), 100 * misses / std::max(walks, 1.0),
              time.wall / 1e3, 1e3 * time.processor / std::max(walks, 1.0));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4) {
    std::fputs("usage: walk_truth FRUIT CUT FILE.json [POINTS [STANDARD_ERROR]]\n", stderr);
    return 64;
  }
  run(argc, argv);
} catch (const std::exception& error) {
  std::fprintf(stderr, "walk_truth: %s\n", error.what());
  return 1;
}
