#include "generator/surface/file/glb_file.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "generator/surface/file/glb_model.h"
#include "generator/surface/file/gltf_json.h"
#include "generator/surface/file/gltf_poses.h"
#include "generator/surface/file/gltf_primitive.h"

namespace pomona {

namespace {

constexpr int deepest_node = 64;
constexpr std::size_t max_nodes = 65536;
constexpr std::size_t max_names = 64;  // in messages

/// A node that shows a mesh.
struct ShownNode {
  int node = 0;
  glm::dmat4 to_scene{1};
  bool is_called_so = false;     ///< it, or a node above it without a mesh, has the wanted name
  bool shows_called_so = false;  ///< its mesh data have it
};

/// The nodes of the file's scene.
struct SceneNodes {
  std::vector<std::optional<glm::dmat4>> to_scene;  ///< for each node of the file; none outside the scene
  std::vector<ShownNode> shown;
  std::vector<std::string> names;  ///< of nodes that show a mesh, for messages
  std::size_t nodes_called_so = 0;
};

/// The scene's nodes, or all nodes without a parent.
std::vector<int> scene_roots(const tinygltf::Model& model, const std::string& file) {
  const int scene = std::max(model.defaultScene, 0);
  if (model.defaultScene >= 0 && static_cast<std::size_t>(scene) >= model.scenes.size())
    GltfPlace{file, "scene"}.refuse("there is no such scene");
  if (static_cast<std::size_t>(scene) < model.scenes.size()) return model.scenes[static_cast<std::size_t>(scene)].nodes;
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children)
      if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
        is_child[static_cast<std::size_t>(child)] = true;
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i)
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  return roots;
}

bool is_invisible(const tinygltf::Node& node) {
  const auto found = node.extensions.find(gltf_visibility);
  if (found == node.extensions.end() || !found->second.Has("visible")) return false;
  const tinygltf::Value& visible = found->second.Get("visible");
  return visible.IsBool() && !visible.Get<bool>();
}

/// Walks the scene from its roots. `object` is the wanted name, or empty.
class SceneWalk {
 public:
  SceneWalk(const tinygltf::Model& model, const std::string& file, const std::string& object)
      : model_(model), file_(file), object_(object) {}

  SceneNodes walk() {
    nodes_.to_scene.resize(model_.nodes.size());
    for (const int root : scene_roots(model_, file_)) visit(root, glm::dmat4(1), 0, false);
    return std::move(nodes_);
  }

 private:
  void visit(int index, const glm::dmat4& parent, int depth, bool is_wanted) {
    const GltfPlace place{file_, "node " + std::to_string(index)};
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size()) place.refuse("there is no such node");
    std::optional<glm::dmat4>& to_scene = nodes_.to_scene[static_cast<std::size_t>(index)];
    if (to_scene)
      place.refuse("is held twice: by two nodes, or within itself", "export it anew, with copies of the node");
    if (depth > deepest_node || ++visits_ > max_nodes) place.refuse("nodes nested too deep");
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    to_scene = parent * transform_of(node, place);
    if (is_invisible(node)) return;
    const bool called_so = !object_.empty() && node.name == object_;
    nodes_.nodes_called_so += called_so ? 1 : 0;
    if (node.mesh >= 0) {
      if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size()) place.refuse("there is no such mesh");
      const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
      if (nodes_.names.size() < max_names) nodes_.names.push_back(node.name.empty() ? mesh.name : node.name);
      nodes_.shown.push_back({index, *to_scene, called_so || is_wanted, mesh.name == object_});
    }
    // A wanted node without a mesh means all nodes below it.
    const bool all_below = is_wanted || (called_so && node.mesh < 0);
    for (const int child : node.children) visit(child, *to_scene, depth + 1, all_below);
  }

  const tinygltf::Model& model_;
  const std::string& file_;
  const std::string& object_;
  SceneNodes nodes_;
  std::size_t visits_ = 0;
};

/// The nodes to read, and what is to be told of them.
struct WantedNodes {
  std::vector<ShownNode> nodes;
  std::vector<std::string> notes;
};

/// The nodes with the wanted name; if there is none, the nodes whose mesh data have it.
WantedNodes wanted_nodes(const SceneNodes& scene, const std::string& file, const std::string& object) {
  if (object.empty()) return {scene.shown, {}};
  const bool by_node =
      std::any_of(scene.shown.begin(), scene.shown.end(), [](const ShownNode& s) { return s.is_called_so; });
  WantedNodes wanted;
  for (const ShownNode& s : scene.shown)
    if (by_node ? s.is_called_so : s.shows_called_so) wanted.nodes.push_back(s);
  if (wanted.nodes.empty())
    GltfPlace{file, "scene"}.refuse("has no object \"" + object + "\"", "it has: " + listed_names(scene.names));
  const std::size_t several = by_node ? scene.nodes_called_so : wanted.nodes.size();
  if (several > 1)
    wanted.notes.push_back(std::to_string(several) + " nodes " + (by_node ? "are called \"" : "show the mesh data \"") +
                           object.substr(0, 64) + "\": all of them are read");
  return wanted;
}

/// The meshes of all primitives of these nodes, at each instance; a skinned mesh as its joints place it.
std::vector<PlainMesh> node_meshes(const tinygltf::Model& model, const SceneNodes& scene,
                                   const std::vector<ShownNode>& nodes, const std::string& file) {
  std::vector<PlainMesh> parts;
  MeshRoom room;
  for (const ShownNode& shown : nodes) {
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(shown.node)];
    const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
    const GltfPlace place{file, "mesh \"" + mesh.name.substr(0, 64) + "\""};
    PrimitivePose pose;
    pose.morph_weights = node.weights.empty() ? mesh.weights : node.weights;
    if (node.skin >= 0) pose.joints = skin_joints(model, node.skin, scene.to_scene, place);
    for (const glm::dmat4& to_scene : instance_places(model, node, shown.to_scene, place)) {
      pose.to_scene = to_scene;
      for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        parts.push_back(
            primitive_mesh(model, mesh.primitives[i], pose, room, place.within("primitive " + std::to_string(i))));
        room.vertices -= parts.back().position.size();
        room.triangles -= parts.back().triangle.size();
      }
    }
  }
  return parts;
}

/// One mesh of all. Where some have colours, the others get grey.
PlainMesh joined(const std::vector<PlainMesh>& parts) {
  const bool has_color = std::any_of(parts.begin(), parts.end(), [](const PlainMesh& p) { return !p.color.empty(); });
  PlainMesh mesh;
  for (const PlainMesh& part : parts) {
    const auto first = static_cast<std::uint32_t>(mesh.position.size());
    mesh.position.insert(mesh.position.end(), part.position.begin(), part.position.end());
    mesh.color.insert(mesh.color.end(), part.color.begin(), part.color.end());
    if (has_color) mesh.color.resize(mesh.position.size(), Color(0.5f));
    for (const glm::uvec3& triangle : part.triangle) mesh.triangle.push_back(triangle + first);
  }
  return mesh;
}

}  // namespace

PlainMesh parse_glb(std::string_view bytes, const std::string& file, const std::string& object) {
  const tinygltf::Model model = glb_model(bytes, file);
  const SceneNodes scene = SceneWalk(model, file, object).walk();
  const WantedNodes wanted = wanted_nodes(scene, file, object);
  PlainMesh mesh = without_unused(joined(node_meshes(model, scene, wanted.nodes, file)));
  if (mesh.triangle.empty()) GltfPlace{file, "scene"}.refuse("holds no triangles", "export the mesh as polygons");
  mesh.notes = wanted.notes;
  return mesh;
}

}  // namespace pomona
