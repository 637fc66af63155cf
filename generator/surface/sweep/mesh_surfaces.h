// From a template's [[mesh]] to diffusion surfaces.
#pragma once

#include <cstddef>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"

namespace pomona {

/// The mesh where the template puts it: a surface file with its own colours and surfaces, or a plain mesh painted as
/// the template says, one surface of the mesh's name. Parts are numbered as in the template.
/// \throws Error (bad_data) with the place in the mesh's file, or that of the mesh in the template's, for what cannot
/// be read, an object or colours that are not there, and parts the template does not name.
DiffusionSurfaces mesh_surfaces(const Template& fruit, const MeshSketch& mesh);

/// Whether it bounds what is solid, and the template leaves it to the mesh which way it faces.
bool may_turn(const MeshSketch& mesh);

/// \throws Error (bad_data) at this mesh in the template if with it all its meshes have too many triangles together,
/// each of which alone may be in order.
void check_meshes_together(const Template& fruit, const MeshSketch& mesh, std::size_t triangles);

}  // namespace pomona
