#include "render/deliver/piece_files.h"

#include <cstdint>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"
#include "generator/piece/facts_json.h"
#include "generator/scene/explode.h"
#include "generator/scene/lay_out.h"
#include "generator/scene/scene.h"
#include "generator/scene/stand.h"
#include "render/deliver/deliver.h"

namespace pomona {

namespace {

/// The list of pieces as JSON: docs/reference/formats.md, "Piece list".
std::string piece_list(const Scene& scene) {
  using Json = nlohmann::ordered_json;
  Json pieces = Json::array();
  for (const Instance& instance : scene.instances) {
    const Solid& solid = scene.solids[static_cast<std::size_t>(instance.solid)];
    Json piece = {{"name", instance.name},
                  {"template", solid.origin.source},
                  {"seed", solid.origin.key.seed},
                  {"index", solid.origin.key.index},
                  {"knife", knives_text(solid.origin)}};
    piece.update(facts_json(solid));
    pieces.push_back(std::move(piece));
  }
  return json_text(Json{{"format", 1}, {"pieces", pieces}}, 1) + "\n";
}

}  // namespace

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
