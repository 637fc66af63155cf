// Settling 30 to 10 000 pieces: time, memory, and the remaining faults.
//   settle [--seed N] [--threads N] [--stages] [PIECES...]
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/scene/compose.h"

namespace pomona::bench {
namespace {

/// 104 pieces of 7 fruits, round and flat, thick and thin, convex and not; 308 with their copies; and a bowl that these
/// fill.
constexpr const char* mixed = R"(
format = 1
name = "mixed"
seed = 3
[bowl]
unit = "1.7099759466766968mm"
profile = """M 0 0 L 48 0 C 54 0, 58 -2, 63 -6 C 98 -22, 128 -50, 139 -84 C 140.5 -89, 136 -90.5, 133.5 -86
  C 122 -55, 94 -28, 60 -13 C 40 -5.5, 20 -5, 0 -5"""
color = "#2c5a5e"
around = 96
along = 80
[[pieces]]
name = "tomato"
template = "tomato"
count = 6
knives = ["wedges:6"]
take = 4
copies = 3
[[pieces]]
name = "cucumber"
template = "cucumber"
count = 4
knives = ["slices:8mm"]
take = 5
face_up = true
copies = 3
[[pieces]]
name = "onion"
template = "onion"
count = 4
knives = ["half", "slices:5mm"]
take = 4
copies = 3
[[pieces]]
name = "cherry"
template = "cherry"
count = 8
copies = 4
[[pieces]]
name = "pepper-ring"
template = "pepper"
count = 4
knives = ["slices:7mm"]
take = 3
largest = 0.085
copies = 2
[[pieces]]
name = "pepper-strip"
template = "pepper"
count = 4
knives = ["plane:0,1,0,62mm", "plane:0,1,0,14mm", "wedges:12"]
take = 3
copies = 3
[[pieces]]
name = "lemon"
template = "lemon"
count = 4
knives = ["wedges:8"]
take = 3
copies = 3
)";

SceneParts made_pieces(Threads threads) {
  ComposeOptions options;
  options.find_template = [](const std::string& name) { return template_path(name); };
  options.threads = threads;
  return make_parts(parse_scene(mixed, "mixed.toml"), nullptr, options);
}

/// This number of items; those of the scene are repeated.
std::vector<SettleItem> repeated(const SceneParts& parts, std::size_t count) {
  std::vector<SettleItem> items;
  for (std::size_t i = 0; i < count; ++i) {
    items.push_back(parts.items[i % parts.items.size()]);
    items.back().name += "." + std::to_string(i);
  }
  return items;
}

/// A bowl that is as full with these pieces as the scene's bowl is with its own.
Solid scaled_bowl(const SceneParts& parts, std::size_t count) {
  Solid bowl = parts.solids[static_cast<std::size_t>(parts.dishes.at(0).solid)];
  const double share = static_cast<double>(count) / static_cast<double>(parts.items.size());
  const auto scale = static_cast<float>(reproducible::cbrt(share));
  for (glm::vec3& p : bowl.mesh.position) p *= scale;
  return bowl;
}

/// A hash that tells layouts apart: FNV-1a over the poses' bits.
std::string hash_of(const std::vector<Pose>& poses) {
  std::uint64_t hash = 14695981039346656037u;
  for (const Pose& pose : poses) {
    const glm::dquat& q = pose.rotation;
    const glm::dvec3& t = pose.translation;
    for (const double value : {q.w, q.x, q.y, q.z, t.x, t.y, t.z}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (bits >> (8 * byte) & 0xff)) * 1099511628211u;
    }
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

void add_row(const SceneParts& parts, std::size_t count, const SettleOptions& options, TextTable& table) {
  const std::vector<SettleItem> items = repeated(parts, count);
  const Solid bowl = scaled_bowl(parts, count);
  Settled settled;
  const Duration time = time_of([&] { settled = settle(parts.solids, items, &bowl, options); });
  double gap = 0, penetration = 0;
  std::size_t over = 0;
  for (const Fit& fit : settled.fits) {
    gap = std::max(gap, fit.gap);
    penetration = std::max(penetration, fit.penetration);
    over += std::max(fit.gap, fit.penetration) > 0.02 ? 1 : 0;
  }
  table.rows.push_back({std::to_string(count), number(time.wall / 1000, 1), number(time.processor / 1000, 1),
                        number(time.processor / static_cast<double>(count), 1), number(peak_megabytes(), 0),
                        std::to_string(settled.steps), std::to_string(settled.again), std::to_string(over),
                        number(100 * gap, 2), number(100 * penetration, 2), hash_of(settled.poses)});
}

}  // namespace
}  // namespace pomona::bench

int main(int argc, char** argv) {
  using namespace pomona;
  CLI::App app("Settling: time, memory, gaps and overlaps");
  SettleOptions options;
  bool parts_too = false;
  std::vector<std::size_t> counts;
  app.add_option("--seed", options.seed, "Of the drops");
  app.add_option("--threads", options.threads.count, "0: as many as the machine has");
  app.add_flag("--stages", parts_too, "Say on stderr how far it is");
  app.add_option("PIECES", counts, "How many; none means 30, 100, 300, 1000, 3000 and 10000");
  CLI11_PARSE(app, argc, argv);
  if (counts.empty()) counts = {30, 100, 300, 1000, 3000, 10000};
  return bench::exit_status_of([&] {
    const SceneParts parts = bench::made_pieces(options.threads);
    std::fprintf(stderr, "%zu solids, %.0f MB so far\n", parts.solids.size(), bench::peak_megabytes());
    if (parts_too) {
      options.progress = [](const std::string& stage, std::size_t done, std::size_t total) {
        std::fprintf(stderr, "%s %zu of %zu\n", stage.c_str(), done, total);
      };
    }
    bench::TextTable table{{"pieces", "s", "processor s", "ms a piece", "peak MB", "steps", "dropped again", "over 2 %",
                            "worst gap, %", "worst overlap, %", "poses"},
                           {}};
    for (const std::size_t count : counts) {
      bench::add_row(parts, count, options, table);
      std::fprintf(stderr, "%zu pieces are done\n", count);
    }
    std::printf("%s", bench::markdown(table).c_str());
    return 0;
  });
}
