// The coarser levels of detail of a scene's solids, for --lod.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "generator/piece/solid.h"
#include "render/deliver/delivered.h"
#include "render/texture/bake.h"

namespace pomona {

/// The number of triangles of all solids at each level, from the solids themselves (level 0) on. A solid whose levels
/// end early counts with its coarsest one.
struct LevelCounts {
  std::vector<std::size_t> wanted, triangles;
};
LevelCounts level_counts(std::span<const Solid> solids, std::span<const std::vector<Solid>> levels, int count);

/// The sum of both.
LevelCounts added(LevelCounts counts, const LevelCounts& more);

/// Counts the triangles of each level, "lod_1_triangles", and warns of each level that has a tenth more than it should.
void tell_levels(const LevelCounts& counts, Delivered& delivered);

/// The levels with their colours in textures: with half as many texels along a side, or texels twice as large, for
/// every second level.
std::vector<std::vector<BakedSolid>> baked_levels(std::span<const std::vector<Solid>> levels, const Style& style,
                                                  const BakeOptions& options);

/// Counts the texels, and the points at which colours were diffused for them.
void count_texels(std::span<const BakedSolid> baked_solids, Delivered& delivered);

}  // namespace pomona
