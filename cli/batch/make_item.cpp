#include "cli/batch/make_item.h"

#include <algorithm>
#include <utility>

#include "cli/exhausted.h"
#include "cli/scene_levels.h"
#include "cli/version.h"
#include "generator/base/error.h"
#include "generator/base/sha256.h"
#include "generator/batch/item_record.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/piece/lod/levels_of_detail.h"
#include "generator/piece/slice.h"
#include "generator/scene/lay_out.h"
#include "render/export/gltf/write_glb.h"
#include "render/export/ply.h"
#include "render/export/svg.h"
#include "render/image/png.h"
#include "render/strokes/scene_strokes.h"
#include "render/thumbnail/thumbnail.h"

namespace pomona {

namespace {

constexpr Threads alone{1};  ///< an item is made by one thread; a batch makes many

// Of drawings, as `pomona cut` makes them.
constexpr int drawing_width = 960, drawing_height = 720;

GrowOptions grow_options(const BatchPlan& plan, const BatchVariant& which) {
  const AssetOptions& assets = plan.entries[which.entry].wanted.assets;
  return {.as_drawn = which.seed == 0,
          .variation = assets.variation,
          .folds = which.folds,
          .detail = assets.detail,
          .ripeness = which.ripeness};
}

/// The template as the entry calls it.
std::string source_of(const BatchPlan& plan, const BatchVariant& which) {
  const PlannedEntry& entry = plan.entries[which.entry];
  const auto at = std::find(entry.templates.begin(), entry.templates.end(), which.fruit) - entry.templates.begin();
  const auto number = static_cast<std::size_t>(at);
  const std::vector<TemplateWanted>& wanted = entry.wanted.templates;
  return number < wanted.size() ? source_word(wanted[number].name) : plan.templates[which.fruit].name;
}

/// The pieces where they grew, as `pomona cut` has them, too.
Scene pieces_of(const BatchEntry& entry, const GrownVariant& grown, const BatchItem& item, const std::string& name,
                const Diffuser& diffuser, const Style& style, std::vector<std::string>& warnings) {
  Template variant = grown.variant();
  variant.individual.browning = item.browning;
  PieceOrigin origin = grown.origin();
  origin.growing.browning = item.browning;
  const std::vector<Knife>& knives = entry.knives[item.knives];
  Slices slices =
      slice({.grown = grown.grown(), .variant = variant, .knives = knives, .name = name, .origin = origin}, &diffuser,
            {.cut = {.threads = alone}, .keep_section_colors = item.texture > 0, .threads = alone});
  warnings = std::move(slices.warnings);
  Scene scene = gathered(std::move(slices.pieces));
  scene.paper = style.paper;
  return scene;
}

/// \param meshes of the scene's solids, where they are at hand.
std::string glb(const Scene& scene, std::span<const StyledMesh> meshes, const AssetOptions& assets,
                const BatchItem& item, const ExportOptions& options) {
  std::vector<std::vector<Solid>> levels;
  if (item.lod > 0) levels = all_levels_of_detail(scene.solids, {.levels = item.lod, .threads = alone});
  if (item.texture == 0 && !meshes.empty()) return write_glb(scene, meshes, options, levels);
  if (item.texture == 0) return write_glb(scene, options, levels);
  const BakeOptions how{.texels = item.texture, .maps = assets.all_maps ? Maps::all : Maps::color, .threads = alone};
  const std::vector<BakedSolid> baked = all_baked(scene.solids, options.style, how);
  return write_glb(scene, baked, options, baked_levels(levels, options.style, how));
}

std::vector<SceneStroke> strokes(const Scene& scene, const Style& style) {
  return scene_strokes(scene, style, {.width = drawing_width, .height = drawing_height, .threads = alone});
}

std::vector<NamedFile> pov(const Scene& scene, const std::string& name, const ExportOptions& options) {
  return write_pov(scene, name, options, {drawing_width, drawing_height, strokes(scene, options.style)});
}

std::string svg(Scene scene, const ExportOptions& options) {
  constexpr double aspect = static_cast<double>(drawing_width) / drawing_height;
  scene.view = fitted_view(scene, scene.view.eye - scene.view.target, aspect);
  return write_svg(scene, strokes(scene, options.style), {drawing_width, drawing_height}, options.provenance);
}

std::string thumbnail(const Scene& laid, std::span<const StyledMesh> meshes, const AssetOptions& assets,
                      const Style& style) {
  return write_png(
      draw_thumbnail(laid, meshes, style, {.size = assets.thumbnail, .on_paper = assets.thumbnail_on_paper}));
}

/// Whether any solid has another shape.
bool is_bent(const Scene& laid, const Scene& scene) {
  return !std::equal(laid.solids.begin(), laid.solids.end(), scene.solids.begin(), scene.solids.end(),
                     [](const Solid& a, const Solid& b) { return a.position == b.position; });
}

std::vector<NamedFile> asset_files(const AssetOptions& assets, const BatchItem& item, const Scene& scene,
                                   const std::string& name, const ExportOptions& options) {
  // A thumbnail shows the pieces elsewhere; their meshes are the same, but for a peel that hangs.
  std::vector<NamedFile> files;
  const Scene laid = laid_out(scene, 1);
  const std::vector<StyledMesh> meshes =
      assets.thumbnail > 0 ? styled_meshes(scene, options) : std::vector<StyledMesh>();
  for (const AssetFormat format : assets.formats) {
    const std::string file = name + "." + name_of(format);
    if (format == AssetFormat::glb) files.push_back({file, glb(scene, meshes, assets, item, options)});
    if (format == AssetFormat::ply) files.push_back({file, write_solids(scene, options)});
    if (format == AssetFormat::svg) files.push_back({file, svg(laid, options)});
    if (format != AssetFormat::pov) continue;
    for (NamedFile& part : pov(scene, name, options)) files.push_back(std::move(part));
  }
  if (assets.thumbnail > 0)
    files.push_back({"thumbnail.png", thumbnail(laid, is_bent(laid, scene) ? styled_meshes(laid, options) : meshes,
                                                assets, options.style)});
  return files;
}

/// As Delivery's: the item is what `pomona cut` makes with the same words.
std::string command_words(const AssetOptions& assets, const BatchItem& item) {
  std::string words;
  if (item.quality != Quality::final) words += std::string(" --quality ") + name_of(item.quality);
  if (item.texture > 0) words += " --texture " + std::to_string(item.texture);
  if (item.texture > 0 && !assets.all_maps) words += " --maps color";
  if (item.lod > 0) words += " --lod " + std::to_string(item.lod);
  return words;
}

std::vector<RecordedFile> recorded(const std::vector<NamedFile>& files) {
  std::vector<RecordedFile> records;
  for (const NamedFile& file : files) records.push_back({file.name, file.bytes.size(), sha256(file.bytes)});
  return records;
}

}  // namespace

GrownVariant::GrownVariant(const BatchPlan& plan, const Variation& variation, const BatchVariant& which)
    : which_(which) {
  const GrowOptions how = grow_options(plan, which);
  const VariantKey key{which.seed, 0};
  variant_ = how.as_drawn ? variant_of(variation.drawn(), key, how) : variant_of(variation, key, how);
  grown_ = grow(variant_, key, how);
  origin_ = {.source = source_of(plan, which), .key = key, .growing = how};
}

std::string reason_of(const std::exception& error) {
  if (const auto* told = dynamic_cast<const Error*>(&error)) return told->diagnostics().front().message;
  if (const auto lack = exhausted(error)) return *lack;
  return std::string("this is a bug in pomona: ") + error.what();
}

MadeItem make_item(const BatchPlan& plan, const BatchVariant& which, const GrownVariant* grown,
                   const std::string& growing_error, const BatchItem& item, const Style& style) {
  const PlannedEntry& entry = plan.entries[which.entry];
  const std::string& name = plan.templates[which.fruit].name;
  MadeItem made{.item = item_path(entry.wanted.name, entry.items(), item.number), .files = {}, .error = growing_error};

  // Cut it and make its files; whatever goes wrong with that is this item's alone.
  ItemOutcome outcome;
  Scene scene;
  try {
    if (grown != nullptr) {
      const auto diffuser = make_pmvc_diffuser({.quality = item.quality, .threads = alone});
      scene = pieces_of(entry.wanted, *grown, item, name, *diffuser, style, outcome.warnings);
      const ExportOptions options{
          .style = style,
          .provenance = std::string("pomona ") + version + ", seed " + std::to_string(which.seed),
          .command_words = command_words(entry.wanted.assets, item),
          .threads = alone};
      made.files = asset_files(entry.wanted.assets, item, scene, name, options);
      outcome.pieces = scene.solids;
      outcome.files = recorded(made.files);
    }
  } catch (const std::exception& error) {
    made.error = reason_of(error);
  }

  // The record is all that is left of an item that failed.
  if (!made.error.empty()) {
    made.files.clear();
    outcome = {.error = made.error};
  }
  made.files.push_back({"item.json", item_record(plan, which, item, outcome)});
  return made;
}

std::uint64_t memory_of_an_item(const PlannedEntry& entry) {
  constexpr std::uint64_t megabyte = 1'000'000;
  const AssetOptions& assets = entry.wanted.assets;
  const double detail = std::max(1.0, assets.detail * assets.detail);
  const auto surfaces = static_cast<std::uint64_t>(80 * detail) * megabyte;
  const auto side = static_cast<std::uint64_t>(assets.thumbnail);
  const auto texels = static_cast<std::uint64_t>(*std::max_element(assets.textures.begin(), assets.textures.end()));
  constexpr std::uint64_t of_a_texel = 200, of_a_pixel = 640;
  return surfaces + of_a_texel * texels * texels + of_a_pixel * side * side;
}

}  // namespace pomona
