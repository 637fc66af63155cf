#include "render/export/gltf.h"

#include <tiny_gltf.h>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <sstream>

#include <glm/gtc/quaternion.hpp>

#include "generator/base/error.h"
#include "generator/scene/piece_facts.h"
#include "render/picture/png.h"
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

  int add_mesh(const Solid& solid, const StyledMesh& styled, int material);
  int add_material(const Solid& solid);
  int add_textured_material(const Solid& solid, const Image& texture);
  void add_instance(const Instance& instance, int mesh);
  void add_camera(const View& view);
  void set_provenance(const std::string& text);
  std::string bytes();

 private:
  int add_view(const void* data, std::size_t size, std::size_t stride, int target);
  int add_attribute(int view, std::size_t offset, std::size_t count, int component, int type);
  int add_indices(const StyledMesh& styled);
  int smooth_sampler();
  void add_root(tinygltf::Node node);

  tinygltf::Model model_;
  std::map<std::pair<bool, float>, int> materials_;
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

int GlbModel::add_indices(const StyledMesh& styled) {
  const std::size_t count = 3 * styled.triangle.size();
  const auto* indices = &styled.triangle.front().x;
  if (styled.position.size() > 65535) {
    const int view = add_view(indices, 4 * count, 0, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return add_attribute(view, 0, count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
  }
  std::vector<std::uint16_t> narrow(count);
  for (std::size_t t = 0; t < styled.triangle.size(); ++t)
    for (int k = 0; k < 3; ++k) narrow[3 * t + k] = static_cast<std::uint16_t>(styled.triangle[t][k]);
  const int view = add_view(narrow.data(), 2 * count, 0, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  return add_attribute(view, 0, count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR);
}

/// Dull like flesh. Open meshes show both sides.
tinygltf::Material material_of(const Solid& solid) {
  tinygltf::Material material;
  material.doubleSided = !solid.closed;
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.6;
  if (solid.opacity < 1) {
    material.alphaMode = "BLEND";
    material.pbrMetallicRoughness.baseColorFactor = {1, 1, 1, static_cast<double>(solid.opacity)};
  }
  return material;
}

/// White, so that the vertex colours speak; shared by all solids that look alike.
int GlbModel::add_material(const Solid& solid) {
  const auto [entry, is_new] =
      materials_.try_emplace({solid.closed, solid.opacity}, static_cast<int>(model_.materials.size()));
  if (is_new) {
    model_.materials.push_back(material_of(solid));
    model_.materials.back().name = solid.opacity < 1 ? "see-through" : solid.closed ? "fruit" : "open fruit";
  }
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

int GlbModel::add_textured_material(const Solid& solid, const Image& texture) {
  // The PNG goes into the buffer: handed over as pixels, tinygltf would write it as a data URI.
  const std::string png = write_png(texture);
  tinygltf::Image image;
  image.name = solid.name;
  image.mimeType = "image/png";
  image.bufferView = add_view(png.data(), png.size(), 0, 0);
  tinygltf::Texture source;
  source.source = static_cast<int>(model_.images.size());
  source.sampler = smooth_sampler();
  model_.images.push_back(image);

  tinygltf::Material material = material_of(solid);
  material.name = solid.name;
  material.pbrMetallicRoughness.baseColorTexture.index = static_cast<int>(model_.textures.size());
  model_.textures.push_back(source);
  model_.materials.push_back(material);
  return static_cast<int>(model_.materials.size()) - 1;
}

tinygltf::Value extras_of(const Solid& solid) {
  tinygltf::Value::Array parts;
  for (const std::string& part : solid.part_names) parts.emplace_back(part);
  tinygltf::Value::Object extras;
  extras["parts"] = tinygltf::Value(parts);
  const PieceFacts facts = facts_of(solid);
  const auto point = [](const glm::dvec3& p) {
    return tinygltf::Value(tinygltf::Value::Array{tinygltf::Value(p.x), tinygltf::Value(p.y), tinygltf::Value(p.z)});
  };
  extras["volume"] = tinygltf::Value(facts.volume);
  extras["density"] = tinygltf::Value(solid.density);
  extras["mass"] = tinygltf::Value(facts.mass);
  extras["center"] = point(facts.center);
  extras["low"] = point(facts.low);
  extras["high"] = point(facts.high);
  extras["triangles"] = tinygltf::Value(static_cast<int>(facts.triangles));
  extras["seed"] = tinygltf::Value(static_cast<double>(solid.seed));
  extras["knife"] = tinygltf::Value(solid.knife);
  extras["closed"] = tinygltf::Value(solid.closed);
  extras["crumb"] = tinygltf::Value(solid.crumb);
  return tinygltf::Value(extras);
}

int GlbModel::add_mesh(const Solid& solid, const StyledMesh& styled, int material) {
  // Lay the vertices down once, and the attributes over them.
  const std::vector<GlbVertex> vertices = vertices_of(styled);
  const std::size_t count = vertices.size();
  const int view =
      add_view(vertices.data(), count * sizeof(GlbVertex), sizeof(GlbVertex), TINYGLTF_TARGET_ARRAY_BUFFER);
  tinygltf::Primitive primitive;
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

  // glTF wants the bounds of positions.
  glm::vec3 low = styled.position.front(), high = low;
  for (const glm::vec3& p : styled.position) low = glm::min(low, p), high = glm::max(high, p);
  model_.accessors[position].minValues = {low.x, low.y, low.z};
  model_.accessors[position].maxValues = {high.x, high.y, high.z};

  primitive.indices = add_indices(styled);
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = material;
  tinygltf::Mesh mesh;
  mesh.name = solid.name;
  mesh.primitives.push_back(primitive);
  mesh.extras = extras_of(solid);
  model_.meshes.push_back(mesh);
  return static_cast<int>(model_.meshes.size()) - 1;
}

void GlbModel::add_root(tinygltf::Node node) {
  model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()));
  model_.nodes.push_back(std::move(node));
}

std::vector<double> xyzw(const glm::dquat& rotation) {
  const double length = std::sqrt(glm::dot(rotation, rotation));
  if (!(length > 0)) return {0, 0, 0, 1};
  return {rotation.x / length, rotation.y / length, rotation.z / length, rotation.w / length};
}

void GlbModel::add_instance(const Instance& instance, int mesh) {
  tinygltf::Node node;
  node.name = instance.name;
  node.mesh = mesh;
  const glm::dvec3& t = instance.pose.translation;
  if (instance.pose.rotation != glm::dquat(1, 0, 0, 0)) node.rotation = xyzw(instance.pose.rotation);
  if (t != glm::dvec3(0)) node.translation = {t.x, t.y, t.z};
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

/// Nodes, camera and what made it, around meshes that are there already (-1: a solid without triangles, which
/// glTF cannot hold).
std::string finished(GlbModel& model, const Scene& scene, const std::vector<int>& mesh_of, const std::string& text) {
  for (const Instance& instance : scene.instances) {
    const int mesh = mesh_of.at(instance.solid);
    if (mesh >= 0) model.add_instance(instance, mesh);
  }
  model.add_camera(scene.view);
  model.set_provenance(text);
  return model.bytes();
}

void check_parts(const Solid& solid) {
  if (solid.part_names.size() > 65536) throw Error(ExitStatus::bad_data, solid.name + ": too many parts for glTF");
}

}  // namespace

std::string write_glb(const Scene& scene, const ExportOptions& options) {
  const std::vector<StyledMesh> styled = styled_meshes(scene, options);
  GlbModel model;
  std::vector<int> mesh_of(styled.size(), -1);
  for (std::size_t i = 0; i < styled.size(); ++i) {
    const Solid& solid = scene.solids[i];
    check_parts(solid);
    if (!styled[i].triangle.empty()) mesh_of[i] = model.add_mesh(solid, styled[i], model.add_material(solid));
  }
  return finished(model, scene, mesh_of, options.provenance);
}

std::string write_glb(const Scene& scene, std::span<const BakedSolid> baked, const ExportOptions& options) {
  GlbModel model;
  std::vector<int> mesh_of(baked.size(), -1);
  for (std::size_t i = 0; i < baked.size(); ++i) {
    const Solid& solid = baked[i].solid;
    check_parts(solid);
    const StyledMesh mesh = textured_mesh(baked[i]);
    if (mesh.triangle.empty()) continue;
    mesh_of[i] = model.add_mesh(solid, mesh, model.add_textured_material(solid, baked[i].texture));
  }
  return finished(model, scene, mesh_of, options.provenance);
}

}  // namespace pomona
