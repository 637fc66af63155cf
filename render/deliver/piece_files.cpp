#include "render/deliver/piece_files.h"

#include <utility>

#include "generator/scene/explode.h"
#include "generator/scene/lay_out.h"
#include "generator/scene/stand.h"
#include "render/deliver/deliver.h"
#include "render/deliver/piece_list.h"

namespace pomona {

Delivered piece_files(SceneViews pieces, const OrderedFruit& fruit, const Order& order, const DeliverOptions& how) {
  const Scene& in_place = pieces.placed;
  Delivered delivered;
  if (!order.cut.piece_list.empty()) delivered.add(order.cut.piece_list, [&] { return piece_list(in_place); });

  const bool apart = order.cut.explode > 1;
  const Scene moved = apart ? exploded(in_place, order.cut.explode) : Scene();
  std::optional<Scene> shown;
  if (any_is(order.outputs, picture_formats))
    shown = apart ? standing(moved) : laid_out(in_place, picture_aspect(order, how));
  delivered.add(files({.placed = apart ? moved : in_place,
                       .shown = shown ? &*shown : nullptr,
                       .variants = pieces.variants,
                       .plate_text = PlateText{fruit.fruit.title, fruit.fruit.latin},
                       .meshes = pieces.meshes},
                      order, how));
  return delivered;
}

}  // namespace pomona
