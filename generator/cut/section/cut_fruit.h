// A fruit as the knives so far have left it: all its surfaces and cut faces, meeting vertex to vertex.
#pragma once

#include <vector>

#include "generator/cut/section/clipped_skin.h"
#include "generator/cut/section/section.h"
#include "generator/cut/section/split_mesh.h"

namespace pomona {

struct CutFruit {
  SplitMesh mesh;                     ///< its points and vertices; a place has one point only
  std::vector<SkinTriangle> surface;  ///< boundary triangles face air, inner ones are turned as they were
  Section section;                    ///< interior vertices still without colour
};

}  // namespace pomona
