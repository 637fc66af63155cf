// The parts of diffusion on the CPU by themselves, on the bench model, and the look-up of an example, with Google
// Benchmark.
//   kernels [--benchmark_filter=REGEX]
#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include <benchmark/benchmark.h>

#include "generator/base/morton.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/diffusion/pmvc/cube_pmvc.h"
#include "generator/diffusion/pmvc/group_boxes.h"
#include "generator/diffusion/pmvc/line_sweep.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/diffusion/pmvc/relaxed_lines.h"
#include "generator/template/read/read_template.h"
#include "render/style/example.h"
#include "render/style/look.h"
#include "tests/shapes/seeded_fruit.h"

namespace {

using namespace pomona;

/// The bench model, and its points the way a sweep wants them.
struct Scene {
  explicit Scene(int count) : points(shapes::points_on_section_of_seeded_fruit(count)) {
    for (const std::uint32_t i : morton_order(std::vector<glm::dvec3>(points.begin(), points.end()))) {
      normalized.push_back(packed.normalized(points[i]));
    }
  }

  DiffusionSurfaces surfaces = shapes::seeded_fruit();
  SurfaceTree tree = make_surface_tree(surfaces);
  PackedSurfaces packed = pack(surfaces, tree);
  std::vector<glm::vec3> points, normalized;
};

void tree_build(benchmark::State& state) {
  const DiffusionSurfaces surfaces = shapes::seeded_fruit();
  for (auto _ : state) benchmark::DoNotOptimize(make_surface_tree(surfaces));
}

void packing(benchmark::State& state) {
  const Scene scene(100);
  for (auto _ : state) benchmark::DoNotOptimize(pack(scene.surfaces, scene.tree));
}

void group_order(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(nearest_first(scene.packed, scene.normalized));
}

/// Sweeps along the lines of quality final, one after another.
void sweep(benchmark::State& state) {
  const Scene scene(static_cast<int>(state.range(0)));
  const GroupBoxes boxes = nearest_first(scene.packed, scene.normalized);
  const std::vector<Line> lines = relaxed_final_lines();
  SweepSums sums;
  sums.color_and_weight.assign(scene.normalized.size(), glm::vec4(0));
  sums.part_weight.assign(scene.normalized.size() * scene.packed.used_parts.size(), 0);
  LineSweep sweeping(scene.packed, boxes, scene.normalized, true);
  std::size_t i = 0;
  for (auto _ : state) sweeping.add(lines[i++ % lines.size()], sums);

  const double rays = 2.0 * static_cast<double>(scene.normalized.size()) * static_cast<double>(state.iterations());
  state.counters["rays"] = benchmark::Counter(rays, benchmark::Counter::kIsRate);
}

/// Whether points lie on a surface: within 1e-5 of its size.
void nearest_side_on_surface(benchmark::State& state) {
  const Scene scene(3000);
  std::size_t i = 0;
  for (auto _ : state) {
    const glm::dvec3 point(scene.points[i++ % scene.points.size()]);
    benchmark::DoNotOptimize(nearest_side(scene.surfaces, scene.tree, point, 1e-5 * scene.tree.size));
  }
}

void nearest_side_anywhere(benchmark::State& state) {
  const Scene scene(3000);
  std::size_t i = 0;
  for (auto _ : state) {
    const glm::dvec3 point(scene.points[i++ % scene.points.size()]);
    benchmark::DoNotOptimize(nearest_side(scene.surfaces, scene.tree, point));
  }
}

/// The cube of directions at sixteen points.
void cube(benchmark::State& state) {
  const Scene scene(3000);
  const auto texels = static_cast<int>(state.range(0));
  std::size_t i = 0;
  for (auto _ : state) {
    const std::span<const glm::vec3> some(&scene.points[i], 16);
    benchmark::DoNotOptimize(cube_pmvc(scene.surfaces, scene.tree, some, texels, {1}));
    i = (i + 997) % (scene.points.size() - 16);
  }
}

/// The whole diffusion, on two threads.
void whole(benchmark::State& state) {
  const Scene scene(3000);
  const auto diffuser = make_pmvc_diffuser({static_cast<Quality>(state.range(0)), {2}});
  for (auto _ : state) benchmark::DoNotOptimize(diffuser->diffuse(scene.surfaces, scene.points));
}

/// A kiwi's detail by example, at places of its flesh in no order, each with a way of its own: the cube is far larger
/// than the first cache.
struct ExamplePlaces {
  static constexpr std::size_t count = 4096;

  ExamplePlaces() {
    const std::vector<Look::Detail>& details = look.details(DetailFace::cut);
    detail = &*std::find_if(details.begin(), details.end(),
                            [](const Look::Detail& one) { return one.pattern.detail().tile != nullptr; });
    std::mt19937 random(1);
    const auto within = [&](float reach) {
      const auto one = [&] { return reach * (static_cast<float>(random()) / 2147483648.0f - 1); };
      return glm::vec3(one(), one(), one());
    };
    for (std::size_t i = 0; i < count; ++i) place.push_back({within(0.025f), {within(0.01f), 0.005f, glm::vec4(1)}});
  }

  struct Place {
    glm::vec3 position{0};
    DetailGuide guide;
  };
  Template fruit = read_template(POMONA_SOURCE_DIR "/templates/kiwi.toml");
  Look look{fruit.noise, fruit.details};
  const Look::Detail* detail = nullptr;
  std::vector<Place> place;
};

/// The coordinate and one look-up. \param state range 0: the footprint, micrometres: at 300 two levels of the tile mix.
void example_look_up(benchmark::State& state) {
  const ExamplePlaces places;
  const double footprint = 1e-6 * static_cast<double>(state.range(0));
  std::size_t i = 0;
  for (auto _ : state) {
    const ExamplePlaces::Place& at = places.place[i++ % ExamplePlaces::count];
    benchmark::DoNotOptimize(places.detail->pattern(glm::dvec3(at.position), at.guide, footprint));
  }
}

/// The look-up alone.
void tile_look_up(benchmark::State& state) {
  const ExamplePlaces places;
  const ExampleTile& tile = *places.detail->pattern.detail().tile;
  std::size_t i = 0;
  for (auto _ : state) {
    const glm::dvec3 at(places.place[i++ % ExamplePlaces::count].position);
    benchmark::DoNotOptimize(tile_color(tile, 125.0 * at, 1));
  }
}

BENCHMARK(tree_build)->Unit(benchmark::kMillisecond);
BENCHMARK(packing)->Unit(benchmark::kMillisecond);
BENCHMARK(group_order)->Arg(3000)->Unit(benchmark::kMillisecond);
BENCHMARK(sweep)->Arg(100)->Arg(600)->Arg(3000)->Arg(12000)->Unit(benchmark::kMillisecond);
BENCHMARK(nearest_side_on_surface)->Unit(benchmark::kMicrosecond);
BENCHMARK(nearest_side_anywhere)->Unit(benchmark::kMicrosecond);
BENCHMARK(cube)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);
BENCHMARK(whole)
    ->Arg(static_cast<int>(Quality::draft))
    ->Arg(static_cast<int>(Quality::final))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(tile_look_up)->Unit(benchmark::kNanosecond);
BENCHMARK(example_look_up)->Arg(100)->Arg(300)->Unit(benchmark::kNanosecond);

}  // namespace

BENCHMARK_MAIN();
