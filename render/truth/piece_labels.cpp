#include "render/truth/piece_labels.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include "generator/piece/piece_facts.h"
#include "generator/piece/piece_state.h"

namespace pomona {

namespace {

using Json = nlohmann::ordered_json;
constexpr double millimetres = 1000;

}  // namespace

Json state_labels(const Solid& solid) {
  const PieceOrigin& origin = solid.origin;
  if (origin.fruit.empty()) return Json::object();
  const PieceState state = state_of(solid);
  Json labels = {{"state", name_of(state.state)}, {"peeled", state.peeled},      {"knives", origin.knives},
                 {"piece", origin.number},        {"pieces", origin.pieces},     {"seed", origin.key.seed},
                 {"index", origin.key.index},     {"size", origin.growing.scale}};
  if (origin.growing.ripeness) labels["ripeness"] = *origin.growing.ripeness;
  labels["browning"] = origin.growing.browning;
  return labels;
}

Json camera_pose(const Instance& instance, const Solid& solid, const Lens& lens) {
  const ViewFrame& frame = lens.frame();
  const glm::dmat3 to_camera = glm::transpose(glm::dmat3(frame.right, -frame.up, -frame.back));
  const glm::dmat3 turn = to_camera * glm::mat3_cast(instance.pose.rotation);
  const glm::dvec3 middle = instance.pose.rotation * facts_of(solid).center + instance.pose.translation;
  const glm::dvec3 place = millimetres * (to_camera * (middle - lens.eye()));
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) rows.push_back(turn[column][row]);
  return {{"cam_R_m2c", rows}, {"cam_t_m2c", {place.x, place.y, place.z}}};
}

}  // namespace pomona
