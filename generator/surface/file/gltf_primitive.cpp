#include "generator/surface/file/gltf_primitive.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "generator/surface/file/gltf_json.h"
#include "generator/surface/file/gltf_poses.h"

namespace pomona {

namespace {

constexpr double farthest = 1e9;  // in units of the file

bool has_quantization(const tinygltf::Model& model) {
  const auto lists = [](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), gltf_quantization) != names.end();
  };
  return lists(model.extensionsUsed) || lists(model.extensionsRequired);
}

std::vector<glm::dvec3> drawn_positions(const tinygltf::Model& model, int index, std::size_t room,
                                        const GltfPlace& of_mesh) {
  const GltfPlace place = of_mesh.within("POSITION");
  const tinygltf::Accessor& values = accessor_at(model, index, place);
  const bool is_quantized = has_quantization(model) && values.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (values.type != TINYGLTF_TYPE_VEC3 || (values.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT && !is_quantized))
    place.refuse("positions must be three floats", "export it without quantization");
  if (values.count > room) {
    // If the accessor is longer than its buffer, report that instead.
    if (!values.sparse.isSparse) accessor_bytes(model, index, place);
    of_mesh.refuse("more than 5 000 000 vertices", "simplify the mesh");
  }
  const AccessorTable table = accessor_table(model, index, place);
  std::vector<glm::dvec3> position;
  position.reserve(table.count);
  for (std::size_t i = 0; i < table.count; ++i) position.emplace_back(table.at(i, 0), table.at(i, 1), table.at(i, 2));
  return position;
}

void check_near(const std::vector<glm::dvec3>& position, const GltfPlace& place) {
  for (std::size_t i = 0; i < position.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (!(std::fabs(position[i][k]) <= farthest))
        place.within("vertex " + std::to_string(i)).refuse("its position is not finite or too far away");
}

/// COLOR_0 is linear; alpha is ignored.
std::vector<Color> vertex_colors(const tinygltf::Model& model, int index, std::size_t vertices,
                                 const GltfPlace& place) {
  const AccessorBytes values = accessor_bytes(model, index, place);
  const bool is_vector = values.type == TINYGLTF_TYPE_VEC3 || values.type == TINYGLTF_TYPE_VEC4;
  if (!is_vector || values.count != vertices) place.refuse("it needs one colour for each vertex");
  const bool is_byte_or_short = values.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                values.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  if (values.component != TINYGLTF_COMPONENT_TYPE_FLOAT && !(values.normalized && is_byte_or_short))
    place.refuse("colours must be floats or normalized", "export it without colours");
  std::vector<Color> colors(vertices, Color(0));
  for (std::size_t i = 0; i < vertices; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double channel = component_of(values, i, k).value_or(0.5);
      if (!std::isfinite(channel)) place.refuse("a colour is not finite");
      colors[i][static_cast<int>(k)] = channel >= 0 ? static_cast<float>(std::min(channel, 1.0)) : 0.0f;
    }
  }
  return colors;
}

bool is_unsigned(int component) {
  return component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// The vertices that are corners, in order: by indices, or, without, all of them.
std::vector<std::uint32_t> corners_of(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                      std::size_t vertices, std::size_t room, const GltfPlace& place) {
  std::optional<AccessorBytes> indices;
  if (primitive.indices >= 0) indices = accessor_bytes(model, primitive.indices, place.within("indices"));
  if (indices && (indices->type != TINYGLTF_TYPE_SCALAR || indices->normalized || !is_unsigned(indices->component)))
    place.within("indices").refuse("they must be whole numbers without a sign");

  // Refuse too many triangles before any is read.
  const std::size_t count = indices ? indices->count : vertices;
  const bool apart = primitive.mode == TINYGLTF_MODE_TRIANGLES;
  if (apart && count % 3 != 0) place.refuse(std::to_string(count) + " corners are no whole number of triangles");
  if ((apart ? count / 3 : count < 3 ? 0 : count - 2) > room)
    place.refuse("more than 2 000 000 triangles", "simplify the mesh");
  std::vector<std::uint32_t> corners;
  corners.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double vertex = indices ? *component_of(*indices, i, 0) : static_cast<double>(i);
    if (!(vertex < static_cast<double>(vertices))) {
      const std::size_t triangle = apart ? i / 3 : i < 2 ? 0 : i - 2;
      place.within("triangle " + std::to_string(triangle)).refuse("there is no such vertex");
    }
    corners.push_back(static_cast<std::uint32_t>(vertex));
  }
  return corners;
}

std::vector<glm::uvec3> triangles_of(const std::vector<std::uint32_t>& corners, int mode, bool mirrored) {
  const bool apart = mode == TINYGLTF_MODE_TRIANGLES, is_fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
  std::vector<glm::uvec3> triangles;
  for (std::size_t start = 0; start + 2 < corners.size(); start += apart ? 3 : 1) {
    glm::uvec3 triangle(corners[is_fan ? 0 : start], corners[start + 1], corners[start + 2]);
    const bool is_flat = triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x;
    if (is_flat && !apart) continue;
    // Swap two corners of mirrored triangles, and of every second triangle of a strip, so that fronts stay in front.
    const bool is_turned = !apart && !is_fan && start % 2 == 1;
    if (mirrored != is_turned) std::swap(triangle.y, triangle.z);
    triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace

PlainMesh primitive_mesh(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const PrimitivePose& pose,
                         const MeshRoom& room, const GltfPlace& place) {
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
      primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN)
    place.refuse("holds no triangles, but points or lines", "export it without them");
  const auto positions = primitive.attributes.find("POSITION");
  if (positions == primitive.attributes.end()) place.refuse("has no positions", "export it without compression");

  // Morph targets move the points first; joints place them in the scene by themselves.
  PlainMesh mesh;
  mesh.position = morphed(drawn_positions(model, positions->second, room.vertices, place), model, primitive,
                          pose.morph_weights, place);
  const bool on_skin = !pose.joints.empty() && primitive.attributes.contains("JOINTS_0");
  if (on_skin) {
    mesh.position = posed(mesh.position, model, primitive, pose.joints, place);
  } else {
    for (glm::dvec3& p : mesh.position) p = glm::dvec3(pose.to_scene * glm::dvec4(p, 1));
  }
  check_near(mesh.position, place);

  const auto colors = primitive.attributes.find("COLOR_0");
  if (colors != primitive.attributes.end())
    mesh.color = vertex_colors(model, colors->second, mesh.position.size(), place.within("COLOR_0"));
  const bool mirrored = glm::determinant(on_skin ? pose.joints.front() : pose.to_scene) < 0;
  mesh.triangle =
      triangles_of(corners_of(model, primitive, mesh.position.size(), room.triangles, place), primitive.mode, mirrored);
  return mesh;
}

}  // namespace pomona
