#include "render/export/gltf/vertex_buffers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/mesh/box.h"
#include "render/export/gltf/meshopt.h"

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

/// Texture coordinates of 16 bits.
std::vector<std::array<std::uint16_t, 2>> places_of(const std::vector<glm::vec2>& uv) {
  std::vector<std::array<std::uint16_t, 2>> places;
  places.reserve(uv.size());
  for (const glm::vec2& at : uv) places.push_back({to_16_bits(at.x), to_16_bits(at.y)});
  return places;
}

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
  if (!mesh.look_place.empty()) {
    const std::vector<std::array<std::uint16_t, 2>> places = places_of(mesh.look_place);
    const int places_view = document.add_view(places.data(), 4 * places.size(), Target::vertices);
    const int place = document.add_accessor(places_view, 0, places.size(), Component::u16, "VEC2");
    document.at("accessors", place)["normalized"] = true;
    attributes["TEXCOORD_0"] = place;
  }
  if (!mesh.tangent.empty()) {
    const std::size_t size = mesh.tangent.size() * sizeof(glm::vec4);
    const int tangent_view = document.add_view(mesh.tangent.data(), size, Target::vertices);
    attributes["TANGENT"] = document.add_accessor(tangent_view, 0, mesh.tangent.size(), Component::f32, "VEC4");
  }
  return attributes;
}

double coded_step(const StyledMesh& mesh, const glm::vec3& pivot) {
  float largest = 0;
  for (const glm::vec3& p : mesh.position)
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(p[axis] - pivot[axis]));
  return largest > 0 ? static_cast<double>(largest) / 32767 : 1.0;
}

namespace {

template <typename Number>
using Four = std::array<Number, 4>;

std::int8_t to_8_bits(float share) { return static_cast<std::int8_t>(std::lround(127.0f * share)); }

/// 12 bits that count, the highest once more below: the largest number stays the largest.
std::uint16_t to_12_bits(float share) {
  const long step = std::lround(share * 4095.0f);
  return static_cast<std::uint16_t>((step << 4) | (step >> 8));
}

/// An array of an element for each vertex, and its accessor.
template <typename Element>
int add_coded(GltfDocument& document, const std::vector<Element>& elements, Component component, const char* type,
              bool is_normalized) {
  const std::string coded = coded_elements(elements.data(), elements.size(), sizeof(Element));
  const int view = document.add_coded_view(coded, "ATTRIBUTES", elements.size(), sizeof(Element), Target::vertices);
  const int accessor = document.add_accessor(view, 0, elements.size(), component, type);
  if (is_normalized) document.at("accessors", accessor)["normalized"] = true;
  return accessor;
}

}  // namespace

Json add_coded_vertices(GltfDocument& document, const StyledMesh& mesh, const glm::vec3& pivot) {
  document.require_extension("KHR_mesh_quantization");
  const double step = coded_step(mesh, pivot);
  const std::size_t count = mesh.position.size();
  std::vector<Four<std::int16_t>> position(count);
  std::vector<Four<std::int8_t>> normal(count), tangent(mesh.tangent.size());
  std::vector<std::array<std::uint16_t, 2>> part(count);
  std::vector<Four<std::uint16_t>> color(mesh.uv.empty() ? count : 0);
  Box<float> box;
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<int>(k);
      const double away = static_cast<double>(mesh.position[v][axis] - pivot[axis]);
      position[v][k] = static_cast<std::int16_t>(std::lround(away / step));
      normal[v][k] = to_8_bits(mesh.normal[v][axis]);
    }
    box.add({position[v][0], position[v][1], position[v][2]});
    part[v][0] = static_cast<std::uint16_t>(mesh.part[v]);
    if (mesh.uv.empty())
      color[v] = {to_12_bits(mesh.color[v].r), to_12_bits(mesh.color[v].g), to_12_bits(mesh.color[v].b), 65535};
  }
  for (std::size_t v = 0; v < tangent.size(); ++v)
    for (std::size_t k = 0; k < 4; ++k) tangent[v][k] = to_8_bits(mesh.tangent[v][static_cast<int>(k)]);

  Json attributes;
  const int at = add_coded(document, position, Component::i16, "VEC3", false);
  document.at("accessors", at)["min"] = {box.low.x, box.low.y, box.low.z};
  document.at("accessors", at)["max"] = {box.high.x, box.high.y, box.high.z};
  attributes["POSITION"] = at;
  attributes["NORMAL"] = add_coded(document, normal, Component::i8, "VEC3", true);
  attributes["_PART"] = add_coded(document, part, Component::u16, "SCALAR", false);
  if (mesh.uv.empty()) attributes["COLOR_0"] = add_coded(document, color, Component::u16, "VEC4", true);
  const std::vector<glm::vec2>& uv = mesh.uv.empty() ? mesh.look_place : mesh.uv;
  if (!uv.empty()) attributes["TEXCOORD_0"] = add_coded(document, places_of(uv), Component::u16, "VEC2", true);
  if (!tangent.empty()) attributes["TANGENT"] = add_coded(document, tangent, Component::i8, "VEC4", true);
  return attributes;
}

int add_coded_triangles(GltfDocument& document, const std::vector<glm::uvec3>& triangle, std::size_t vertices) {
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * triangle.size());
  for (const glm::uvec3& t : triangle) corners.insert(corners.end(), {t.x, t.y, t.z});
  const int view =
      document.add_coded_view(coded_triangles(corners, vertices), "TRIANGLES", corners.size(), 4, Target::indices);
  return document.add_accessor(view, 0, corners.size(), Component::u32, "SCALAR");
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
