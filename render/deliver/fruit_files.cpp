#include "render/deliver/fruit_files.h"

#include <iterator>
#include <utility>

#include "generator/piece/glass_surfaces.h"
#include "generator/scene/stand.h"
#include "render/deliver/deliver.h"
#include "render/deliver/live_files.h"
#include "render/deliver/piece_files.h"
#include "render/deliver/seed_row.h"

namespace pomona {

std::vector<Solid> whole_fruit(const OrderedFruit& fruit, const Order& order, Delivered& delivered) {
  if (order.mesh.surfaces) return glass_surfaces(fruit.grown, fruit.fruit, fruit.name);
  Slices whole = cut_to_order(fruit, order, nullptr);
  delivered.times.add(whole.times);
  delivered.warnings.insert(delivered.warnings.end(), whole.warnings.begin(), whole.warnings.end());
  return std::move(whole.pieces);
}

Delivered whole_fruit_files(const OrderedFruit& fruit, const std::optional<Template>& drawn, const Order& order,
                            const DeliverOptions& how) {
  Delivered delivered = live_files({&fruit, 1}, order, how);
  delivered.add(surface_files(fruit, order));
  const Order rest = without(order, {Format::ply, Format::html, Format::pomona});
  if (rest.outputs.empty()) return delivered;

  // In a picture it stands on the table, unless one is to see through it.
  Scene scene = gathered(whole_fruit(fruit, order, delivered));
  scene.paper = how.style.paper;
  std::optional<Scene> shown;
  if ((any_is(rest.outputs, picture_formats) || any_is(rest.outputs, model_formats)) && !order.mesh.surfaces)
    shown = standing(scene);
  const std::vector<RipenessVariant> variants =
      ripeness_variants(scene.solids, fruit, drawn, order, nullptr, delivered.times);
  delivered.add(files({.placed = scene,
                       .shown = shown ? &*shown : nullptr,
                       .modelled = shown ? &*shown : nullptr,
                       .variants = variants,
                       .plate_text = PlateText{fruit.fruit.title, fruit.fruit.latin},
                       .fruit = &fruit},
                      rest, how));
  return delivered;
}

Delivered family_files(std::span<const OrderedFruit> family, const Order& order, const DeliverOptions& how) {
  Delivered delivered = live_files(family, order, how);
  if (all_are(order.outputs, live_formats)) return delivered;
  std::vector<Solid> solids;
  for (const OrderedFruit& fruit : family) {
    std::vector<Solid> own = named_by_seed(whole_fruit(fruit, order, delivered), fruit.origin.key.seed);
    solids.insert(solids.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }
  delivered.add(files({.placed = row_of(std::move(solids), how.style)}, order, how));
  return delivered;
}

Delivered cut_fruit_files(const Scene& pieces, const OrderedFruit& fruit, const std::optional<Template>& drawn,
                          const Diffuser& diffuser, const Order& order, const DeliverOptions& how) {
  Delivered delivered = live_files({&fruit, 1}, order, how);
  const std::vector<RipenessVariant> variants =
      ripeness_variants(pieces.solids, fruit, drawn, order, &diffuser, delivered.times);
  delivered.add(piece_files({.placed = pieces, .variants = variants}, fruit, order, how));
  return delivered;
}

}  // namespace pomona
