#include "generator/surface/file/plain_mesh_file.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <system_error>

#include "generator/base/error.h"
#include "generator/surface/file/glb_file.h"
#include "generator/surface/file/obj_file.h"
#include "generator/surface/file/surface_file.h"

namespace pomona {

namespace {

std::string read_bytes(const std::filesystem::path& file) {
  constexpr std::uintmax_t most_bytes = std::uintmax_t{64} << 20;
  std::error_code wrong;
  const bool is_file = std::filesystem::is_regular_file(file, wrong);
  const std::uintmax_t bytes = is_file ? std::filesystem::file_size(file, wrong) : 0;
  std::ifstream stream(file, std::ios::binary);
  if (!is_file || wrong || !stream)
    throw Error(ExitStatus::input_missing, {{{file.string(), 0, 0, {}}, "cannot be read", {}}});
  if (bytes > most_bytes)
    throw Error(ExitStatus::bad_data, {{{file.string(), 0, 0, {}}, "is larger than 64 MiB", "simplify the mesh"}});

  // The file may have become shorter since it was measured.
  std::string read(bytes, '\0');
  stream.read(read.data(), static_cast<std::streamsize>(bytes));
  read.resize(static_cast<std::size_t>(stream.gcount()));
  return read;
}

PlainMesh front_of(const DiffusionSurfaces& surfaces) {
  PlainMesh plain;
  for (const glm::vec3& p : surfaces.position) plain.position.emplace_back(p);
  plain.color = surfaces.front_color;
  plain.triangle = surfaces.triangle;
  return plain;
}

}  // namespace

PlainMesh read_plain_mesh(const std::filesystem::path& file) {
  const std::string ending = file.extension().string(), name = file.string();
  if (ending == ".obj") return without_unused(parse_obj(read_bytes(file), name, {}));
  if (ending == ".glb") return without_unused(parse_glb(read_bytes(file), name, {}));
  if (ending == ".ply") return without_unused(front_of(parse_surfaces(read_bytes(file), name)));
  throw Error(ExitStatus::bad_data,
              {{{name, 0, 0, {}}, "is no mesh that can be read", "export it as .ply, .obj or .glb"}});
}

}  // namespace pomona
