// The part of Delivery that writes meshes with levels of detail and textures: .glb and .usda.
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/deliver.h"
#include "cli/map_files.h"
#include "cli/scene_levels.h"
#include "generator/piece/lod/levels_of_detail.h"
#include "render/export/gltf/write_glb.h"
#include "render/export/usd/write_usda.h"
#include "render/texture/bake.h"

namespace pomona {

namespace {

/// all_baked(), fruit by fruit, whose pieces share what colours them: progress is told after each.
std::vector<BakedSolid> baked_by_fruit(std::span<const Solid> solids, const Style& style, const BakeOptions& how,
                                       Progress& progress) {
  std::vector<BakedSolid> baked_solids;
  for (std::size_t first = 0; first < solids.size();) {
    progress.report("bake", first, solids.size());
    std::size_t end = first + 1;
    while (end < solids.size() && solids[end].section_colors == solids[first].section_colors) ++end;
    for (BakedSolid& solid : all_baked(solids.subspan(first, end - first), style, how))
      baked_solids.push_back(std::move(solid));
    first = end;
  }
  progress.report("bake", solids.size(), solids.size());
  return baked_solids;
}

}  // namespace

/// Nothing unless --lod asks for it.
std::vector<std::vector<Solid>> Delivery::levels_of(const Scene& scene) {
  if (options_.lod == 0) return {};
  const LodOptions how{.levels = options_.lod, .threads = {options_.threads}};
  std::vector<std::vector<Solid>> levels = times.time("lod", [&] { return all_levels_of_detail(scene.solids, how); });
  const LevelCounts counts = level_counts(scene.solids, levels, options_.lod);
  for (std::size_t level = 0; level < counts.triangles.size(); ++level)
    times.count("lod_" + std::to_string(level) + "_triangles", static_cast<std::int64_t>(counts.triangles[level]));
  warn(level_warnings(counts));
  return levels;
}

/// All of it in textures, at every level and ripeness; variants differ in colour alone.
Delivery::BakedScene Delivery::baked_scene(const Scene& scene, std::span<const std::vector<Solid>> levels, Maps maps) {
  BakeOptions how{.texel = texel_, .maps = maps, .threads = {options_.threads}};
  if (options_.texture > 0) how.texels = options_.texture;
  BakedScene baked;
  baked.solids = times.time("bake", [&] { return baked_by_fruit(scene.solids, style_, how, progress); });
  baked.coarser = times.time("bake", [&] { return baked_levels(levels, style_, how); });
  count_texels(baked.solids);
  for (const std::vector<BakedSolid>& of_solid : baked.coarser) count_texels(of_solid);
  how.maps = Maps::color;
  for (const RipenessVariant& riper : variants_) {
    baked.variants.push_back({riper.name, times.time("bake", [&] { return all_baked(riper.pieces, style_, how); })});
    count_texels(baked.variants.back().solids);
  }
  return baked;
}

void Delivery::add_glb(const Output& output, const Scene& scene) {
  const ExportOptions options = export_options();
  const std::vector<std::vector<Solid>> levels = levels_of(scene);
  if (!wants_textures(options_)) return add(output.file, [&] { return write_glb(scene, options, levels); });
  const BakedScene baked = baked_scene(scene, levels, options_.maps == "all" ? Maps::all : Maps::color);
  if (!options_.maps_dir.empty()) {
    for (OutputFile& file : times.time("write", [&] { return map_files(baked.solids, options_.maps_dir); }))
      files_.push_back(std::move(file));
  }
  add(output.file, [&] { return write_glb(scene, baked.solids, options, baked.coarser, baked.variants); });
}

void Delivery::add_usda(const Output& output, const Scene& scene) {
  const ExportOptions options = export_options();
  const std::vector<std::vector<Solid>> levels = levels_of(scene);
  if (!wants_textures(options_)) return add(output.file, [&] { return write_usda(scene, options, levels); });
  const BakedScene baked = baked_scene(scene, levels, Maps::color);
  const std::string stem = output.file.stem().string();
  UsdaFiles made = times.time(
      "write", [&] { return write_usda(scene, baked.solids, stem, options, baked.coarser, baked.variants); });
  files_.push_back({output.file, std::move(made.text)});
  for (NamedFile& file : made.textures)
    files_.push_back({output.file.parent_path() / file.name, std::move(file.bytes)});
}

void Delivery::count_texels(const std::vector<BakedSolid>& baked_solids) {
  std::int64_t texels = 0, diffused = 0;
  for (const BakedSolid& solid : baked_solids) {
    texels += static_cast<std::int64_t>(solid.texture.width) * solid.texture.height;
    diffused += static_cast<std::int64_t>(solid.diffused);
  }
  times.count("texels", texels);
  times.count("diffused_texels", diffused);
}

}  // namespace pomona
