#include "render/deliver/piece_files.h"

#include <cstdint>
#include <span>
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
#include "render/export/weld.h"

namespace pomona {

namespace {

using Json = nlohmann::ordered_json;

/// Which pieces touch, and by how much.
Json contact_list(std::span<const Solid> pieces) {
  Json list = Json::array();
  for (const Weld& weld : welds_of(pieces)) {
    const PieceContact& contact = weld.contact;
    const Solid& first = pieces[static_cast<std::size_t>(contact.first)];
    Json parts = Json::object();
    for (const auto& [part, area] : weld.parts) parts[first.look->part_names[static_cast<std::size_t>(part)]] = area;
    list.push_back({{"name", weld_name(contact)},
                    {"pieces", {first.name, pieces[static_cast<std::size_t>(contact.second)].name}},
                    {"cut", contact.cut},
                    {"area", contact.area},
                    {"center", {contact.center.x, contact.center.y, contact.center.z}},
                    {"parts", std::move(parts)},
                    {"strength", weld.strength}});
  }
  return list;
}

/// The list of pieces as JSON: docs/reference/formats.md, "Piece list".
std::string piece_list(const Scene& scene, bool is_welded) {
  Json pieces = Json::array();
  for (const Instance& instance : scene.instances) {
    const Solid& solid = scene.solids[static_cast<std::size_t>(instance.solid)];
    Json piece = {{"name", instance.name},
                  {"template", solid.origin.source},
                  {"seed", solid.origin.key.seed},
                  {"index", solid.origin.key.index},
                  {"knife", knives_text(solid.origin)}};
    piece.update(facts_with_organs_json(solid));
    pieces.push_back(std::move(piece));
  }
  Json list = {{"format", 1}, {"pieces", std::move(pieces)}};
  if (is_welded) list["contacts"] = contact_list(scene.solids);
  return json_text(list, 1) + "\n";
}

}  // namespace

Delivered piece_files(SceneViews pieces, const OrderedFruit& fruit, const Order& order, const DeliverOptions& how) {
  const Scene& in_place = pieces.placed;
  Delivered delivered;
  if (!order.cut.piece_list.empty())
    delivered.add(order.cut.piece_list, [&] { return piece_list(in_place, order.mesh.welded); });

  const bool apart = order.cut.explode > 1;
  const Scene moved = apart ? exploded(in_place, order.cut.explode) : Scene();
  const bool has_models = any_is(order.outputs, model_formats), is_welded = has_models && order.mesh.welded;
  const auto on_table = [&](const Scene& whole, Peels peels) {
    return apart ? standing(moved) : laid_out(whole, picture_aspect(order, how), peels);
  };
  std::optional<Scene> shown, modelled;
  if (any_is(order.outputs, picture_formats))
    shown = on_table(order.cut.crumbs ? in_place : without_crumbs(in_place), Peels::hang);
  if (has_models) modelled = is_welded ? standing(in_place) : on_table(in_place, Peels::as_cut);
  delivered.add(files({.placed = apart ? moved : in_place,
                       .shown = shown ? &*shown : nullptr,
                       .modelled = modelled ? &*modelled : nullptr,
                       .variants = pieces.variants,
                       .plate_text = PlateText{fruit.fruit.title, fruit.fruit.latin},
                       .meshes = pieces.meshes},
                      order, how));
  return delivered;
}

}  // namespace pomona
