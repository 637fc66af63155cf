#include "generator/surface/file/plain_mesh.h"

#include <cstdint>

namespace pomona {

std::string listed_names(const std::vector<std::string>& names) {
  constexpr std::size_t max = 20, longest = 64;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < max; ++i) {
    text += (text.empty() ? "" : ", ") + names[i].substr(0, longest);
  }
  return names.size() > max ? text + ", ..." : text;
}

std::string few_corners_note(std::size_t faces) {
  return faces == 1 ? "a face of less than three corners is left out"
                    : std::to_string(faces) + " faces of less than three corners are left out";
}

PlainMesh without_unused(const PlainMesh& mesh) {
  constexpr std::uint32_t unused = UINT32_MAX;
  std::vector<std::uint32_t> index(mesh.position.size(), unused);
  PlainMesh result;
  for (const glm::uvec3& t : mesh.triangle) {
    glm::uvec3 corners(0);
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& vertex = index[t[k]];
      if (vertex == unused) {
        vertex = static_cast<std::uint32_t>(result.position.size());
        result.position.push_back(mesh.position[t[k]]);
        if (!mesh.color.empty()) result.color.push_back(mesh.color[t[k]]);
      }
      corners[k] = vertex;
    }
    result.triangle.push_back(corners);
  }
  return result;
}

}  // namespace pomona
