// The frame of a flat cut face, and places in it.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/cut/section/cross_section.h"
#include "generator/knife/knife.h"

namespace pomona {

/// u and v upright where the plane is; for level planes u = +X, v = -Z.
CutFace frame_of(const CuttingPlane& plane);

/// Metres along u and v from the face's origin, and back.
glm::dvec2 to_face(const CutFace& face, const glm::dvec3& point);
glm::dvec3 from_face(const CutFace& face, const glm::dvec2& point);

}  // namespace pomona
