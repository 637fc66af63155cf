#include "generator/piece/facts_json.h"

#include <nlohmann/json.hpp>

#include "generator/piece/piece_facts.h"

namespace pomona {

namespace {

using Json = nlohmann::ordered_json;

Json numbers(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

Json facts_json(const Solid& solid) {
  const PieceFacts facts = facts_of(solid);
  Json json = {
      {"volume", facts.volume},
      {"density", facts.density},
      {"mass", facts.mass},
      {"center", numbers(facts.center)},
      {"inertia", Json::array({numbers(facts.inertia[0]), numbers(facts.inertia[1]), numbers(facts.inertia[2])})},
      {"low", numbers(facts.low)},
      {"high", numbers(facts.high)},
      {"triangles", facts.triangles},
      {"closed", solid.closed},
      {"crumb", solid.crumb}};
  if (!solid.instances.empty()) json["instances"] = solid.instances;
  return json;
}

Json facts_with_organs_json(const Solid& solid) {
  Json json = facts_json(solid);
  for (const Organ& organ : solid.organs)
    json["organs"].push_back(
        {{"instance", organ.instance}, {"name", organ.name}, {"volume", organ.volume}, {"mass", organ.mass}});
  return json;
}

}  // namespace pomona
