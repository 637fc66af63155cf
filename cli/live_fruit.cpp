#include "cli/live_fruit.h"

#include <algorithm>
#include <memory>
#include <string>
#include <variant>

#include "cli/diffusers.h"
#include "cli/version.h"
#include "generator/base/error.h"
#include "generator/knife/knife_planes.h"
#include "render/export/gltf/write_glb.h"
#include "render/page/asset_file.h"
#include "render/page/cuttable_glb.h"
#include "render/page/make_asset.h"
#include "render/page/page.h"

namespace pomona {

namespace {

/// Whether a page can open with it: a plane right through the fruit, or several.
bool is_planes(const Knife& knife) {
  const PlaneCut* cut = std::get_if<PlaneCut>(&knife.cut);
  if (cut == nullptr || std::holds_alternative<StrokeKnife>(*cut) || std::holds_alternative<CrinkleKnife>(*cut))
    return false;
  const WedgeKnife* wedges = std::get_if<WedgeKnife>(cut);
  return wedges == nullptr || wedges->count % 2 == 0;
}

/// By how much the number of a knife's cell grows beyond one of its planes; 0 of wedges.
int step_beyond(const KnifePlanes& knife, std::size_t plane) {
  if (knife.wedges > 0) return 0;
  KnifeSides before;
  return knife.cell(knife.seen(before, plane, true)) - knife.cell(before);
}

std::vector<PageCut> planes_in(std::span<const Knife> knives, const Box<double>& bounds) {
  std::vector<PageCut> planes;
  for (std::size_t k = 0; k < knives.size(); ++k) {
    const KnifePlanes laid = planes_of(knives[k], bounds);
    for (std::size_t i = 0; i < laid.planes.size(); ++i)
      planes.push_back({laid.planes[i], static_cast<int>(k), step_beyond(laid, i)});
  }
  if (planes.size() > most_page_cuts) {
    throw Error(ExitStatus::usage,
                "a page opens with " + std::to_string(most_page_cuts) + " planes at most; these knives have " +
                    std::to_string(planes.size()),
                "take a knife of fewer planes: the page has knives of its own");
  }
  return planes;
}

/// Of the grid.
Quality quality_of(const SharedOptions& options) {
  return options.quality == "draft" ? Quality::draft : Quality::final;
}

Asset live_asset(const FruitSource& source, const SharedOptions& options, Quality quality, const Diffuser* diffuser) {
  const MakeAssetOptions how{.quality = quality, .diffuser = diffuser, .threads = {options.threads}};
  return make_asset({source.grown, source.fruit, source.name, source.origin.key.seed}, how);
}

Asset asset_of(const FruitSource& source, const SharedOptions& options, Quality quality, Delivery& delivery) {
  std::unique_ptr<Diffuser> diffuser;
  if (options.diffuser_given && options.diffuser != "harmonic") diffuser = make_diffuser(options, delivery.progress);
  return delivery.times.time("asset", [&] { return live_asset(source, options, quality, diffuser.get()); });
}

std::string maker_of(const SharedOptions& options) {
  return std::string("pomona ") + version + ", seed " + std::to_string(options.seed);
}

}  // namespace

bool any_live(const std::vector<Output>& outputs) {
  return std::any_of(outputs.begin(), outputs.end(), [](const Output& output) { return is_live(output.format); });
}

bool all_live(const std::vector<Output>& outputs) {
  return std::all_of(outputs.begin(), outputs.end(), [](const Output& output) { return is_live(output.format); });
}

void check_live_knives(std::span<const Knife> knives) {
  for (const Knife& knife : knives) {
    if (is_planes(knife)) continue;
    throw Error(ExitStatus::usage, "--knife " + knife.text + ": a page opens with planes that go right through",
                "half, across, slices, dice, sticks, plane:..., an even number of wedges; the page has knives of its "
                "own for all else");
  }
}

void add_live(const std::vector<Output>& outputs, const FruitSource& source, std::span<const Knife> knives,
              const SharedOptions& options, Delivery& delivery, std::span<const FruitSource> beside) {
  if (!any_live(outputs)) return;
  const std::vector<PageCut> planes = planes_in(knives, bounds_of(source.grown.sheets));
  const Quality quality = quality_of(options);
  const Asset asset = asset_of(source, options, beside.empty() ? quality : Quality::draft, delivery);
  std::vector<Asset> family = {asset};
  for (const FruitSource& other : beside) family.push_back(asset_of(other, options, Quality::draft, delivery));
  const std::string made_by = maker_of(options);
  for (const Output& output : outputs) {
    if (output.format == Format::pomona) delivery.add(output.file, [&] { return write_asset(asset, made_by); });
    if (output.format == Format::html) {
      const PageOptions page{.style = delivery.style(), .cuts = planes, .made_by = made_by};
      delivery.add(output.file, [&] { return write_page(family, page); });
    }
  }
}

void add_cuttable(const Output& output, const Scene& scene, const FruitSource& source, const SharedOptions& options,
                  Delivery& delivery) {
  const Asset asset = asset_of(source, options, quality_of(options), delivery);
  const std::string made_by = maker_of(options);
  const ExportOptions how{.style = delivery.style(), .provenance = made_by, .threads = {options.threads}};
  delivery.add(output.file, [&] { return with_asset(write_glb(scene, how), write_asset(asset, made_by)); });
}

std::string live_bytes(const FruitSource& source, const SharedOptions& options, bool fast) {
  constexpr int quick = 1, best = 9;
  return write_asset(live_asset(source, options, quality_of(options), nullptr), maker_of(options), fast ? quick : best);
}

}  // namespace pomona
