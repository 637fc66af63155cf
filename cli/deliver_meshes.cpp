// The part of Delivery that writes meshes with levels of detail and textures: .glb and .usda.
#include <algorithm>
#include <memory>
#include <optional>
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

void Delivery::set_outputs(const std::vector<Output>& outputs) { outputs_ = outputs; }

/// Nothing unless --lod asks for it.
std::vector<std::vector<Solid>> Delivery::levels_of(const Scene& scene) {
  if (options_.lod == 0) return {};
  const LodOptions how{.levels = options_.lod, .threads = {options_.threads}};
  std::vector<std::vector<Solid>> levels = times.time("lod", [&] { return all_levels_of_detail(scene.solids, how); });
  const LevelCounts counts = level_counts(scene.solids, levels, options_.lod);
  count_levels(counts, times);
  warn(level_warnings(counts));
  return levels;
}

/// Nothing unless textures are asked for. Maps are for .glb alone.
std::optional<BakeOptions> Delivery::bake_options() const {
  if (!wants_textures(options_)) return {};
  const bool any_glb =
      std::any_of(outputs_.begin(), outputs_.end(), [](const Output& output) { return output.format == Format::glb; });
  BakeOptions how{.texel = texel_,
                  .maps = any_glb && options_.maps == "all" ? Maps::all : Maps::color,
                  .threads = {options_.threads}};
  if (options_.texture > 0) how.texels = options_.texture;
  return how;
}

/// All of it in textures, at every level and ripeness; variants differ in colour alone.
Delivery::BakedScene Delivery::baked_scene(const Scene& scene, std::span<const std::vector<Solid>> levels) {
  BakedScene baked;
  const std::optional<BakeOptions> wanted = bake_options();
  if (!wanted) return baked;
  BakeOptions how = *wanted;
  baked.solids = times.time("bake", [&] { return baked_by_fruit(scene.solids, style_, how, progress); });
  baked.coarser = times.time("bake", [&] { return baked_levels(levels, style_, how); });
  count_texels(baked.solids, times);
  for (const std::vector<BakedSolid>& of_solid : baked.coarser) count_texels(of_solid, times);
  how.maps = Maps::color;
  for (const RipenessVariant& riper : variants_) {
    baked.variants.push_back({riper.name, times.time("bake", [&] { return all_baked(riper.pieces, style_, how); })});
    count_texels(baked.variants.back().solids, times);
  }
  return baked;
}

/// They are let go with the last output that wants them.
std::shared_ptr<const Delivery::ReadyMeshes> Delivery::ready_meshes(const Scene& scene) {
  const auto wants_them = [](const Output& output) {
    return output.format == Format::glb || output.format == Format::usda;
  };
  std::shared_ptr<const ReadyMeshes> ready = ready_;
  if (!ready || ready->of != scene.solids.data()) {
    ReadyMeshes made{scene.solids.data(), levels_of(scene), {}};
    made.baked = baked_scene(scene, made.levels);
    ready = std::make_shared<const ReadyMeshes>(std::move(made));
    uses_left_ = std::count_if(outputs_.begin(), outputs_.end(), wants_them);
  }
  ready_ = --uses_left_ > 0 ? ready : nullptr;
  return ready;
}

void Delivery::add_glb(const Output& output, const Scene& scene) {
  for (const std::unique_ptr<StreamedGlb>& stream : streams_)
    if (stream->file() == output.file) return finish_glb(*stream, scene);
  const ExportOptions options = export_options();
  const std::shared_ptr<const ReadyMeshes> ready = ready_meshes(scene);
  const BakedScene& baked = ready->baked;
  if (!wants_textures(options_)) return add(output.file, [&] { return write_glb(scene, options, ready->levels); });
  if (!options_.maps_dir.empty()) {
    for (OutputFile& file : times.time("write", [&] { return map_files(baked.solids, options_.maps_dir); }))
      add_counted(std::move(file));
  }
  add(output.file, [&] { return write_glb(scene, baked.solids, options, baked.coarser, baked.variants); });
}

void Delivery::add_usda(const Output& output, const Scene& scene) {
  const ExportOptions options = export_options();
  const std::shared_ptr<const ReadyMeshes> ready = ready_meshes(scene);
  const BakedScene& baked = ready->baked;
  if (!wants_textures(options_)) return add(output.file, [&] { return write_usda(scene, options, ready->levels); });
  const std::string stem = output.file.stem().string();
  UsdaFiles made = times.time(
      "write", [&] { return write_usda(scene, baked.solids, stem, options, baked.coarser, baked.variants); });
  files_.push_back({output.file, std::move(made.text)});
  for (NamedFile& file : made.textures)
    files_.push_back({output.file.parent_path() / file.name, std::move(file.bytes)});
}

std::function<void(std::span<const Solid> solids)> Delivery::taker() {
  const auto is_streamed = [](const Output& output) { return output.format == Format::glb; };
  const auto needs_no_looks = [](const Output& output) {
    return output.format == Format::glb || output.format == Format::json;
  };
  if (!options_.maps_dir.empty() || std::none_of(outputs_.begin(), outputs_.end(), is_streamed)) return {};
  if (!std::all_of(outputs_.begin(), outputs_.end(), needs_no_looks)) return {};
  for (const Output& output : outputs_) {
    if (!is_streamed(output)) continue;
    const StreamedGlbOptions how{.exported = export_options(), .lod = options_.lod, .bake = bake_options()};
    streams_.push_back(std::make_unique<StreamedGlb>(output.file, how));
  }
  return [this](std::span<const Solid> solids) {
    for (const std::unique_ptr<StreamedGlb>& stream : streams_) stream->take(solids);
  };
}

void Delivery::finish_glb(StreamedGlb& stream, const Scene& scene) {
  files_.push_back(stream.finished(scene));
  times.add(stream.times());
  if (&stream != streams_.front().get()) return;
  count_levels(stream.levels(), times);
  warn(level_warnings(stream.levels()));
}

}  // namespace pomona
