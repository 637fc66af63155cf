#include "generator/surface/file/plain_mesh_file.h"

#include <cstddef>
#include <string>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/small_ending.h"
#include "generator/surface/file/glb_file.h"
#include "generator/surface/file/obj_file.h"
#include "generator/surface/file/surface_file.h"

namespace pomona {

namespace {

std::string mesh_bytes(const std::filesystem::path& file) {
  return file_bytes(file, std::size_t{64} << 20, "simplify the mesh");
}

}  // namespace

PlainMesh read_plain_mesh(const std::filesystem::path& file) {
  const std::string ending = small_ending(file), name = file.string();
  if (ending == ".obj") return parse_obj(mesh_bytes(file), name, {});
  if (ending == ".glb") return parse_glb(mesh_bytes(file), name, {});
  if (ending == ".ply") return parse_plain_surfaces(mesh_bytes(file), name, {});
  throw Error(ExitStatus::bad_data,
              {{{name, 0, 0, {}}, "is no mesh that can be read", "export it as .ply, .obj or .glb"}});
}

}  // namespace pomona
