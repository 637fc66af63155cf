#include "cli/piece_list.h"

#include <nlohmann/json.hpp>

#include "generator/piece/piece_facts.h"

namespace pomona {

namespace {

using Json = nlohmann::ordered_json;

Json numbers(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

std::string piece_list(const Scene& scene) {
  Json pieces = Json::array();
  for (const Instance& instance : scene.instances) {
    const Solid& solid = scene.solids[static_cast<std::size_t>(instance.solid)];
    const PieceFacts facts = facts_of(solid);
    pieces.push_back(
        {{"name", instance.name},
         {"template", solid.origin.source},
         {"seed", solid.origin.key.seed},
         {"index", solid.origin.key.index},
         {"knife", knives_text(solid.origin)},
         {"volume", facts.volume},
         {"density", facts.density},
         {"mass", facts.mass},
         {"center", numbers(facts.center)},
         {"inertia", Json::array({numbers(facts.inertia[0]), numbers(facts.inertia[1]), numbers(facts.inertia[2])})},
         {"low", numbers(facts.low)},
         {"high", numbers(facts.high)},
         {"triangles", facts.triangles},
         {"closed", solid.closed},
         {"crumb", solid.crumb}});
  }
  return Json{{"format", 1}, {"pieces", pieces}}.dump(1) + "\n";
}

}  // namespace pomona
