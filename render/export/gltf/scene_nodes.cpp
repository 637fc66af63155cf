#include "render/export/gltf/scene_nodes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "render/export/gltf/engine_names.h"
#include "render/export/gltf/vertex_buffers.h"
#include "render/export/piece_groups.h"
#include "render/picture/view_frame.h"

namespace pomona::gltf {

namespace {

glm::dquat unit(const glm::dquat& rotation) {
  const double length = std::sqrt(glm::dot(rotation, rotation));
  return length > 0 ? rotation / length : glm::dquat(1, 0, 0, 0);
}

Json xyzw(const glm::dquat& q) { return {q.x, q.y, q.z, q.w}; }

/// The place of the pivot.
glm::dvec3 place_of(const Pose& pose, const glm::vec3& pivot) {
  return unit(pose.rotation) * glm::dvec3(pivot) + pose.translation;
}

/// The share of the screen down to which each level serves: a tenth for the solid, and half of it for each coarser
/// level; the coarsest serves down to nothing.
Json screen_coverage(std::size_t levels) {
  Json shares = Json::array();
  double share = 0.1;
  for (std::size_t level = 0; level + 1 < levels; ++level, share /= 2) shares.push_back(share);
  shares.push_back(0.0);
  return shares;
}

/// The instances of one solid that become one node: one, or all of them.
struct PlacedSolid {
  std::string name;
  std::vector<const Instance*> instances;
};

class NodeWriter {
 public:
  NodeWriter(GltfDocument& document, const ExportOptions& options) : document_(document), options_(options) {}

  /// The index of the node; its levels and its hull are added with it.
  int add(const PlacedSolid& placed, const SolidMeshes& solid, const OwnMeshes& own);

  /// After all: groups of coarser levels that lie beside each other; none but for Blender.
  Json added_levels_beside();

 private:
  Json where(const PlacedSolid& placed, const glm::vec3& pivot);
  void add_shapes(Json& node, const SolidMeshes& solid, std::span<const int> hulls);
  void add_levels(Json& node, const PlacedSolid& placed, const SolidMeshes& solid, const Json& where);

