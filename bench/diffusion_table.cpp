// Time and error of the diffusion on the seeded fruit, against the reference.
//   diffusion_table [POINTS [THREADS]]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "generator/diffusion/cube_pmvc.h"
#include "generator/diffusion/line_pmvc.h"
#include "generator/diffusion/pmvc_diffuser.h"
#include "tests/shapes/seeded_fruit.h"

namespace {

using namespace pomona;

struct Milliseconds {
  double wall = 0, processor = 0;
};

Milliseconds time_of(const std::function<void()>& work) {
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  work();
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - wall;
  return {passed.count(), 1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

/// The median of several runs, by wall and by processor time.
Milliseconds median_time(int runs, const std::function<void()>& work) {
  std::vector<double> wall, processor;
  for (int i = 0; i < runs; ++i) {
    const Milliseconds time = time_of(work);
    wall.push_back(time.wall);
    processor.push_back(time.processor);
  }
  std::sort(wall.begin(), wall.end());
  std::sort(processor.begin(), processor.end());
  const auto middle = static_cast<std::size_t>(runs / 2);
  return {wall[middle], processor[middle]};
}

/// In linear channels times 255: over all channels, and over points by their worst channel.
struct Errors {
  double rms = 0, p95 = 0, max = 0;
};

Errors errors_of(const std::vector<Color>& colors, const std::vector<Color>& truth) {
  std::vector<double> worst;
  double squares = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const glm::dvec3 error = 255.0 * (glm::dvec3(colors[i]) - glm::dvec3(truth[i]));
    squares += error.x * error.x + error.y * error.y + error.z * error.z;
    worst.push_back(std::max({std::fabs(error.x), std::fabs(error.y), std::fabs(error.z)}));
  }
  std::sort(worst.begin(), worst.end());
  return {std::sqrt(squares / (3.0 * static_cast<double>(worst.size()))), worst[worst.size() * 95 / 100], worst.back()};
}

std::vector<Color> colors_of(const std::vector<PmvcValue>& values) {
  std::vector<Color> colors;
  for (const PmvcValue& value : values) colors.emplace_back(value.color);
  return colors;
}

void print_row(const std::string& name, const Milliseconds& time, const Errors& errors) {
  std::printf("%-12s %9.1f %9.1f %8.3f %8.3f %8.3f\n", name.c_str(), time.wall, time.processor, errors.rms, errors.p95,
              errors.max);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const Threads threads{argc > 2 ? std::atoi(argv[2]) : 2};
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(argc > 1 ? std::atoi(argv[1]) : 3000);
  std::printf("%zu triangles, %zu points, %d threads\n", fruit.triangle_count(), points.size(), threads.count);
  std::printf("%-12s %9s %9s %8s %8s %8s\n", "", "wall ms", "cpu ms", "rms", "p95", "max");

  std::vector<Color> truth;
  const auto diffuse = [&](Quality quality, std::vector<Color>& colors) {
    colors = make_pmvc_diffuser({quality, threads})->diffuse(fruit, points).color;
  };
  const Milliseconds reference_time = time_of([&] { diffuse(Quality::reference, truth); });
  print_row("reference", reference_time, {});

  const SurfaceTree tree = make_surface_tree(fruit);
  if (std::getenv("CUBES") != nullptr) {
    for (const int texels : {16, 32, 48, 128}) {
      std::vector<PmvcValue> values;
      const Milliseconds time = time_of([&] { values = cube_pmvc(fruit, tree, points, texels, threads); });
      print_row("cube " + std::to_string(texels), time, errors_of(colors_of(values), truth));
    }
  }

  constexpr int runs = 5;
  std::vector<Color> colors;
  for (const Quality quality : {Quality::draft, Quality::final}) {
    const Milliseconds time = median_time(runs, [&] { diffuse(quality, colors); });
    print_row(quality == Quality::draft ? "draft" : "final", time, errors_of(colors, truth));
  }
  for (const int lines : {32, 48, 64, 96, 128, 192, 256, 384, 512}) {
    std::vector<PmvcValue> values;
    const Milliseconds time = median_time(
        runs, [&] { values = line_pmvc(fruit, tree, points, {.lines = line_directions(lines), .more = {}}, threads); });
    print_row(std::to_string(2 * lines), time, errors_of(colors_of(values), truth));
  }
}
