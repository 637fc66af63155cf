#include "render/export/obj.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include <glm/gtc/quaternion.hpp>

#include "generator/base/utf8.h"

namespace pomona {

namespace {

/// " 0.25": the shortest text that reads back as this number.
void append_decimal(std::string& text, float number) {
  char digits[32];
  const auto [end, fault] = std::to_chars(digits, digits + sizeof digits, number);
  text.push_back(' ');
  text.append(digits, end);
}

void append_decimals(std::string& text, const glm::vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) append_decimal(text, vector[axis]);
}

/// A name is one word, because blanks would make several names, and UTF-8.
std::string one_word(std::string_view any_name) {
  std::string name = as_utf8(any_name);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
  return name;
}

void append_vertices(std::string& text, const StyledMesh& mesh, const Pose& pose) {
  const bool stays = pose.rotation == glm::dquat(1, 0, 0, 0) && pose.translation == glm::dvec3(0);
  for (std::size_t v = 0; v < mesh.position.size(); ++v) {
    const glm::vec3 place =
        stays ? mesh.position[v] : glm::vec3(pose.rotation * glm::dvec3(mesh.position[v]) + pose.translation);
    text += "v";
    append_decimals(text, place);
    const auto color = to_srgb8(mesh.color[v]);
    for (int channel = 0; channel < 3; ++channel) append_decimal(text, static_cast<float>(color[channel]) / 255.0f);
    text += '\n';
  }
  for (const glm::vec3& normal : mesh.normal) {
    text += "vn";
    append_decimals(text, stays ? normal : glm::vec3(pose.rotation * glm::dvec3(normal)));
    text += '\n';
  }
}

/// \param first number of the mesh's first vertex, from 1, in the whole file.
void append_faces(std::string& text, std::span<const glm::uvec3> triangles, std::uint64_t first, bool has_normals) {
  for (const glm::uvec3& triangle : triangles) {
    text += 'f';
    for (int corner = 0; corner < 3; ++corner) {
      const std::string number = std::to_string(first + triangle[corner]);
      text += ' ' + number + (has_normals ? "//" + number : std::string());
    }
    text += '\n';
  }
}

}  // namespace

std::string write_obj(const Scene& scene, const ExportOptions& options) {
  const std::vector<StyledMesh> meshes = styled_meshes(scene, options);
  std::string text = "# made by Pomona, in metres\n";
  std::uint64_t first = 1;
  for (const Instance& instance : scene.instances) {
    const StyledMesh& mesh = meshes[static_cast<std::size_t>(instance.solid)];
    text += "o " + one_word(instance.name) + "\n";
    append_vertices(text, mesh, instance.pose);
    append_faces(text, mesh.triangle, first, true);
    first += mesh.position.size();
  }
  return text;
}

std::string write_obj(std::span<const glm::vec3> position, std::span<const glm::vec3> normal,
                      std::span<const glm::uvec3> triangle, const glm::vec3& pivot) {
  std::string text = "# made by Pomona, in metres\n";
  const auto append = [&](const char* what, const glm::vec3& vector) {
    text += what;
    append_decimals(text, vector);
    text += '\n';
  };
  for (const glm::vec3& p : position) append("v", p - pivot);
  for (const glm::vec3& n : normal) append("vn", n);
  append_faces(text, triangle, 1, !normal.empty());
  return text;
}

}  // namespace pomona
