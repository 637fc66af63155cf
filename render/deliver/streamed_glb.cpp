#include "render/deliver/streamed_glb.h"

#include <utility>

#include "generator/piece/lod/levels_of_detail.h"

namespace pomona {

StreamedGlb::StreamedGlb(std::filesystem::path file, StreamedGlbOptions options)
    : file_(std::move(file)),
      options_(std::move(options)),
      spool_(std::make_shared<SpooledBytes>(file_)),
      stream_(options_.exported, spool_.get()) {}

void StreamedGlb::take(std::span<const Solid> solids) {
  std::vector<std::vector<Solid>> levels;
  if (options_.lod > 0) {
    const LodOptions how{.levels = options_.lod, .threads = options_.exported.threads};
    levels = delivered_.times.time("lod", [&] { return all_levels_of_detail(solids, how); });
    levels_ = added(levels_, level_counts(solids, levels, options_.lod));
  }
  if (!options_.bake) return delivered_.times.time("write", [&] { stream_.add(solids, levels); });

  const Style& style = options_.exported.style;
  const std::vector<BakedSolid> baked =
      delivered_.times.time("bake", [&] { return all_baked(solids, style, *options_.bake); });
  const std::vector<std::vector<BakedSolid>> coarser =
      delivered_.times.time("bake", [&] { return baked_levels(levels, style, *options_.bake); });
  count_texels(baked, delivered_);
  for (const std::vector<BakedSolid>& of_solid : coarser) count_texels(of_solid, delivered_);
  delivered_.times.time("write", [&] { stream_.add_baked(solids, baked, coarser); });
}

Delivered StreamedGlb::finished(const Scene& scene) {
  std::string head = delivered_.times.time("write", [&] { return std::move(stream_).finished(scene); });
  delivered_.files.push_back({.file = {file_, std::move(head), spool_}});
  if (options_.lod > 0) tell_levels(levels_, delivered_);
  return std::move(delivered_);
}

}  // namespace pomona
