#include "render/deliver/mesh_files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/piece/lod/levels_of_detail.h"
#include "render/deliver/export_options.h"
#include "render/deliver/live_files.h"
#include "render/deliver/scene_levels.h"
#include "render/export/gltf/write_glb.h"
#include "render/export/obj.h"
#include "render/export/output.h"
#include "render/export/ply.h"
#include "render/export/stl.h"
#include "render/export/usd/write_usda.h"
#include "render/image/png.h"
#include "render/texture/texture_pages.h"

namespace pomona {

namespace {

/// A texture and its maps: NAME.color.png, NAME.normal.png, ...
void add_map_files(const std::filesystem::path& folder, const std::string& name, const Image& texture,
                   const SurfaceMaps& maps, std::vector<OutputFile>& files) {
  const auto write = [&](const char* map, const auto& image, PngValues values) {
    files.push_back({folder / (name + "." + map + ".png"), write_png(image, PngPacking::fast, values)});
  };
  const auto add = [&](const char* map, const Image& image, PngValues values) {
    if (!image.pixels.empty()) write(map, image, values);
  };
  const auto add_with_opacity = [&](const char* map, const TransparentImage& image, PngValues values) {
    if (!image.opacity.empty()) write(map, image, values);
  };
  add("color", texture, PngValues::srgb);
  add("normal", maps.normal, PngValues::shares);
  add("orm", maps.orm, PngValues::shares);
  add("thickness", maps.thickness, PngValues::shares);
  add("part", maps.part, PngValues::shares);
  add_with_opacity("coat", maps.coat, PngValues::shares);
  add_with_opacity("sheen", maps.sheen, PngValues::srgb);
  add_with_opacity("light", maps.light, PngValues::srgb);
}

std::string file_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

/// The texture and the maps of each solid or page; and parts.json, with the names of the parts' numbers.
/// \param folder need not exist yet.
std::vector<OutputFile> map_files(std::span<const BakedSolid> baked, const std::filesystem::path& folder) {
  std::vector<OutputFile> files;
  nlohmann::ordered_json parts = nlohmann::ordered_json::object();
  std::set<const TexturePage*> pages;
  for (const BakedSolid& solid : baked) {
    if (solid.uv.empty()) continue;
    const std::string name = file_name(solid.solid.name);
    parts[name] = solid.solid.look->part_names;
    if (!solid.page)
      add_map_files(folder, name, solid.texture, solid.maps, files);
    else if (pages.insert(solid.page.get()).second)
      add_map_files(folder, file_name(solid.page->name), solid.page->texture, solid.page->maps, files);
  }
  files.push_back({folder / "parts.json", json_text(parts, 2) + "\n"});
  return files;
}

/// all_baked(), fruit by fruit, because pieces of one share their colours; reports progress after each.
std::vector<BakedSolid> baked_by_fruit(std::span<const Solid> solids, const Style& style, const BakeOptions& how,
                                       const DeliveryProgress& progress) {
  std::vector<BakedSolid> baked_solids;
  const auto tell = [&](std::size_t done) {
    if (progress) progress("bake", done, solids.size());
  };
  for (std::size_t first = 0; first < solids.size();) {
    tell(first);
    std::size_t end = first + 1;
    while (end < solids.size() && solids[end].section_colors == solids[first].section_colors) ++end;
    for (BakedSolid& solid : all_baked(solids.subspan(first, end - first), style, how))
      baked_solids.push_back(std::move(solid));
    first = end;
  }
  tell(solids.size());
  return baked_solids;
}

/// The same meshes with their textures on pages.
ReadyMeshes on_one_atlas(const ReadyMeshes& ready) {
  std::vector<const BakedSolid*> all;
  for (const BakedSolid& solid : ready.baked) all.push_back(&solid);
  for (const std::vector<BakedSolid>& levels : ready.coarser)
    for (const BakedSolid& level : levels) all.push_back(&level);
  std::vector<glm::ivec2> sizes;
  for (const BakedSolid* solid : all) sizes.emplace_back(solid->texture.width, solid->texture.height);
  const PageLayout layout = page_layout(sizes);

  std::vector<BakedSolid> paged = on_pages(all, layout, "atlas");
  auto next = std::make_move_iterator(paged.begin());
  const auto taken = [&](std::size_t count) {
    std::vector<BakedSolid> some(next, next + static_cast<std::ptrdiff_t>(count));
    next += static_cast<std::ptrdiff_t>(count);
    return some;
  };
  ReadyMeshes result;
  result.baked = taken(ready.baked.size());
  for (const std::vector<BakedSolid>& levels : ready.coarser) result.coarser.push_back(taken(levels.size()));
  for (const TextureVariant& variant : ready.variants) {
    std::vector<const BakedSolid*> solids;
    for (const BakedSolid& solid : variant.solids) solids.push_back(&solid);
    result.variants.push_back({variant.name, on_pages(solids, layout, "atlas")});
  }
  return result;
}

Delivered textured_glb(const Output& output, const SceneViews& scene, const ReadyMeshes& ready, const Order& order,
                       const ExportOptions& options, Delivered delivered) {
  if (!order.mesh.maps_dir.empty()) {
    for (OutputFile& file : delivered.times.time("write", [&] { return map_files(ready.baked, order.mesh.maps_dir); }))
      delivered.files.push_back({std::move(file), true});
  }
  delivered.add(output.file,
                [&] { return write_glb(scene.placed, ready.baked, options, ready.coarser, ready.variants); });
  return delivered;
}

Delivered glb_files(const Output& output, const SceneViews& scene, const ReadyMeshes& ready, const Order& order,
                    const DeliverOptions& how) {
  if (order.mesh.cuttable && scene.fruit != nullptr)
    return cuttable_file(output, scene.placed, *scene.fruit, order, how);
  Delivered delivered;
  for (const std::unique_ptr<StreamedGlb>& stream : scene.streams) {
    if (stream->file() != output.file) continue;
    delivered = stream->finished(scene.placed);
    if (stream != scene.streams.front()) delivered.counts.clear(), delivered.warnings.clear();
    return delivered;
  }
  const ExportOptions options = export_options(order, how);
  if (!wants_textures(order.mesh)) {
    delivered.add(output.file, [&] {
      return scene.meshes.empty() ? write_glb(scene.placed, options, ready.levels)
                                  : write_glb(scene.placed, scene.meshes, options, ready.levels);
    });
    return delivered;
  }
  if (atlas_of(order.mesh) == AtlasOf::file) {
    const ReadyMeshes paged = delivered.times.time("bake", [&] { return on_one_atlas(ready); });
    return textured_glb(output, scene, paged, order, options, std::move(delivered));
  }
  return textured_glb(output, scene, ready, order, options, std::move(delivered));
}

Delivered usda_files(const Output& output, const Scene& scene, const ReadyMeshes& ready, const Order& order,
                     const DeliverOptions& how) {
  const ExportOptions options = export_options(order, how);
  Delivered delivered;
  const std::string stem = output.file.stem().string();
  UsdaFiles made = delivered.times.time("write", [&] {
    if (!wants_textures(order.mesh)) return write_usda(scene, stem, options, ready.levels);
    const bool is_one = atlas_of(order.mesh) == AtlasOf::file;
    const ReadyMeshes paged = is_one ? on_one_atlas(ready) : ReadyMeshes{};
    const ReadyMeshes& meshes = is_one ? paged : ready;
    return write_usda(scene, meshes.baked, stem, options, meshes.coarser, meshes.variants);
  });
  delivered.files.push_back({.file = {output.file, std::move(made.text)}});
  for (NamedFile& file : made.textures)
    delivered.files.push_back({.file = {output.file.parent_path() / file.name, std::move(file.bytes)}});
  return delivered;
}

}  // namespace

ReadyMeshes ready_meshes(const SceneViews& scene, const Order& order, const DeliverOptions& how, Delivered& delivered) {
  ReadyMeshes ready;
  const std::vector<Solid>& solids = scene.placed.solids;
  if (order.mesh.lod > 0) {
    const LodOptions lod{.levels = order.mesh.lod, .threads = order.threads};
    ready.levels = delivered.times.time("lod", [&] { return all_levels_of_detail(solids, lod); });
    tell_levels(level_counts(solids, ready.levels, order.mesh.lod), delivered);
  }
  const std::optional<BakeOptions> wanted = bake_options(order);
  if (!wanted) return ready;

  // Variants differ only in colour.
  BakeOptions bake = *wanted;
  ready.baked =
      delivered.times.time("bake", [&] { return baked_by_fruit(solids, how.texture_style, bake, how.progress); });
  ready.coarser = delivered.times.time("bake", [&] { return baked_levels(ready.levels, how.texture_style, bake); });
  count_texels(ready.baked, delivered);
  for (const std::vector<BakedSolid>& of_solid : ready.coarser) count_texels(of_solid, delivered);
  bake.maps = Maps::color;
  for (const RipenessVariant& riper : scene.variants) {
    ready.variants.push_back(
        {riper.name, delivered.times.time("bake", [&] { return all_baked(riper.pieces, how.texture_style, bake); })});
    count_texels(ready.variants.back().solids, delivered);
  }
  return ready;
}

Delivered mesh_files(const Output& output, const SceneViews& scene, const ReadyMeshes& ready, const Order& order,
                     const DeliverOptions& how) {
  const ExportOptions options = export_options(order, how);
  Delivered delivered;
  switch (output.format) {
    case Format::ply:
      delivered.add(output.file, [&] { return write_solids(scene.placed, options); });
      return delivered;
    case Format::obj:
      delivered.add(output.file, [&] { return write_obj(scene.placed, options); });
      return delivered;
    case Format::stl:
      delivered.add(output.file, [&] { return write_stl(scene.placed); });
      return delivered;
    case Format::glb:
      return glb_files(output, scene, ready, order, how);
    case Format::usda:
      return usda_files(output, scene.placed, ready, order, how);
    default:
      throw Error(ExitStatus::bug, name_of(output.format) + " is no format of meshes");
  }
}

}  // namespace pomona
