#include "render/export/ply.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <glm/gtc/quaternion.hpp>

#include "generator/base/error.h"
#include "generator/base/utf8.h"
#include "generator/surface/file/one_line.h"

namespace pomona {
namespace {

/// Appends a value's bytes; x86-64 is little-endian, as the header says the file is.
template <typename Value>
void append(std::string& bytes, const Value& value) {
  char raw[sizeof(Value)];
  std::memcpy(raw, &value, sizeof(Value));
  bytes.append(raw, sizeof(Value));
}

/// The part names of all solids in one list, and their indices for each solid.
struct Parts {
  std::vector<std::string> names;
  std::vector<std::vector<std::int32_t>> of_solid;
};

Parts parts_of(const Scene& scene) {
  Parts parts;
  for (const Solid& solid : scene.solids) {
    std::vector<std::int32_t>& own = parts.of_solid.emplace_back();
    for (const std::string& name : solid.look->part_names) {
      const auto found = std::find(parts.names.begin(), parts.names.end(), name);
      own.push_back(static_cast<std::int32_t>(found - parts.names.begin()));
      if (found == parts.names.end()) parts.names.push_back(name);
    }
  }
  return parts;
}

std::string header_of(const Scene& scene, const Parts& parts, std::size_t vertices, std::size_t faces) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment made by Pomona\n";
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    text += "comment piece " + std::to_string(i) + " " + one_line(as_utf8(scene.instances[i].name)) + "\n";
  for (std::size_t i = 0; i < parts.names.size(); ++i)
    text += "comment part " + std::to_string(i) + " " + one_line(parts.names[i]) + "\n";
  text += "element vertex " + std::to_string(vertices) +
          "\nproperty float x\nproperty float y\nproperty float z"
          "\nproperty float nx\nproperty float ny\nproperty float nz"
          "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty int part"
          "\nelement face " +
          std::to_string(faces) +
          "\nproperty list uchar int vertex_indices\nproperty int piece\nproperty int cut\nend_header\n";
  return text;
}

void append_vertices(std::string& bytes, const StyledMesh& mesh, const Pose& pose,
                     const std::vector<std::int32_t>& parts) {
  const bool stays = pose.rotation == glm::dquat(1, 0, 0, 0) && pose.translation == glm::dvec3(0);
  for (std::size_t v = 0; v < mesh.position.size(); ++v) {
    glm::vec3 position = mesh.position[v], normal = mesh.normal[v];
    if (!stays) {
      position = glm::vec3(pose.rotation * glm::dvec3(position) + pose.translation);
      normal = glm::vec3(pose.rotation * glm::dvec3(normal));
    }
    append(bytes, position);
    append(bytes, normal);
    append(bytes, to_srgb8(mesh.color[v]));
    const auto part = static_cast<std::size_t>(mesh.part[v]);
    append(bytes, part < parts.size() ? parts[part] : std::int32_t{-1});
  }
}

}  // namespace

std::string write_solids(const Scene& scene, const ExportOptions& options) {
  const std::vector<StyledMesh> meshes = styled_meshes(scene, options);
  const Parts parts = parts_of(scene);
  std::size_t vertices = 0, faces = 0;
  for (const Instance& instance : scene.instances) {
    vertices += meshes.at(instance.solid).position.size();
    faces += meshes.at(instance.solid).triangle.size();
  }

  if (vertices > INT32_MAX || faces > INT32_MAX)
    throw Error(ExitStatus::bad_data,
                "a .ply holds 2147483647 vertices and faces at most, and the scene has " + std::to_string(vertices) +
                    " and " + std::to_string(faces),
                "fewer copies, or a lower --detail; .glb and .usda hold copies once");

  // All vertices, then all faces, instance by instance.
  std::string bytes = header_of(scene, parts, vertices, faces);
  for (const Instance& instance : scene.instances)
    append_vertices(bytes, meshes[instance.solid], instance.pose, parts.of_solid[instance.solid]);
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const StyledMesh& mesh = meshes[scene.instances[i].solid];
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
      append(bytes, std::uint8_t{3});
      append(bytes, mesh.triangle[t] + first);
      append(bytes, static_cast<std::int32_t>(i));
      append(bytes, mesh.cut_face[t]);
    }
    first += static_cast<std::uint32_t>(mesh.position.size());
  }
  return bytes;
}

}  // namespace pomona
