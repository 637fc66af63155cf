#include "cli/streamed_glb.h"

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
    levels = times_.time("lod", [&] { return all_levels_of_detail(solids, how); });
    levels_ = added(levels_, level_counts(solids, levels, options_.lod));
  }
  if (!options_.bake) return times_.time("write", [&] { stream_.add(solids, levels); });

  const Style& style = options_.exported.style;
  const std::vector<BakedSolid> baked = times_.time("bake", [&] { return all_baked(solids, style, *options_.bake); });
  const std::vector<std::vector<BakedSolid>> coarser =
      times_.time("bake", [&] { return baked_levels(levels, style, *options_.bake); });
  count_texels(baked, times_);
  for (const std::vector<BakedSolid>& of_solid : coarser) count_texels(of_solid, times_);
  times_.time("write", [&] { stream_.add_baked(solids, baked, coarser); });
}

OutputFile StreamedGlb::finished(const Scene& scene) {
  std::string head = times_.time("write", [&] { return std::move(stream_).finished(scene); });
  return {file_, std::move(head), spool_};
}

}  // namespace pomona
