// Makes diffusion surfaces of a template's [[mesh]].
#pragma once

#include <cstddef>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"

namespace pomona {

/// The mesh, placed as in the template. It is a surface file with its own colours and surfaces, or a plain mesh with
/// the paint of the template, as one surface with the mesh's name. Parts are numbered as in the template.
/// \throws Error (bad_data) with a place in the mesh's file or in the template, if the file cannot be read, if an
/// object or colours are missing, or if it has parts that the template does not name.
DiffusionSurfaces mesh_surfaces(const Template& fruit, const MeshSketch& mesh);

/// Whether it bounds something solid, and the template lets the mesh decide its orientation.
bool may_turn(const MeshSketch& mesh);

/// \throws Error (bad_data) at this mesh in the template, if the meshes up to this one have too many triangles in all.
void check_meshes_together(const Template& fruit, const MeshSketch& mesh, std::size_t triangles);

}  // namespace pomona
