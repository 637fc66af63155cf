// Reads a .glb as another program would.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pomona::named {

struct GlbMesh {
  std::string name;
  std::vector<glm::vec3> position, normal;
  std::vector<glm::vec3> color;  ///< of vertices; may be empty
  std::vector<glm::vec2> uv;     ///< may be empty
  std::vector<glm::u8vec3> texture;
  int texture_side = 0;
  std::vector<int> part;
  std::vector<glm::uvec3> triangle;
  std::vector<std::string> part_names;
  double volume = 0;
  bool double_sided = false;
  double alpha = 1;
  int index_bytes = 0;
};

struct GlbNode {
  std::string name;
  int mesh = -1;
  int camera = -1;
  glm::dmat4 matrix{1};
  bool is_in_scene = false;
  std::vector<int> levels;              ///< the nodes named by MSFT_lod
  std::vector<double> screen_coverage;  ///< MSFT_screencoverage
};

struct Glb {
  std::vector<GlbMesh> meshes;
  std::vector<GlbNode> nodes;
  double vertical_field = 0;
  std::string provenance;
  std::vector<std::string> extensions_used, extensions_required;
};

/// \throws std::runtime_error with the reader's message.
Glb read_glb(const std::string& bytes);

}  // namespace pomona::named
