#include "render/deliver/scene_levels.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pomona {

LevelCounts level_counts(std::span<const Solid> solids, std::span<const std::vector<Solid>> levels, int count) {
  LevelCounts counts;
  for (int level = 0; level <= count; ++level) {
    std::size_t wanted = 0, triangles = 0;
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const std::size_t there = std::min(static_cast<std::size_t>(level), levels[i].size());
      wanted += solids[i].mesh.triangle.size() >> level;
      triangles += (there == 0 ? solids[i] : levels[i][there - 1]).mesh.triangle.size();
    }
    counts.wanted.push_back(wanted);
    counts.triangles.push_back(triangles);
  }
  return counts;
}

LevelCounts added(LevelCounts counts, const LevelCounts& more) {
  const std::size_t levels = std::max(counts.wanted.size(), more.wanted.size());
  counts.wanted.resize(levels), counts.triangles.resize(levels);
  for (std::size_t level = 0; level < more.wanted.size(); ++level) {
    counts.wanted[level] += more.wanted[level];
    counts.triangles[level] += more.triangles[level];
  }
  return counts;
}

void tell_levels(const LevelCounts& counts, Delivered& delivered) {
  for (std::size_t level = 0; level < counts.triangles.size(); ++level) {
    const std::string number = std::to_string(level), triangles = std::to_string(counts.triangles[level]);
    delivered.counts["lod_" + number + "_triangles"] += static_cast<std::int64_t>(counts.triangles[level]);
    if (level == 0 || 10 * counts.triangles[level] <= 11 * counts.wanted[level]) continue;
    delivered.warnings.push_back("level of detail " + number + " has " + triangles + " triangles instead of " +
                                 std::to_string(counts.wanted[level]) +
                                 ": with fewer, borders or colours would stray too far");
  }
}

std::vector<std::vector<BakedSolid>> baked_levels(std::span<const std::vector<Solid>> levels, const Style& style,
                                                  const BakeOptions& options) {
  std::vector<std::vector<BakedSolid>> baked(levels.size());
  BakeOptions how = options;
  for (std::size_t level = 0;; ++level) {
    // Bakes all solids that have this level together, so that those of one fruit share diffused points.
    std::vector<Solid> solids;
    std::vector<std::size_t> owner;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (level < levels[i].size()) solids.push_back(levels[i][level]), owner.push_back(i);
    }
    if (solids.empty()) return baked;

    // Each level serves half the area, a root of two less along a side, so the side is halved for levels 1, 3 and 5.
    if (level % 2 == 0) how.texels = std::max(64, how.texels / 2), how.texel *= 2;
    std::vector<BakedSolid> done = all_baked(solids, style, how);
    for (std::size_t k = 0; k < done.size(); ++k) baked[owner[k]].push_back(std::move(done[k]));
  }
}

void count_texels(std::span<const BakedSolid> baked_solids, Delivered& delivered) {
  std::int64_t texels = 0, diffused = 0;
  for (const BakedSolid& solid : baked_solids) {
    texels += static_cast<std::int64_t>(solid.texture.width) * solid.texture.height;
    diffused += static_cast<std::int64_t>(solid.diffused);
  }
  delivered.counts["texels"] += texels;
  delivered.counts["diffused_texels"] += diffused;
}

}  // namespace pomona
