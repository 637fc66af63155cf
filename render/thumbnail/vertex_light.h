// How light falls on a mesh, vertex by vertex.
#pragma once

#include <vector>

#include "generator/piece/pose.h"
#include "render/export/styled_mesh.h"
#include "render/picture/view_frame.h"

namespace pomona {

/// The mesh's colours as light of the style's direction and strength shows them, softly: linear, may go above 1 in
/// highlights. Cut faces shine less than skin. \param frame of the one who looks.
std::vector<Color> lit_colors(const StyledMesh& mesh, const Solid& solid, const Pose& pose, const ViewFrame& frame,
                              const LightStyle& light);

}  // namespace pomona
