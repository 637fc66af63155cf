// The time of a scene's ink and of the whole picture, and how much ink flickers when the camera turns.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include "bench/exit_status.h"
#include "bench/timing.h"
#include "cli/options/find_template.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/scene/compose.h"
#include "generator/scene/scene_file.h"
#include "render/gl/scene_picture.h"
#include "render/strokes/scene_strokes.h"
#include "render/style/style_file.h"

namespace pomona::bench {
namespace {

constexpr StrokeOptions picture{.width = 1920, .height = 1080};

Scene turned(Scene scene, double degrees) {
  const glm::dvec3 d = scene.view.eye - scene.view.target;
  const double c = reproducible::cos(radians(degrees)), s = reproducible::sin(radians(degrees));
  scene.view.eye = scene.view.target + glm::dvec3(c * d.x + s * d.z, d.y, c * d.z - s * d.x);
  return scene;
}

/// The share of the ink, by area, that has no ink within `reach` pixels in the other picture.
double lost_ink(const std::vector<SceneStroke>& from, const std::vector<SceneStroke>& to, double reach) {
  InkLayer there(picture.width, picture.height);
  for (const SceneStroke& stroke : to) {
    std::vector<StrokePoint> wider = stroke.points;
    for (StrokePoint& point : wider) point.radius += reach;
    there.draw(wider);
  }
  double lost = 0, all = 0;
  for (const SceneStroke& stroke : from) {
    for (const StrokePoint& point : stroke.points) {
      const int x = static_cast<int>(std::clamp(point.at.x, 0.0, picture.width - 1.0));
      const int y = static_cast<int>(std::clamp(point.at.y, 0.0, picture.height - 1.0));
      all += point.radius;
      if (there.at(x, y) == 0) lost += point.radius;
    }
  }
  return all > 0 ? lost / all : 0;
}

void print_flicker(const Scene& scene, const Style& style) {
  std::vector<SceneStroke> before = scene_strokes(scene, style, picture);
  for (int step = 1; step <= 5; ++step) {
    std::vector<SceneStroke> now = scene_strokes(turned(scene, 0.2 * step), style, picture);
    std::printf("turned by %.1f degrees: %zu strokes, %.2f %% of the ink gone, %.2f %% new (more than 3 pixels away)\n",
                0.2 * step, now.size(), 100 * lost_ink(before, now, 3), 100 * lost_ink(now, before, 3));
    before = std::move(now);
  }
}

void measure(const std::string& file) {
  const SceneDescription description = read_scene(file);
  ComposeOptions options;
  options.find_template = find_template;
  const Scene scene = compose(description, nullptr, options).scene;
  std::size_t triangles = 0;
  for (const Instance& instance : scene.instances) triangles += scene.solids[instance.solid].mesh.triangle.size();
  std::printf("%zu pieces, %zu triangles\n", scene.instances.size(), triangles);

  const Style style = style_named("ink");
  std::size_t count = 0;
  const Duration strokes = median_time(3, [&] { count = scene_strokes(scene, style, picture).size(); });
  std::printf("%zu strokes: %.0f ms (processor %.0f ms)\n", count, strokes.wall, strokes.processor);
  GlContext context;
  const Duration whole =
      median_time(3, [&] { draw_scene(context, scene, style, {.width = picture.width, .height = picture.height}); });
  std::printf("the picture, ink included: %.0f ms (processor %.0f ms), at most %.0f MB\n", whole.wall, whole.processor,
              peak_megabytes());
  print_flicker(scene, style);
}

}  // namespace
}  // namespace pomona::bench

int main(int argc, char** argv) {
  CLI::App app("Ink of a scene at 1920x1080: time, memory, flicker");
  std::string file = POMONA_SOURCE_DIR "/scenes/salad.toml";
  app.add_option("SCENE", file, "A scene file");
  CLI11_PARSE(app, argc, argv);
  return pomona::bench::exit_status_of([&] {
    pomona::bench::measure(file);
    return 0;
  });
}
