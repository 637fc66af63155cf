#include "render/export/gltf.h"

#include <tiny_gltf.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <tuple>

#include <glm/gtc/quaternion.hpp>

#include "generator/base/error.h"
#include "generator/mesh/box.h"
#include "generator/piece/piece_facts.h"
#include "render/export/pbr_look.h"
#include "render/image/png.h"
#include "render/picture/view_frame.h"

namespace pomona {
namespace {

/// One vertex as it lies in the file; 36 bytes, every attribute on a multiple of four as glTF demands.
struct GlbVertex {
  glm::vec3 position;
  glm::vec3 normal;
  std::array<std::uint16_t, 4> color_or_uv;  ///< 16-bit RGBA; or two floats, where there is a texture
  std::uint16_t part;
  std::uint16_t padding = 0;
};
static_assert(sizeof(GlbVertex) == 36);

std::uint16_t to_16_bits(float share) { return static_cast<std::uint16_t>(std::lround(share * 65535.0f)); }

std::array<std::uint16_t, 4> color_or_uv(const StyledMesh& mesh, std::size_t v) {
  if (!mesh.uv.empty()) return std::bit_cast<std::array<std::uint16_t, 4>>(mesh.uv[v]);
  const Color& c = mesh.color[v];
  return {to_16_bits(c.r), to_16_bits(c.g), to_16_bits(c.b), 65535};
}

std::vector<GlbVertex> vertices_of(const StyledMesh& mesh) {
  std::vector<GlbVertex> vertices(mesh.position.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    vertices[v] = {mesh.position[v], mesh.normal[v], color_or_uv(mesh, v), static_cast<std::uint16_t>(mesh.part[v])};
  return vertices;
}

/// Builds the model part by part; every add_... returns the index of what it added.
class GlbModel {
 public:
  GlbModel() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Pomona";
    model_.buffers.resize(1);
    model_.scenes.resize(1);
    model_.defaultScene = 0;
  }

  /// `texture`: of add_texture(), or nothing where vertices have colours.
  int add_mesh(const Solid& solid, const StyledMesh& styled, std::optional<int> texture = {});
  int add_texture(const Solid& solid, const Image& picture);
  /// `meshes`: of the solid and of its coarser levels.
  void add_instance(const Instance& instance, const std::vector<int>& meshes);
  void add_camera(const View& view);
  void set_provenance(const std::string& text);
  std::string bytes();

 private:
  int add_view(const void* data, std::size_t size, std::size_t stride, int target);
  int add_attribute(int view, std::size_t offset, std::size_t count, int component, int type);
  int smooth_sampler();
  int add_vertices(const StyledMesh& styled, tinygltf::Primitive& primitive);
  int add_indices(const std::vector<glm::uvec3>& triangle, std::size_t vertices);
  int add_material(const Solid& solid, const PbrLook& look, std::optional<int> texture);
  void add_extensions(tinygltf::Material& material, const PbrLook& look);
  int add_node(tinygltf::Node node);
  void add_root(tinygltf::Node node);
  void use_extension(const std::string& name);

  tinygltf::Model model_;
  std::map<std::tuple<bool, float, PbrLook, std::optional<int>>, int> materials_;
};

int GlbModel::add_view(const void* data, std::size_t size, std::size_t stride, int target) {
  // Buffers grow in multiples of four bytes, so that every view begins on one.
  std::vector<unsigned char>& buffer = model_.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = buffer.size();
  view.byteLength = size;
  view.byteStride = stride;
  view.target = target;
  const auto* first = static_cast<const unsigned char*>(data);
  buffer.insert(buffer.end(), first, first + size);
  buffer.resize((buffer.size() + 3) / 4 * 4);
  model_.bufferViews.push_back(view);
  return static_cast<int>(model_.bufferViews.size()) - 1;
}

int GlbModel::add_attribute(int view, std::size_t offset, std::size_t count, int component, int type) {
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.byteOffset = offset;
  accessor.count = count;
  accessor.componentType = component;
  accessor.type = type;
  model_.accessors.push_back(accessor);
  return static_cast<int>(model_.accessors.size()) - 1;
}

int GlbModel::add_indices(const std::vector<glm::uvec3>& triangle, std::size_t vertices) {
  const std::size_t count = 3 * triangle.size();
  const auto* indices = &triangle.front().x;
  if (vertices > 65535) {
    const int view = add_view(indices, 4 * count, 0, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return add_attribute(view, 0, count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
  }
  std::vector<std::uint16_t> narrow(count);
  for (std::size_t t = 0; t < triangle.size(); ++t)
    for (int k = 0; k < 3; ++k) narrow[3 * t + k] = static_cast<std::uint16_t>(triangle[t][k]);
  const int view = add_view(narrow.data(), 2 * count, 0, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  return add_attribute(view, 0, count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR);
}

/// Open meshes show both sides.
tinygltf::Material material_of(const Solid& solid, const PbrLook& look) {
  tinygltf::Material material;
  material.doubleSided = !solid.closed;
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = look.roughness;
  if (solid.opacity < 1) {
    material.alphaMode = "BLEND";
    material.pbrMetallicRoughness.baseColorFactor = {1, 1, 1, static_cast<double>(solid.opacity)};
  }
  return material;
}

tinygltf::Value value_of(const std::array<double, 3>& color) {
  tinygltf::Value::Array numbers;
  for (const double channel : color) numbers.emplace_back(channel);
  return tinygltf::Value(numbers);
}

void GlbModel::use_extension(const std::string& name) {
  std::vector<std::string>& used = model_.extensionsUsed;
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

/// What glTF itself cannot say. No viewer needs to understand it.
void GlbModel::add_extensions(tinygltf::Material& material, const PbrLook& look) {
  const auto add = [&](const std::string& name, const tinygltf::Value::Object& factors) {
    material.extensions[name] = tinygltf::Value(factors);
    use_extension(name);
  };
  if (look.specular < 1) add("KHR_materials_specular", {{"specularFactor", tinygltf::Value(look.specular)}});
  if (look.clearcoat > 0) {
    add("KHR_materials_clearcoat", {{"clearcoatFactor", tinygltf::Value(look.clearcoat)},
                                    {"clearcoatRoughnessFactor", tinygltf::Value(look.clearcoat_roughness)}});
  }
  if (look.sheen_roughness > 0) {
    add("KHR_materials_sheen",
        {{"sheenColorFactor", value_of(look.sheen)}, {"sheenRoughnessFactor", tinygltf::Value(look.sheen_roughness)}});
  }
  if (look.transmission > 0) {
    add("KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", tinygltf::Value(look.transmission)},
                                               {"diffuseTransmissionColorFactor", value_of(look.transmission_color)}});
  }
}

/// Shared by all that looks alike. White where vertices have colours, so that those speak.
int GlbModel::add_material(const Solid& solid, const PbrLook& look, std::optional<int> texture) {
  const auto [entry, is_new] =
      materials_.try_emplace({solid.closed, solid.opacity, look, texture}, static_cast<int>(model_.materials.size()));
  if (!is_new) return entry->second;
  tinygltf::Material material = material_of(solid, look);
  material.name = solid.opacity < 1 ? "see-through" : solid.closed ? "fruit" : "open fruit";
  if (texture) {
    material.name = solid.name;
    material.pbrMetallicRoughness.baseColorTexture.index = *texture;
  }
  add_extensions(material, look);
  model_.materials.push_back(material);
  return entry->second;
}

/// Trilinear; one for all textures. Charts lie apart, and nothing repeats.
int GlbModel::smooth_sampler() {
  if (model_.samplers.empty()) {
    tinygltf::Sampler sampler;
    sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    model_.samplers.push_back(sampler);
  }
  return 0;
}

int GlbModel::add_texture(const Solid& solid, const Image& picture) {
  // The PNG goes into the buffer: handed over as pixels, tinygltf would write it as a data URI.
  const std::string png = write_png(picture, PngPacking::fast);
  tinygltf::Image image;
  image.name = solid.name;
  image.mimeType = "image/png";
  image.bufferView = add_view(png.data(), png.size(), 0, 0);
  tinygltf::Texture source;
  source.source = static_cast<int>(model_.images.size());
  source.sampler = smooth_sampler();
  model_.images.push_back(image);
  model_.textures.push_back(source);
  return static_cast<int>(model_.textures.size()) - 1;
}

tinygltf::Value extras_of(const Solid& solid) {
  // The names that the vertices' part numbers stand for.
  tinygltf::Value::Array parts;
  for (const std::string& part : solid.part_names) parts.emplace_back(part);
  tinygltf::Value::Object extras;
  extras["parts"] = tinygltf::Value(parts);

  // What a game or a simulation asks of a body, and how the piece came to be.
  const PieceFacts facts = facts_of(solid);
  const auto point = [](const glm::dvec3& p) {
    return tinygltf::Value(tinygltf::Value::Array{tinygltf::Value(p.x), tinygltf::Value(p.y), tinygltf::Value(p.z)});
  };
  extras["volume"] = tinygltf::Value(facts.volume);
  extras["density"] = tinygltf::Value(facts.density);
  extras["mass"] = tinygltf::Value(facts.mass);
  extras["center"] = point(facts.center);
  extras["inertia"] = tinygltf::Value(
      tinygltf::Value::Array{point(facts.inertia[0]), point(facts.inertia[1]), point(facts.inertia[2])});
  extras["low"] = point(facts.low);
  extras["high"] = point(facts.high);
  extras["triangles"] = tinygltf::Value(static_cast<int>(facts.triangles));
  extras["seed"] = tinygltf::Value(static_cast<double>(solid.seed));
  extras["knife"] = tinygltf::Value(solid.knife);
  extras["closed"] = tinygltf::Value(solid.closed);
  extras["crumb"] = tinygltf::Value(solid.crumb);
  return tinygltf::Value(extras);
}

/// Lays the vertices down once, and the attributes over them.
int GlbModel::add_vertices(const StyledMesh& styled, tinygltf::Primitive& primitive) {
  const std::vector<GlbVertex> vertices = vertices_of(styled);
  const std::size_t count = vertices.size();
  const int view =
      add_view(vertices.data(), count * sizeof(GlbVertex), sizeof(GlbVertex), TINYGLTF_TARGET_ARRAY_BUFFER);
  const auto attribute = [&](const char* name, std::size_t offset, int component, int type) {
    return primitive.attributes[name] = add_attribute(view, offset, count, component, type);
  };
  constexpr int floats = TINYGLTF_COMPONENT_TYPE_FLOAT, shorts = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  const int position = attribute("POSITION", offsetof(GlbVertex, position), floats, TINYGLTF_TYPE_VEC3);
  attribute("NORMAL", offsetof(GlbVertex, normal), floats, TINYGLTF_TYPE_VEC3);
  attribute("_PART", offsetof(GlbVertex, part), shorts, TINYGLTF_TYPE_SCALAR);
  if (styled.uv.empty()) {
    const int color = attribute("COLOR_0", offsetof(GlbVertex, color_or_uv), shorts, TINYGLTF_TYPE_VEC4);
    model_.accessors[color].normalized = true;
  } else {
    attribute("TEXCOORD_0", offsetof(GlbVertex, color_or_uv), floats, TINYGLTF_TYPE_VEC2);
  }
  return position;
}

int GlbModel::add_mesh(const Solid& solid, const StyledMesh& styled, std::optional<int> texture) {
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  const int position = add_vertices(styled, primitive);

  // glTF wants the bounds of positions.
  const auto [low, high] = box_around(styled.position);
  model_.accessors[position].minValues = {low.x, low.y, low.z};
  model_.accessors[position].maxValues = {high.x, high.y, high.z};

  // One primitive for each look, all of the same vertices.
  tinygltf::Mesh mesh;
  mesh.name = solid.name;
  for (const LookGroup& group : groups_by_look(solid, styled)) {
    primitive.indices = add_indices(group.triangle, styled.position.size());
    primitive.material = add_material(solid, group.look, texture);
    mesh.primitives.push_back(primitive);
  }
  mesh.extras = extras_of(solid);
  model_.meshes.push_back(mesh);
  return static_cast<int>(model_.meshes.size()) - 1;
}

int GlbModel::add_node(tinygltf::Node node) {
  model_.nodes.push_back(std::move(node));
  return static_cast<int>(model_.nodes.size()) - 1;
}

void GlbModel::add_root(tinygltf::Node node) { model_.scenes[0].nodes.push_back(add_node(std::move(node))); }

std::vector<double> xyzw(const glm::dquat& rotation) {
  const double length = std::sqrt(glm::dot(rotation, rotation));
  if (!(length > 0)) return {0, 0, 0, 1};
  return {rotation.x / length, rotation.y / length, rotation.z / length, rotation.w / length};
}

/// The share of the screen down to which each level serves: a tenth for the solid, and half of it for each coarser
/// level; the coarsest serves down to nothing.
tinygltf::Value screen_coverage(std::size_t levels) {
  tinygltf::Value::Array shares;
  double share = 0.1;
  for (std::size_t level = 0; level + 1 < levels; ++level, share /= 2) shares.emplace_back(share);
  shares.emplace_back(0.0);
  return tinygltf::Value(shares);
}

void GlbModel::add_instance(const Instance& instance, const std::vector<int>& meshes) {
  tinygltf::Node node;
  node.name = instance.name;
  node.mesh = meshes.front();
  const glm::dvec3& t = instance.pose.translation;
  if (instance.pose.rotation != glm::dquat(1, 0, 0, 0)) node.rotation = xyzw(instance.pose.rotation);
  if (t != glm::dvec3(0)) node.translation = {t.x, t.y, t.z};

  // A level takes the node's place, so it has its pose; outside the scene nobody shows it who does not know why.
  tinygltf::Value::Array ids;
  for (std::size_t level = 1; level < meshes.size(); ++level) {
    tinygltf::Node coarser = node;
    coarser.name = instance.name + "_LOD" + std::to_string(level);
    coarser.mesh = meshes[level];
    ids.emplace_back(add_node(std::move(coarser)));
  }
  if (!ids.empty()) {
    use_extension("MSFT_lod");
    node.extensions["MSFT_lod"] = tinygltf::Value(tinygltf::Value::Object{{"ids", tinygltf::Value(ids)}});
    node.extras = tinygltf::Value(tinygltf::Value::Object{{"MSFT_screencoverage", screen_coverage(meshes.size())}});
  }
  add_root(std::move(node));
}

void GlbModel::add_camera(const View& view) {
  const ViewFrame frame = view_frame(view);
  tinygltf::Camera camera;
  camera.name = "view";
  camera.type = "perspective";
  camera.perspective.yfov = view.vertical_field;
  camera.perspective.znear = frame.distance / 100;
  camera.perspective.zfar = frame.distance * 100;
  model_.cameras.push_back(camera);

  tinygltf::Node node;
  node.name = "view";
  node.camera = 0;
  node.rotation = xyzw(glm::quat_cast(glm::dmat3(frame.right, frame.up, frame.back)));
  node.translation = {view.eye.x, view.eye.y, view.eye.z};
  add_root(std::move(node));
}

void GlbModel::set_provenance(const std::string& text) {
  model_.scenes[0].name = "scene";
  if (!text.empty())
    model_.scenes[0].extras = tinygltf::Value(tinygltf::Value::Object{{"provenance", tinygltf::Value(text)}});
}

std::string GlbModel::bytes() {
  if (model_.buffers[0].data.empty()) model_.buffers.clear();
  std::ostringstream stream;
  tinygltf::TinyGLTF writer;
  const bool written = writer.WriteGltfSceneToStream(&model_, stream, /*prettyPrint=*/false, /*writeBinary=*/true);
  if (!written) throw Error(ExitStatus::bug, "the glTF writer refused the scene");
  return std::move(stream).str();
}

/// Per solid: its mesh, then those of its coarser levels; none of a solid without triangles, which glTF cannot hold.
using MeshesOfSolids = std::vector<std::vector<int>>;

/// Nodes, camera and what made it, around meshes that are there already.
std::string finished(GlbModel& model, const Scene& scene, const MeshesOfSolids& meshes_of, const std::string& text) {
  for (const Instance& instance : scene.instances) {
    const std::vector<int>& meshes = meshes_of.at(instance.solid);
    if (!meshes.empty()) model.add_instance(instance, meshes);
  }
  model.add_camera(scene.view);
  model.set_provenance(text);
  return model.bytes();
}

void check_parts(const Solid& solid) {
  if (solid.part_names.size() > 65536) throw Error(ExitStatus::bad_data, solid.name + ": too many parts for glTF");
}

void add_styled(GlbModel& model, const Solid& solid, const StyledMesh& styled, std::vector<int>& meshes) {
  check_parts(solid);
  if (!styled.triangle.empty()) meshes.push_back(model.add_mesh(solid, styled));
}

void add_textured(GlbModel& model, const BakedSolid& baked, std::vector<int>& meshes) {
  check_parts(baked.solid);
  const StyledMesh mesh = textured_mesh(baked);
  if (mesh.triangle.empty()) return;
  meshes.push_back(model.add_mesh(baked.solid, mesh, model.add_texture(baked.solid, baked.texture)));
}

}  // namespace

std::string write_glb(const Scene& scene, const ExportOptions& options, std::span<const std::vector<Solid>> levels) {
  return write_glb(scene, styled_meshes(scene, options), options, levels);
}

std::string write_glb(const Scene& scene, std::span<const StyledMesh> styled, const ExportOptions& options,
                      std::span<const std::vector<Solid>> levels) {
  GlbModel model;
  MeshesOfSolids meshes(scene.solids.size());
  for (std::size_t i = 0; i < styled.size(); ++i) {
    add_styled(model, scene.solids[i], styled[i], meshes[i]);
    if (i >= levels.size()) continue;
    const std::vector<StyledMesh> coarser = styled_meshes(levels[i], options);
    for (std::size_t level = 0; level < coarser.size(); ++level)
      add_styled(model, levels[i][level], coarser[level], meshes[i]);
  }
  return finished(model, scene, meshes, options.provenance);
}

std::string write_glb(const Scene& scene, std::span<const BakedSolid> baked, const ExportOptions& options,
                      std::span<const std::vector<BakedSolid>> levels) {
  GlbModel model;
  MeshesOfSolids meshes(baked.size());
  for (std::size_t i = 0; i < baked.size(); ++i) {
    add_textured(model, baked[i], meshes[i]);
    if (i >= levels.size()) continue;
    for (const BakedSolid& coarser : levels[i]) add_textured(model, coarser, meshes[i]);
  }
  return finished(model, scene, meshes, options.provenance);
}

}  // namespace pomona
