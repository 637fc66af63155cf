#include "render/export/gltf/vertex_buffers.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "generator/mesh/box.h"

namespace pomona::gltf {

namespace {

/// One vertex in the file: 36 bytes, every attribute at a multiple of four as glTF requires.
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

std::vector<GlbVertex> vertices_of(const StyledMesh& mesh, const glm::vec3& pivot) {
  std::vector<GlbVertex> vertices(mesh.position.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    vertices[v] = {mesh.position[v] - pivot, mesh.normal[v], color_or_uv(mesh, v),
                   static_cast<std::uint16_t>(mesh.part[v])};
  }
  return vertices;
}

/// The bounds of positions, which glTF requires.
template <typename Vertices, typename PositionOf>
void set_bounds(Json& accessor, const Vertices& vertices, PositionOf position_of) {
  Box<float> box;
  for (const auto& vertex : vertices) box.add(position_of(vertex));
  accessor["min"] = {box.low.x, box.low.y, box.low.z};
  accessor["max"] = {box.high.x, box.high.y, box.high.z};
}

}  // namespace

Json add_vertices(GltfDocument& document, const StyledMesh& mesh, const glm::vec3& pivot) {
  const std::vector<GlbVertex> vertices = vertices_of(mesh, pivot);
  const std::size_t bytes = vertices.size() * sizeof(GlbVertex);
  const int view = document.add_view(vertices.data(), bytes, Target::vertices, sizeof(GlbVertex));
  Json attributes;
  const auto attribute = [&](const char* name, std::size_t offset, Component component, const char* type) {
    const int accessor = document.add_accessor(view, offset, vertices.size(), component, type);
    attributes[name] = accessor;
    return accessor;
  };
  const int position = attribute("POSITION", offsetof(GlbVertex, position), Component::f32, "VEC3");
  set_bounds(document.at("accessors", position), vertices, [](const GlbVertex& v) { return v.position; });
  attribute("NORMAL", offsetof(GlbVertex, normal), Component::f32, "VEC3");
  attribute("_PART", offsetof(GlbVertex, part), Component::u16, "SCALAR");
  if (mesh.uv.empty()) {
    const int color = attribute("COLOR_0", offsetof(GlbVertex, color_or_uv), Component::u16, "VEC4");
    document.at("accessors", color)["normalized"] = true;
  } else {
    attribute("TEXCOORD_0", offsetof(GlbVertex, color_or_uv), Component::f32, "VEC2");
  }
  if (!mesh.tangent.empty()) {
    const std::size_t size = mesh.tangent.size() * sizeof(glm::vec4);
    const int tangent_view = document.add_view(mesh.tangent.data(), size, Target::vertices);
    attributes["TANGENT"] = document.add_accessor(tangent_view, 0, mesh.tangent.size(), Component::f32, "VEC4");
  }
  return attributes;
}

int add_triangles(GltfDocument& document, const std::vector<glm::uvec3>& triangle, std::size_t vertices) {
  const std::size_t count = 3 * triangle.size();
  if (vertices > 65535) {
    const int view = document.add_view(triangle.data(), 4 * count, Target::indices);
    return document.add_accessor(view, 0, count, Component::u32, "SCALAR");
  }
  std::vector<std::uint16_t> narrow(count);
  for (std::size_t t = 0; t < triangle.size(); ++t)
    for (int k = 0; k < 3; ++k) narrow[3 * t + k] = static_cast<std::uint16_t>(triangle[t][k]);
  const int view = document.add_view(narrow.data(), 2 * count, Target::indices);
  return document.add_accessor(view, 0, count, Component::u16, "SCALAR");
}

int add_positions(GltfDocument& document, const std::vector<glm::vec3>& position) {
  const int view = document.add_view(position.data(), position.size() * sizeof(glm::vec3), Target::vertices);
  const int accessor = document.add_accessor(view, 0, position.size(), Component::f32, "VEC3");
  set_bounds(document.at("accessors", accessor), position, [](const glm::vec3& p) { return p; });
  return accessor;
}

}  // namespace pomona::gltf
