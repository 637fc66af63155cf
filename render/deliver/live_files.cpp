#include "render/deliver/live_files.h"

#include <algorithm>
#include <memory>
#include <string>
#include <variant>

#include "generator/base/error.h"
#include "generator/knife/knife_planes.h"
#include "generator/knife/turned_wedges.h"
#include "render/deliver/export_options.h"
#include "render/deliver/ordered_diffuser.h"
#include "render/export/gltf/write_glb.h"
#include "render/page/asset_file.h"
#include "render/page/cuttable_glb.h"
#include "render/page/make_asset.h"
#include "render/page/page.h"

namespace pomona {

namespace {

/// Whether a page can open with it: it is one or several whole planes.
bool is_planes(const Knife& knife) {
  const PlaneCut* cut = std::get_if<PlaneCut>(&knife.cut);
  if (cut == nullptr || std::holds_alternative<StrokeKnife>(*cut) || std::holds_alternative<CrinkleKnife>(*cut))
    return false;
  const WedgeKnife* wedges = std::get_if<WedgeKnife>(cut);
  return wedges == nullptr || wedges->count % 2 == 0;
}

/// The step of a knife's cell number across one of its planes; 0 for wedges.
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
  if (planes.size() > max_page_cuts) {
    throw Error(ExitStatus::usage,
                "a page opens with " + std::to_string(max_page_cuts) + " planes at most; these knives have " +
                    std::to_string(planes.size()),
                "take a knife of fewer planes: the page has knives of its own");
  }
  return planes;
}

/// As slice() lays them.
std::vector<Knife> knives_at(const OrderedFruit& fruit, const Order& order) {
  return fruit.origin.growing.as_drawn ? order.cut.knives : turned_wedges(order.cut.knives, fruit.fruit);
}

/// The quality of the grid: `reference` has as many nodes as `final`.
Asset asset_of(const OrderedFruit& fruit, const Order& order, const Diffuser* diffuser) {
  const Quality quality = order.color.quality == Quality::draft ? Quality::draft : Quality::final;
  return make_asset({fruit.grown, fruit.fruit, fruit.name, fruit.origin.key.seed},
                    {.quality = quality, .diffuser = diffuser, .threads = order.threads});
}

/// The asset, coloured by the diffuser that the order names.
Asset ordered_asset(const OrderedFruit& fruit, const Order& order, const DeliveryProgress& progress) {
  std::unique_ptr<Diffuser> diffuser;
  if (order.color.diffuser.value_or(DiffuserKind::harmonic) != DiffuserKind::harmonic)
    diffuser = ordered_diffuser(order, progress);
  return asset_of(fruit, order, diffuser.get());
}

}  // namespace

void check_live_knives(std::span<const Knife> knives) {
  for (const Knife& knife : knives) {
    if (is_planes(knife)) continue;
    throw Error(ExitStatus::usage, "--knife " + knife.text + ": a page opens with planes that go right through",
                "half, across, slices, dice, sticks, plane:..., an even number of wedges; the page has knives of its "
                "own for all else");
  }
}

Delivered live_files(std::span<const OrderedFruit> family, const Order& order, const DeliverOptions& how) {
  Delivered delivered;
  if (!any_is(order.outputs, live_formats)) return delivered;
  const std::vector<PageCut> planes =
      planes_in(knives_at(family.front(), order), bounds_of(family.front().grown.sheets));
  Order grids = order;
  if (family.size() > 1) grids.color.quality = Quality::draft;
  std::vector<Asset> assets;
  for (const OrderedFruit& fruit : family)
    assets.push_back(delivered.times.time("asset", [&] { return ordered_asset(fruit, grids, how.progress); }));
  for (const Output& output : order.outputs) {
    if (output.format == Format::pomona)
      delivered.add(output.file, [&] { return write_asset(assets.front(), made_by(how.provenance)); });
    if (output.format == Format::html) {
      const PageOptions page{.style = how.style, .cuts = planes, .made_by = made_by(how.provenance)};
      delivered.add(output.file, [&] { return write_page(assets, page); });
    }
  }
  return delivered;
}

Delivered cuttable_file(const Output& output, const Scene& scene, const OrderedFruit& fruit, const Order& order,
                        const DeliverOptions& how) {
  Delivered delivered;
  const Asset asset = delivered.times.time("asset", [&] { return ordered_asset(fruit, order, how.progress); });
  const ExportOptions options = export_options(order, how);
  delivered.add(output.file,
                [&] { return with_asset(write_glb(scene, options), write_asset(asset, made_by(how.provenance))); });
  return delivered;
}

std::string asset_bytes(const OrderedFruit& fruit, const Order& order, bool fast) {
  constexpr int quick = 1, best = 9;
  return write_asset(asset_of(fruit, order, nullptr), made_by(provenance_of(order.fruit)), fast ? quick : best);
}

}  // namespace pomona
