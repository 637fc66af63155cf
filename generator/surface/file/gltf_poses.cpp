#include "generator/surface/file/gltf_poses.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "generator/surface/file/gltf_json.h"

namespace pomona {

namespace {

constexpr std::size_t max_instances = 65536;  // of one node

/// True for a quaternion of length 1, as far as rounding to bytes allows.
bool is_turn(double x, double y, double z, double w) {
  constexpr double rounding = 0.02;
  return std::fabs(std::sqrt(x * x + y * y + z * z + w * w) - 1) <= rounding;
}

}  // namespace

glm::dmat4 transform_of(const tinygltf::Node& node, const GltfPlace& place) {
  if (node.rotation.size() == 4 && !is_turn(node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]))
    place.refuse("its rotation is no unit quaternion");
  glm::dmat4 result(1);
  if (node.matrix.size() == 16) {
    for (int k = 0; k < 16; ++k) result[k / 4][k % 4] = node.matrix[static_cast<std::size_t>(k)];
    return result;
  }
  if (node.rotation.size() == 4) {
    result = glm::mat4_cast(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
  }
  for (int k = 0; k < 3 && node.scale.size() == 3; ++k) result[k] *= node.scale[static_cast<std::size_t>(k)];
  for (int k = 0; k < 3 && node.translation.size() == 3; ++k)
    result[3][k] = node.translation[static_cast<std::size_t>(k)];
  return result;
}

std::vector<glm::dmat4> instance_places(const tinygltf::Model& model, const tinygltf::Node& node,
                                        const glm::dmat4& to_scene, const GltfPlace& place) {
  const auto extension = node.extensions.find(gltf_instancing);
  if (extension == node.extensions.end() || node.skin >= 0) return {to_scene};
  const tinygltf::Value& attributes = extension->second.Get("attributes");
  const auto table = [&](const char* name, std::size_t width) -> std::optional<AccessorTable> {
    if (!attributes.IsObject() || !attributes.Has(name)) return {};
    AccessorTable values = accessor_table(model, attributes.Get(name).GetNumberAsInt(), place.within(name));
    if (values.width != width) place.within(name).refuse("it has another number of components");
    return values;
  };
  const auto translation = table("TRANSLATION", 3), rotation = table("ROTATION", 4), scale = table("SCALE", 3);
  const std::optional<AccessorTable>& first = translation ? translation : rotation ? rotation : scale;
  if (!first) place.refuse("its instances have no places");
  if (first->count > max_instances) place.refuse("more than 65 536 instances", "export fewer");
  for (const std::optional<AccessorTable>& other : {translation, rotation, scale})
    if (other && other->count != first->count) place.refuse("its instances have lists of unequal length");
  std::vector<glm::dmat4> places;
  for (std::size_t i = 0; i < first->count; ++i) {
    glm::dmat4 instance(1);
    if (rotation && !is_turn(rotation->at(i, 0), rotation->at(i, 1), rotation->at(i, 2), rotation->at(i, 3)))
      place.within("ROTATION, instance " + std::to_string(i)).refuse("it is no unit quaternion");
    if (rotation)
      instance = glm::mat4_cast(
          glm::normalize(glm::dquat(rotation->at(i, 3), rotation->at(i, 0), rotation->at(i, 1), rotation->at(i, 2))));
    for (int k = 0; k < 3; ++k) {
      if (scale) instance[k] *= scale->at(i, static_cast<std::size_t>(k));
      if (translation) instance[3][k] = translation->at(i, static_cast<std::size_t>(k));
    }
    places.push_back(to_scene * instance);
  }
  return places;
}

std::vector<glm::dmat4> skin_joints(const tinygltf::Model& model, int index,
                                    const std::vector<std::optional<glm::dmat4>>& to_scene, const GltfPlace& place) {
  if (static_cast<std::size_t>(index) >= model.skins.size()) place.refuse("there is no such skin");
  const tinygltf::Skin& skin = model.skins[static_cast<std::size_t>(index)];
  if (skin.joints.empty()) place.refuse("its skin has no joints");
  std::optional<AccessorTable> inverse;
  if (skin.inverseBindMatrices >= 0)
    inverse = accessor_table(model, skin.inverseBindMatrices, place.within("inverseBindMatrices"));
  if (inverse && (inverse->width != 16 || inverse->count < skin.joints.size()))
    place.within("inverseBindMatrices").refuse("it needs a matrix for each joint");
  std::vector<glm::dmat4> joints;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const auto node = static_cast<std::size_t>(skin.joints[i]);
    if (node >= to_scene.size() || !to_scene[node]) place.refuse("a joint of its skin is not in the scene");
    glm::dmat4 from_mesh(1);
    for (int k = 0; k < 16 && inverse; ++k) from_mesh[k / 4][k % 4] = inverse->at(i, static_cast<std::size_t>(k));
    joints.push_back(*to_scene[node] * from_mesh);
  }
  return joints;
}

std::vector<glm::dvec3> morphed(std::vector<glm::dvec3> position, const tinygltf::Model& model,
                                const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                                const GltfPlace& place) {
  if (!weights.empty() && weights.size() != primitive.targets.size())
    place.within("morph targets").refuse("it needs one weight for each target");
  for (std::size_t t = 0; t < std::min(weights.size(), primitive.targets.size()); ++t) {
    const auto found = primitive.targets[t].find("POSITION");
    if (weights[t] == 0 || found == primitive.targets[t].end()) continue;
    const AccessorTable moved = accessor_table(model, found->second, place.within("morph target"));
    if (moved.width != 3 || moved.count != position.size())
      place.within("morph target").refuse("it needs one place for each vertex");
    for (std::size_t i = 0; i < position.size(); ++i)
      position[i] += weights[t] * glm::dvec3(moved.at(i, 0), moved.at(i, 1), moved.at(i, 2));
  }
  return position;
}

std::vector<glm::dvec3> posed(const std::vector<glm::dvec3>& position, const tinygltf::Model& model,
                              const tinygltf::Primitive& primitive, const std::vector<glm::dmat4>& joints,
                              const GltfPlace& place) {
  std::vector<glm::dvec3> sum(position.size(), glm::dvec3(0));
  std::vector<double> total(position.size(), 0);
  for (int set = 0; primitive.attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
    const auto weights_at = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
    if (weights_at == primitive.attributes.end()) place.refuse("its joints have no weights");
    const AccessorTable joint =
        accessor_table(model, primitive.attributes.at("JOINTS_" + std::to_string(set)), place.within("JOINTS"));
    const AccessorTable weight = accessor_table(model, weights_at->second, place.within("WEIGHTS"));
    if (joint.width != 4 || weight.width != 4 || joint.count != position.size() || weight.count != position.size())
      place.refuse("it needs four joints and weights for each vertex");
    for (std::size_t i = 0; i < position.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double w = weight.at(i, k);
        if (w == 0) continue;
        if (!(joint.at(i, k) >= 0 && joint.at(i, k) < static_cast<double>(joints.size())))
          place.within("vertex " + std::to_string(i)).refuse("there is no such joint");
        sum[i] += w * glm::dvec3(joints[static_cast<std::size_t>(joint.at(i, k))] * glm::dvec4(position[i], 1));
        total[i] += w;
      }
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (!(total[i] > 0)) place.within("vertex " + std::to_string(i)).refuse("no joint holds it");
    sum[i] /= total[i];
  }
  return sum;
}

}  // namespace pomona
