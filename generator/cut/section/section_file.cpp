#include "generator/cut/section/section_file.h"

#include "generator/base/color.h"
#include "generator/base/little_endian.h"
#include "generator/surface/file/one_line.h"

namespace pomona {

namespace {

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
  ByteWriter bytes(header(section));
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    bytes.add(section.position[v]);
    const glm::u8vec3 srgb = to_srgb8(section.color[v]);
    for (int i = 0; i < 3; ++i) bytes.add(srgb[i]);
    bytes.add(section.color[v]);
    bytes.add(section.interior[v]);
    bytes.add(section.part[v]);
  }
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    bytes.add(std::uint8_t{3});
    for (int i = 0; i < 3; ++i) bytes.add(section.triangle[t][i]);
    bytes.add(section.cut[t]);
  }
  return bytes.take();
}

}  // namespace pomona
