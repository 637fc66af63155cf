#include <cstdint>
#include <string>

#include "generator/base/little_endian.h"
#include "generator/surface/file/one_line.h"
#include "generator/surface/file/surface_file.h"

namespace pomona {

namespace {

std::string header(const DiffusionSurfaces& surfaces) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment diffusion surfaces, metres, y up\n";
  for (std::size_t i = 0; i < surfaces.surface_names.size(); ++i) {
    text += "comment surface " + std::to_string(i) + " " + one_line(surfaces.surface_names[i]) + "\n";
  }
  for (std::size_t i = 0; i < surfaces.part_names.size(); ++i) {
    text += "comment part " + std::to_string(i) + " " + one_line(surfaces.part_names[i]) + "\n";
  }
  text += "element vertex " + std::to_string(surfaces.vertex_count()) + "\n";
  for (const char* name : {"x", "y", "z"}) text += std::string("property float ") + name + "\n";
  for (const char* name : {"red", "green", "blue"}) text += std::string("property uchar ") + name + "\n";
  for (const char* name : {"front_r", "front_g", "front_b", "back_r", "back_g", "back_b", "blur"}) {
    text += std::string("property float ") + name + "\n";
  }
  text += "property uchar front_hidden\nproperty uchar back_hidden\n";
  text += "element face " + std::to_string(surfaces.triangle_count()) + "\nproperty list uchar int vertex_indices\n";
  for (const char* name : {"surface", "front_part", "back_part"}) text += std::string("property int ") + name + "\n";
  if (!surfaces.instance.empty()) text += "property int instance\n";
  return text + "end_header\n";
}

}  // namespace

std::string write_surfaces(const DiffusionSurfaces& surfaces) {
  // Make room for everything at once.
  ByteWriter out(header(surfaces));
  constexpr std::size_t bytes_per_vertex = 45, bytes_per_face = 29, header_room = 65536;
  out.reserve(header_room + bytes_per_vertex * surfaces.vertex_count() + bytes_per_face * surfaces.triangle_count());

  // Vertices also have a plain colour, the front's, for viewers that do not know diffusion surfaces.
  for (std::size_t v = 0; v < surfaces.vertex_count(); ++v) {
    out.add(surfaces.position[v]);
    const glm::u8vec3 shown = to_srgb8(surfaces.front_color[v]);
    for (int k = 0; k < 3; ++k) out.add(shown[k]);
    out.add(surfaces.front_color[v]);
    out.add(surfaces.back_color[v]);
    out.add(surfaces.blur[v]);
    out.add(surfaces.front_hidden[v]);
    out.add(surfaces.back_hidden[v]);
  }

  // A triangle is a list of three corners, then its surface and its parts.
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    out.add(std::uint8_t{3});
    for (int k = 0; k < 3; ++k) out.add(surfaces.triangle[i][k]);
    out.add(surfaces.surface[i]);
    out.add(surfaces.front_part[i]);
    out.add(surfaces.back_part[i]);
    if (!surfaces.instance.empty()) out.add(surfaces.instance[i]);
  }
  return out.take();
}

}  // namespace pomona
