// Baking: texels a second, charts and how well the atlas is filled.
//   textures [--texels N] [--threads N] [NAME...]
// Names are those of templates; none means all. Each is cut in half and baked, plain, on the CPU.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/fruits.h"
#include "bench/timing.h"
#include "generator/base/error.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "render/texture/bake.h"

namespace {

using namespace pomona;

struct Settings {
  int texels = 1024;
  Threads threads{2};
  std::vector<std::string> names;
};

Settings settings_from(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--texels" && i + 1 < argc) {
      settings.texels = std::clamp(std::atoi(argv[++i]), 64, 8192);
    } else if (word == "--threads" && i + 1 < argc) {
      settings.threads.count = std::clamp(std::atoi(argv[++i]), 0, 1024);
    } else {
      settings.names.push_back(word);
    }
  }
  return settings;
}

void measure(const std::string& name, const Settings& settings) {
  const bench::BenchFruit fruit = bench::grow_fruit(name);
  const auto diffuser = make_pmvc_diffuser({.threads = settings.threads});
  const std::vector<Knife> knives{parse_knife("half")};
  Slices slices = slice({fruit.grown, fruit.drawn, knives, name}, diffuser.get(),
                        {.cut = {.threads = settings.threads}, .keep_section_colors = true});
  std::vector<Solid> pieces = std::move(slices.pieces);
  pieces.resize(1);
  std::vector<BakedSolid> baked_solids;
  const bench::Duration time = bench::time_of([&] {
    baked_solids = all_baked(pieces, style_named("plain"), {.texels = settings.texels, .threads = settings.threads});
  });
  const BakedSolid& solid = baked_solids.front();
  std::printf("| %-11s | %6zu | %7zu | %7.2f | %7.2f | %7.0f | %5d | %4.2f | %5.2f | %3.0f %% | %d |\n", name.c_str(),
              fruit.grown.sheets.triangle_count(), solid.diffused, time.wall * 1e-3, time.processor * 1e-3,
              static_cast<double>(solid.diffused) / std::max(1e-3, time.processor), solid.charts, solid.mean_stretch,
              solid.worst_stretch, 100 * solid.filled, solid.mip_levels);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const Settings settings = settings_from(argc, argv);
  std::printf("| fruit | triangles | texels diffused | wall s | processor s | diffused per processor ms | charts | ");
  std::printf("mean stretch | worst | filled | mip levels |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  try {
    for (const std::string& name : bench::fruit_names(settings.names)) measure(name, settings);
  } catch (const Error& error) {
    for (const Diagnostic& what : error.diagnostics()) std::fprintf(stderr, "textures: %s\n", what.message.c_str());
    return 1;
  }
  return 0;
}
