#include "render/deliver/piece_list.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"
#include "generator/piece/facts_json.h"

namespace pomona {

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

}  // namespace pomona
