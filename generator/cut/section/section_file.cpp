#include "generator/cut/section/section_file.h"

#include <algorithm>
#include <bit>

#include "generator/base/color.h"

namespace pomona {

namespace {

/// Appends numbers as little-endian bytes.
class Bytes {
 public:
  explicit Bytes(std::string& out) : out_(out) {}
  void put(std::uint8_t value) { out_.push_back(static_cast<char>(value)); }
  void put(std::uint32_t value) {
    for (int i = 0; i < 4; ++i) out_.push_back(static_cast<char>((value >> (8 * i)) & 0xff));
  }
  void put(std::int32_t value) { put(static_cast<std::uint32_t>(value)); }
  void put(float value) { put(std::bit_cast<std::uint32_t>(value)); }

 private:
  std::string& out_;
};

/// A name fit for one line of the header.
std::string one_line(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return name;
}

std::string header(const CrossSection& section) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (std::size_t i = 0; i < section.surface_names.size(); ++i) {
    text += "comment surface " + std::to_string(i) + " " + one_line(section.surface_names[i]) + "\n";
  }
  for (std::size_t i = 0; i < section.part_names.size(); ++i) {
    text += "comment part " + std::to_string(i) + " " + one_line(section.part_names[i]) + "\n";
  }
  text += "element vertex " + std::to_string(section.position.size()) + "\n";
  text += "property float x\nproperty float y\nproperty float z\n";
  text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text += "property float r\nproperty float g\nproperty float b\n";
  text += "property uchar interior\nproperty int part\n";
  text += "element face " + std::to_string(section.triangle.size()) + "\n";
  text += "property list uchar int vertex_indices\nproperty int cut\nend_header\n";
  return text;
}

}  // namespace

std::string write_section(const CrossSection& section) {
  std::string file = header(section);
  Bytes bytes(file);
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    for (int i = 0; i < 3; ++i) bytes.put(section.position[v][i]);
    const glm::u8vec3 srgb = to_srgb8(section.color[v]);
    for (int i = 0; i < 3; ++i) bytes.put(srgb[i]);
    for (int i = 0; i < 3; ++i) bytes.put(section.color[v][i]);
    bytes.put(section.interior[v]);
    bytes.put(section.part[v]);
  }
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    bytes.put(std::uint8_t{3});
    for (int i = 0; i < 3; ++i) bytes.put(section.triangle[t][i]);
    bytes.put(section.cut[t]);
  }
  return file;
}

}  // namespace pomona
