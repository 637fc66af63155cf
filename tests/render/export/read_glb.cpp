#include "tests/render/export/read_glb.h"

#include <tiny_gltf.h>
#include <cstring>
#include <stdexcept>

#include <glm/gtc/quaternion.hpp>

namespace pomona::named {
namespace {

/// Element `i` of an accessor, as `Value` values of type `Stored`.
template <typename Stored>
std::vector<Stored> element(const tinygltf::Model& model, int accessor_index, std::size_t i, std::size_t values) {
  const tinygltf::Accessor& accessor = model.accessors.at(accessor_index);
  const tinygltf::BufferView& view = model.bufferViews.at(accessor.bufferView);
  const std::size_t stride = accessor.ByteStride(view);
  std::vector<Stored> result(values);
  const std::size_t at = view.byteOffset + accessor.byteOffset + i * stride;
  std::memcpy(result.data(), &model.buffers.at(view.buffer).data.at(at), values * sizeof(Stored));
  return result;
}

glm::vec3 vec3_at(const tinygltf::Model& model, int accessor, std::size_t i) {
  const std::vector<float> v = element<float>(model, accessor, i, 3);
  return {v[0], v[1], v[2]};
}

void read_vertices(GlbMesh& mesh, const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  const int position = primitive.attributes.at("POSITION"), normal = primitive.attributes.at("NORMAL");
  const int part = primitive.attributes.at("_PART");
  const auto color = primitive.attributes.find("COLOR_0"), uv = primitive.attributes.find("TEXCOORD_0");
  for (std::size_t v = 0; v < model.accessors.at(position).count; ++v) {
    mesh.position.push_back(vec3_at(model, position, v));
    mesh.normal.push_back(vec3_at(model, normal, v));
    if (color != primitive.attributes.end()) {
      const std::vector<std::uint16_t> c = element<std::uint16_t>(model, color->second, v, 4);
      mesh.color.push_back(glm::vec3(c[0], c[1], c[2]) / 65535.0f);
    }
    if (uv != primitive.attributes.end()) {
      const std::vector<float> t = element<float>(model, uv->second, v, 2);
      mesh.uv.emplace_back(t[0], t[1]);
    }
    mesh.part.push_back(element<std::uint16_t>(model, part, v, 1)[0]);
  }
}

void read_triangles(GlbMesh& mesh, const tinygltf::Model& model, int indices) {
  const tinygltf::Accessor& accessor = model.accessors.at(indices);
  mesh.index_bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
  for (std::size_t i = 0; i < accessor.count; i += 3) {
    glm::uvec3 t;
    for (int k = 0; k < 3; ++k)
      t[k] = mesh.index_bytes == 2 ? element<std::uint16_t>(model, indices, i + k, 1)[0]
                                   : element<std::uint32_t>(model, indices, i + k, 1)[0];
    mesh.triangle.push_back(t);
  }
}

void read_texture(GlbMesh& mesh, const tinygltf::Model& model, int texture) {
  const tinygltf::Image& image = model.images.at(model.textures.at(texture).source);
  mesh.texture_side = image.width;
  for (std::size_t i = 0; i < image.image.size(); i += image.component)
    mesh.texture.emplace_back(image.image[i], image.image[i + 1], image.image[i + 2]);
}

GlbMesh mesh_from(const tinygltf::Model& model, const tinygltf::Mesh& source) {
  GlbMesh mesh;
  mesh.name = source.name;
  const tinygltf::Primitive& primitive = source.primitives.at(0);
  read_vertices(mesh, model, primitive);
  read_triangles(mesh, model, primitive.indices);
  const tinygltf::Material& material = model.materials.at(primitive.material);
  mesh.double_sided = material.doubleSided;
  mesh.alpha = material.pbrMetallicRoughness.baseColorFactor.at(3);
  if (material.pbrMetallicRoughness.baseColorTexture.index >= 0)
    read_texture(mesh, model, material.pbrMetallicRoughness.baseColorTexture.index);
  mesh.volume = source.extras.Get("volume").GetNumberAsDouble();
  const tinygltf::Value& parts = source.extras.Get("parts");
  for (std::size_t i = 0; i < parts.ArrayLen(); ++i)
    mesh.part_names.push_back(parts.Get(static_cast<int>(i)).Get<std::string>());
  return mesh;
}

GlbNode node_from(const tinygltf::Node& source) {
  GlbNode node{.name = source.name, .mesh = source.mesh, .camera = source.camera, .levels = {}, .screen_coverage = {}};
  if (const auto lod = source.extensions.find("MSFT_lod"); lod != source.extensions.end()) {
    const tinygltf::Value& ids = lod->second.Get("ids");
    for (int i = 0; i < static_cast<int>(ids.ArrayLen()); ++i) node.levels.push_back(ids.Get(i).GetNumberAsInt());
  }
  if (source.extras.Has("MSFT_screencoverage")) {
    const tinygltf::Value& shares = source.extras.Get("MSFT_screencoverage");
    for (int i = 0; i < static_cast<int>(shares.ArrayLen()); ++i)
      node.screen_coverage.push_back(shares.Get(i).GetNumberAsDouble());
  }
  if (!source.rotation.empty()) {
    const std::vector<double>& q = source.rotation;
    node.matrix = glm::mat4_cast(glm::dquat(q.at(3), q.at(0), q.at(1), q.at(2)));
  }
  for (std::size_t k = 0; k < source.translation.size(); ++k)
    node.matrix[3][static_cast<int>(k)] = source.translation[k];
  return node;
}

}  // namespace

Glb read_glb(const std::string& bytes) {
  tinygltf::Model model;
  tinygltf::TinyGLTF reader;
  std::string error, warning;
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  if (!reader.LoadBinaryFromMemory(&model, &error, &warning, data, static_cast<unsigned int>(bytes.size())) ||
      !warning.empty())
    throw std::runtime_error(error + warning);

  Glb glb;
  for (const tinygltf::Mesh& mesh : model.meshes) glb.meshes.push_back(mesh_from(model, mesh));
  for (const tinygltf::Node& node : model.nodes) glb.nodes.push_back(node_from(node));
  for (const int node : model.scenes.at(0).nodes) glb.nodes.at(node).is_in_scene = true;
  glb.extensions_used = model.extensionsUsed;
  glb.extensions_required = model.extensionsRequired;
  if (!model.cameras.empty()) glb.vertical_field = model.cameras[0].perspective.yfov;
  const tinygltf::Value& extras = model.scenes.at(0).extras;
  if (extras.Has("provenance")) glb.provenance = extras.Get("provenance").Get<std::string>();
  return glb;
}

}  // namespace pomona::named
