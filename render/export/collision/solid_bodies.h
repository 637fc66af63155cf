// The bodies that a solid's mesh is made of, such as the slats of a crate.
#pragma once

#include <vector>

#include "generator/piece/solid.h"
#include "render/export/collision/cut_surface.h"

namespace pomona::collision {

/// A surface for each body: triangles that share edges of two. Bodies that merely touch each other, along an edge or
/// in a corner, are two. All is one surface where cavities are among the bodies, or a body is open.
std::vector<CutSurface> bodies_of(const Solid& solid);

}  // namespace pomona::collision
