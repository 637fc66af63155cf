#include "generator/template/read/read_mesh.h"

#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "generator/base/small_ending.h"
#include "generator/template/read/file_beside.h"
#include "generator/template/read/read_paint.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::size_t max_bytes = std::size_t{64} << 20;
constexpr std::size_t max_bytes_together = std::size_t{128} << 20;  // limit of all meshes of a template together
constexpr Within anywhere{-10, 10};                                 // metres
constexpr Within on_earth{-1e8, 1e8};                               // metres; scans lie where they were taken

std::optional<MeshFormat> format_of(const fs::path& file) {
  const std::string ending = small_ending(file);
  if (ending == ".ply") return MeshFormat::ply;
  if (ending == ".obj") return MeshFormat::obj;
  if (ending == ".glb") return MeshFormat::glb;
  return {};
}

/// The bytes of the file that the value names. Faults are noted at the value.
std::shared_ptr<const MeshFile> read_bytes(const TomlValue& value, const fs::path& folder) {
  // Only meshes are read, and only from the template's folder.
  const fs::path file = folder / value.text();
  const auto format = format_of(file);
  if (!format) {
    value.error("is no mesh that can be read", "export it as .ply, .obj or .glb");
    return {};
  }
  if (!file_beside(value, folder)) return {};

  // Neither it nor all of them together may fill the memory.
  std::optional<std::string> bytes = bytes_beside(value, file, max_bytes, "simplify the mesh");
  if (!bytes) return {};
  return std::make_shared<MeshFile>(MeshFile{file.string(), *format, std::move(*bytes)});
}

std::shared_ptr<const MeshFile> read_once(const TomlValue& value, const fs::path& folder,
                                          const std::vector<MeshSketch>& known) {
  if (!value.is(TomlNode::Kind::string)) {
    value.text();  // notes a fault if there is a value that is no text
    return {};
  }
  const std::string path = (folder / value.text()).string();
  for (const MeshSketch& mesh : known) {
    if (mesh.file && mesh.file->path == path) return mesh.file;
  }
  std::set<std::shared_ptr<const MeshFile>> files;
  for (const MeshSketch& mesh : known)
    if (mesh.file) files.insert(mesh.file);
  std::shared_ptr<const MeshFile> read = read_bytes(value, folder);
  std::size_t together = read ? read->bytes.size() : 0;
  for (const auto& file : files) together += file->bytes.size();
  if (together <= max_bytes_together) return read;
  value.error("makes the meshes larger than 128 MiB together", "simplify them");
  return {};
}

glm::dvec3 read_point(const TomlValue& value, const Within& where) {
  const auto values = value.values(3, "must be three lengths, as in [\"0mm\", \"55mm\", \"0mm\"]");
  if (values.empty()) return glm::dvec3(0);
  return {values[0].length(0, where), values[1].length(0, where), values[2].length(0, where)};
}

/// Reads a side that takes the file's colours if it gives none.
Side read_mesh_side(const TomlTable& table, const std::vector<std::string>& parts) {
  if (table.has("color")) {
    const Side side = read_surface_side(table, parts, {});
    for (const char* only : {"cells", "spots"})
      if (table.has(only)) table.get(only).error("need a drawn surface", "paint them in the modelling tool");
    return side;
  }
  Side side = read_uncolored_side(table, parts);
  side.color.along = Ramp<Color>::constant(Color(0.5f));  // ramps are never empty
  return side;
}

MeshPaint read_mesh_paint(const TomlTable& table, const std::vector<std::string>& parts) {
  MeshPaint paint;
  const TomlTable front = table.need("front").table(), back = table.need("back").table();
  paint.front = read_mesh_side(front, parts);
  paint.back = read_mesh_side(back, parts);
  paint.front_color_from_file = !front.has("color");
  paint.back_color_from_file = !back.has("color");
  if (paint.front.hidden && paint.back.hidden) {
    table.error("has both sides hidden", "hide only the side that faces air");
  }
  paint.blur = read_painted_blur(table.get("blur"));
  if (table.has("ramps_from")) paint.ramps_from = read_point(table.get("ramps_from"), anywhere);
  return paint;
}

}  // namespace

MeshSketch read_mesh(const TomlTable& table, const std::vector<std::string>& parts, const fs::path& folder,
                     const std::vector<MeshSketch>& known) {
  MeshSketch mesh;
  mesh.file = read_once(table.need("file"), folder, known);
  mesh.object = table.get("object").text();
  mesh.unit = table.get("unit").length(1, {1e-6, 1000});
  mesh.z_up = table.get("up").choice({"y", "z"}) == 1;
  if (table.has("flip")) mesh.flip = table.get("flip").boolean(false);
  mesh.at = read_point(table.get("at"), on_earth);

  // Plain meshes need sides. Surface files have their own, which given sides paint over.
  const bool is_plain = mesh.file && mesh.file->format != MeshFormat::ply;
  const bool is_painted = table.has("front") || table.has("back") || table.has("blur") || table.has("ramps_from");
  if (is_plain || is_painted) mesh.paint = read_mesh_paint(table, parts);
  return mesh;
}

}  // namespace pomona
