// Time and error of the diffusion on the seeded fruit, against the reference.
//   diffusion_table [POINTS [THREADS]]
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/color_errors.h"
#include "bench/timing.h"
#include "generator/diffusion/pmvc/cube_pmvc.h"
#include "generator/diffusion/pmvc/line_pmvc.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "tests/shapes/seeded_fruit.h"

namespace {

using namespace pomona;
using namespace pomona::bench;

std::vector<Color> colors_of(const std::vector<PmvcValue>& values) {
  std::vector<Color> colors;
  for (const PmvcValue& value : values) colors.emplace_back(value.color);
  return colors;
}

void print_row(const std::string& name, const Duration& time, const ColorErrors& errors) {
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
  const Duration reference_time = time_of([&] { diffuse(Quality::reference, truth); });
  print_row("reference", reference_time, {});

  const SurfaceTree tree = make_surface_tree(fruit);
  if (std::getenv("CUBES") != nullptr) {
    for (const int texels : {16, 32, 48, 128}) {
      std::vector<PmvcValue> values;
      const Duration time = time_of([&] { values = cube_pmvc(fruit, tree, points, texels, threads); });
      print_row("cube " + std::to_string(texels), time, color_errors(colors_of(values), truth));
    }
  }

  constexpr int runs = 5;
  std::vector<Color> colors;
  for (const Quality quality : {Quality::draft, Quality::final}) {
    const Duration time = median_time(runs, [&] { diffuse(quality, colors); });
    print_row(quality == Quality::draft ? "draft" : "final", time, color_errors(colors, truth));
  }
  for (const int lines : {32, 48, 64, 96, 128, 192, 256, 384, 512}) {
    std::vector<PmvcValue> values;
    const Duration time = median_time(
        runs, [&] { values = line_pmvc(fruit, tree, points, {.lines = line_directions(lines), .more = {}}, threads); });
    print_row(std::to_string(2 * lines), time, color_errors(colors_of(values), truth));
  }
}