  GltfDocument& document_;
  const ExportOptions& options_;
  std::vector<Json> beside_;  ///< for Blender: the nodes of each coarser level
  double left_ = 0, right_ = 0;
};

/// Blender knows no levels and shows all nodes: so each coarser level is a copy of the scene to the right of the one
/// before.
Json NodeWriter::added_levels_beside() {
  Json groups = Json::array();
  for (std::size_t level = 0; level < beside_.size(); ++level) {
    const double away = 1.1 * static_cast<double>(level + 1) * (right_ - left_);
    Json group = {{"name", "LOD" + std::to_string(level + 1)}, {"translation", {away, 0.0, 0.0}}};
    group["children"] = std::move(beside_[level]);
    groups.push_back(document_.add("nodes", std::move(group)));
  }
  return groups;
}

/// Rotation and translation of a single instance; arrays of them for many.
Json NodeWriter::where(const PlacedSolid& placed, const glm::vec3& pivot) {
  Json node = Json::object();
  if (placed.instances.size() == 1) {
    const Pose& pose = placed.instances[0]->pose;
    const glm::dvec3 place = place_of(pose, pivot);
    if (pose.rotation != glm::dquat(1, 0, 0, 0)) node["rotation"] = xyzw(unit(pose.rotation));
    if (place != glm::dvec3(0)) node["translation"] = {place.x, place.y, place.z};
    return node;
  }
  std::vector<glm::vec3> translation;
  std::vector<glm::vec4> rotation;
  for (const Instance* instance : placed.instances) {
    translation.emplace_back(place_of(instance->pose, pivot));
    const glm::dquat q = unit(instance->pose.rotation);
    rotation.emplace_back(q.x, q.y, q.z, q.w);
  }
  const auto add = [&](const void* data, std::size_t bytes, const char* type) {
    return document_.add_accessor(document_.add_view(data, bytes, Target::none), 0, translation.size(), Component::f32,
                                  type);
  };
  Json attributes;
  attributes["TRANSLATION"] = add(translation.data(), translation.size() * sizeof(glm::vec3), "VEC3");
  attributes["ROTATION"] = add(rotation.data(), rotation.size() * sizeof(glm::vec4), "VEC4");
  node["extensions"]["EXT_mesh_gpu_instancing"] = {{"attributes", std::move(attributes)}};
  document_.use_extension("EXT_mesh_gpu_instancing");
  return node;
}

/// Back from the steps of a coded mesh to metres.
void scale(Json& node, const SolidMeshes& solid, std::size_t level) {
  if (level < solid.scales.size()) node["scale"] = {solid.scales[level], solid.scales[level], solid.scales[level]};
}

/// A level takes the node's place; outside the scene nobody shows it who does not know why.
void NodeWriter::add_levels(Json& node, const PlacedSolid& placed, const SolidMeshes& solid, const Json& where) {
  Json ids = Json::array();
  const std::string name = engine_name(options_.engine, placed.name);
  for (std::size_t level = 1; level < solid.meshes.size(); ++level) {
    Json coarser = {{"name", level_name(options_.engine, name, level, solid.meshes.size())},
                    {"mesh", solid.meshes[level]}};
    coarser.update(where);
    scale(coarser, solid, level);
    ids.push_back(document_.add("nodes", std::move(coarser)));
  }
  if (ids.empty()) return;
  if (options_.engine == Engine::blender) {
    beside_.resize(std::max(beside_.size(), ids.size()), Json::array());
    for (std::size_t level = 0; level < ids.size(); ++level) beside_[level].push_back(ids[level]);
    return;
  }
  document_.use_extension("MSFT_lod");
  node["extensions"]["MSFT_lod"] = {{"ids", std::move(ids)}};
  node["extras"]["MSFT_screencoverage"] = screen_coverage(solid.meshes.size());
}

/// Children that importers take for shapes to collide with.
void NodeWriter::add_shapes(Json& node, const SolidMeshes& solid, std::span<const int> hulls) {
  const auto add = [&](const std::string& name, int mesh) {
    node["children"].push_back(document_.add("nodes", {{"name", name}, {"mesh", mesh}}));
  };
  const std::string name = node["name"];
  for (std::size_t part = 0; part < hulls.size(); ++part)
    add(hull_name(options_.engine, name, part, hulls.size()), hulls[part]);
  if (solid.triangles >= 0) add(triangles_name(options_.engine, name), solid.triangles);
}

int NodeWriter::add(const PlacedSolid& placed, const SolidMeshes& solid, const OwnMeshes& own) {
  const std::string name = engine_name(options_.engine, placed.name);
  Json node = {{"name", level_name(options_.engine, name, 0, solid.meshes.size())},
               {"mesh", own.mesh < 0 ? solid.meshes.front() : own.mesh}};
  const Json place = where(placed, solid.pivot);
  for (const Instance* instance : placed.instances) {
    const double x = place_of(instance->pose, solid.pivot).x;
    left_ = std::min(left_, x - solid.reach), right_ = std::max(right_, x + solid.reach);
  }
  node.update(place);
  scale(node, solid, 0);
  add_levels(node, placed, solid, place);
  if (placed.instances.size() > 1) {
    for (const Instance* instance : placed.instances) node["extras"]["instances"].push_back(instance->name);
  }
  add_shapes(node, solid, own.hulls.empty() ? solid.hulls : own.hulls);
  return document_.add("nodes", std::move(node));
}

/// The members that become nodes, in the order of first instances.
std::vector<PlacedSolid> placed_solids(const Scene& scene, bool together) {
  std::vector<PlacedSolid> all;
  std::map<int, std::size_t> of_solid;
  for (const Instance& instance : scene.instances) {
    const auto [known, is_new] = of_solid.try_emplace(instance.solid, all.size());
    if (is_new || !together) {
      all.push_back({instance.name, {&instance}});
      continue;
    }
    all[known->second].instances.push_back(&instance);
  }
  return all;
}

/// A group's node comes after all of its children.
Json added_groups(GltfDocument& document, const PieceGroup& group, const std::vector<int>& nodes, Engine engine) {
  Json children = Json::array();
  for (const PieceGroup::Member& member : group.members) {
    if (member.group) {
      Json inside = {{"name", engine_name(engine, member.group->name)}};
      inside["children"] = added_groups(document, *member.group, nodes, engine);
      children.push_back(document.add("nodes", std::move(inside)));
    } else {
      children.push_back(nodes[member.item]);
    }
  }
  return children;
}

int add_camera(GltfDocument& document, const View& view) {
  const ViewFrame frame = view_frame(view);
  Json lens = {{"yfov", view.vertical_field}, {"znear", frame.distance / 100}, {"zfar", frame.distance * 100}};
  Json camera = {{"name", "view"}, {"type", "perspective"}, {"perspective", std::move(lens)}};
  Json node = {{"name", "view"}, {"camera", document.add("cameras", std::move(camera))}};
  node["rotation"] = xyzw(unit(glm::quat_cast(glm::dmat3(frame.right, frame.up, frame.back))));
  node["translation"] = {view.eye.x, view.eye.y, view.eye.z};
  return document.add("nodes", std::move(node));
}

}  // namespace

void add_nodes(GltfDocument& document, const Scene& scene, std::span<const SolidMeshes> solids,
               std::span<const OwnMeshes> own, const ExportOptions& options) {
  NodeWriter writer(document, options);
  std::vector<int> nodes;
  std::vector<PiecePath> paths;
  for (const PlacedSolid& placed : placed_solids(scene, options.instances)) {
    const auto solid = static_cast<std::size_t>(placed.instances.front()->solid);
    if (solids[solid].meshes.empty()) continue;
    const auto first = static_cast<std::size_t>(placed.instances.front() - scene.instances.data());
    nodes.push_back(writer.add(placed, solids[solid], own[first]));
    paths.push_back({scene.solids[solid].origin.entry, scene.solids[solid].origin.variant});
  }
  Json roots = added_groups(document, grouped(paths), nodes, options.engine);
  for (const Json& level : writer.added_levels_beside()) roots.push_back(level);
  roots.push_back(add_camera(document, scene.view));
  document.scene()["nodes"] = std::move(roots);
}

}  // namespace pomona::gltf
