// Meshes in all kinds of files that modelling tools write.
#pragma once

#include <string>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona::mesh_files {

/// A cube of side 2 about 0,0,0 in two objects, "lid" (the upper face) and "box" (the rest), as quadrilaterals.
std::string cube_obj();

/// The same as glTF: a node for each object, moved 1 up, with COLOR_0 of one channel each. `change` replaces text in
/// the JSON, to make mistakes; `bin` is the buffer, which may be cut short or spoilt.
struct Change {
  std::string from, to;
};
std::string cube_json(const Change& change = {});
std::string cube_bin();
std::string glb(std::string json, std::string bin);

/// The cube of cube_glb(), made in one line.
inline std::string cube_glb(const Change& change = {}) { return glb(cube_json(change), cube_bin()); }

/// One object of that name, as .obj and as .glb, both exact; `surfaces` gives positions and triangles.
std::string obj_of(const DiffusionSurfaces& surfaces, const std::string& name);
std::string glb_of(const DiffusionSurfaces& surfaces, const std::string& name);

}  // namespace pomona::mesh_files
