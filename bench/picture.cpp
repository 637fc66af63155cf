// The time of the big picture once its pieces are ready, and the memory of the whole.
// picture [--scene scenes/salad.toml] [--layout out/bench_layout.json] [--width 1920] [--height 1080] [--runs 3] Cut
// faces are left undiffused: their colours are wrong, their triangles are not. Poses are kept in the layout file, so
// only the first run settles the pieces.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <CLI/CLI.hpp>

#include "bench/exit_status.h"
#include "bench/timing.h"
#include "generator/scene/compose.h"
#include "generator/scene/layout_file.h"
#include "generator/scene/scene_file.h"
#include "render/gl/scene_picture.h"
#include "render/style/style_file.h"

namespace {

using namespace pomona;

struct Settings {
  std::string scene = POMONA_SOURCE_DIR "/scenes/salad.toml";
  std::string layout = "out/bench_layout.json";
  int width = 1920, height = 1080, runs = 3;
};

Scene composed(const Settings& settings) {
  SceneDescription description = read_scene(settings.scene);
  const std::filesystem::path layout = std::filesystem::absolute(settings.layout);
  const bool kept = std::filesystem::exists(layout);
  if (kept) description.layout = layout.string();
  ComposeOptions options;
  options.find_template = [](const std::string& name) {
    return std::filesystem::path(POMONA_SOURCE_DIR) / "templates" / (name + ".toml");
  };
  Scene scene = compose(description, nullptr, options).scene;
  if (!kept) {
    std::filesystem::create_directories(layout.parent_path());
    std::ofstream(layout) << write_layout(scene);
  }
  return scene;
}

void measure(const Settings& settings) {
  const Scene scene = composed(settings);
  std::size_t triangles = 0;
  for (const Solid& solid : scene.solids) triangles += solid.mesh.triangle.size();
  const double before = bench::peak_megabytes();
  const bench::Duration time = bench::median_time(settings.runs, [&] {
    draw_scene(scene, style_named("ink"), {.width = settings.width, .height = settings.height});
  });
  std::printf("%zu solids, %zu triangles, %d x %d\n", scene.solids.size(), triangles, settings.width, settings.height);
  std::printf("picture          %6.2f s by the clock, %6.2f s of processors (at most 5 s by the clock)\n",
              time.wall / 1000, time.processor / 1000);
  std::printf("peak of memory   %6.0f MB before the picture, %6.0f MB with it (at most 1000 MB)\n", before,
              bench::peak_megabytes());
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app("The speed of the big picture");
  app.add_option("--scene", settings.scene)->capture_default_str();
  app.add_option("--layout", settings.layout)->capture_default_str();
  app.add_option("--width", settings.width)->capture_default_str();
  app.add_option("--height", settings.height)->capture_default_str();
  app.add_option("--runs", settings.runs)->check(CLI::Range(1, 100))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return bench::exit_status_of([&] {
    measure(settings);
    return 0;
  });
}
