// Baking: texels a second, charts, and the share of the atlas that is filled.
// textures [--texels N] [--threads N] [--knife KNIFE] [--draft] [--truth] [NAME...] Names are those of templates; none
// means all. Each is cut, in half unless --knife says otherwise, and its pieces are baked, plain, on the CPU. --truth
// bakes them once more with every texel diffused by itself, which takes long, and prints the difference.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/fruits.h"
#include "bench/timing.h"
#include "generator/base/error.h"
#include "generator/base/free_memory.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "render/style/style_file.h"
#include "render/texture/bake.h"

namespace {

using namespace pomona;

struct Settings {
  int texels = 1024;
  Threads threads{2};
  std::string knife = "half";
  Quality quality = Quality::final;
  bool truth = false;
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
    } else if (word == "--knife" && i + 1 < argc) {
      settings.knife = argv[++i];
    } else if (word == "--draft") {
      settings.quality = Quality::draft;
    } else if (word == "--truth") {
      settings.truth = true;
    } else {
      settings.names.push_back(word);
    }
  }
  return settings;
}

/// The differences of two sets of textures, in parts of 255.
struct Difference {
  double rms = 0;
  int largest = 0;
  std::size_t beyond_4 = 0;  ///< texels
};

Difference difference_of(const std::vector<BakedSolid>& a, const std::vector<BakedSolid>& b) {
  Difference found;
  double count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t p = 0; p < a[i].texture.pixels.size(); ++p) {
      const glm::ivec3 d = glm::abs(glm::ivec3(a[i].texture.pixels[p]) - glm::ivec3(b[i].texture.pixels[p]));
      const int max = std::max({d.x, d.y, d.z});
      found.rms += d.x * d.x + d.y * d.y + d.z * d.z;
      found.largest = std::max(found.largest, max);
      found.beyond_4 += max > 4 ? 1 : 0;
    }
    count += 3 * static_cast<double>(a[i].texture.pixels.size());
  }
  found.rms = std::sqrt(found.rms / count);
  return found;
}

void measure(const std::string& name, const Settings& settings) {
  // The pieces.
  const bench::BenchFruit fruit = bench::grow_fruit(name);
  const auto diffuser = make_pmvc_diffuser({.quality = settings.quality, .threads = settings.threads});
  const std::vector<Knife> knives{parse_knife(settings.knife)};
  const std::vector<Solid> pieces = slice({fruit.grown, fruit.drawn, knives, name}, diffuser.get(),
                                          {.cut = {.threads = settings.threads}, .keep_section_colors = true})
                                        .pieces;

  // Their textures.
  std::vector<BakedSolid> found;
  const Style style = style_named("plain");
  BakeOptions options{.texels = settings.texels, .threads = settings.threads};
  const bench::Duration time = bench::time_of([&] { found = all_baked(pieces, style, options); });
  std::size_t texels = 0, points = 0;
  int charts = 0;
  for (const BakedSolid& solid : found) {
    texels += solid.texture.pixels.size(), points += solid.diffused, charts += solid.charts;
  }
  const BakedSolid& first = found.front();
  std::printf("| %-11s | %6zu | %3zu | %8zu | %7zu | %6.2f | %6.2f | %5d | %4.2f | %7.2f | %3.0f %% | %d |",
              name.c_str(), fruit.grown.sheets.triangle_count(), found.size(), texels, points, time.wall * 1e-3,
              time.processor * 1e-3, charts, first.mean_stretch, first.worst_stretch, 100 * first.filled,
              first.mip_levels);

  // Their truth: every texel diffused by itself.
  if (settings.truth) {
    options.every_texel = true;
    std::vector<BakedSolid> truth;
    const bench::Duration long_time = bench::time_of([&] { truth = all_baked(pieces, style, options); });
    const Difference difference = difference_of(found, truth);
    std::printf(" %6.2f | %.2f | %d | %zu |", long_time.processor * 1e-3, difference.rms, difference.largest,
                difference.beyond_4);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const Settings settings = settings_from(argc, argv);
  keep_free_memory();  // as the program does
  std::printf("| fruit | triangles | pieces | texels | points diffused | wall s | processor s | charts | ");
  std::printf("mean stretch | worst | filled | mip levels |");
  if (settings.truth) std::printf(" processor s, every texel | RMS of 255 | largest | texels beyond 4 |");
  std::printf("\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  if (settings.truth) std::printf("--:|--:|--:|--:|");
  std::printf("\n");
  try {
    for (const std::string& name : bench::fruit_names(settings.names)) measure(name, settings);
  } catch (const Error& error) {
    for (const Diagnostic& what : error.diagnostics()) std::fprintf(stderr, "textures: %s\n", what.message.c_str());
    return 1;
  }
  return 0;
}
