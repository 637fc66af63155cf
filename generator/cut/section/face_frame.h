// The frame of a flat cut face, and positions in it.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/cut/section/cross_section.h"
#include "generator/knife/knife.h"

namespace pomona {

/// The frame of a plane: v points up as far as possible; for horizontal planes u = +X, v = -Z.
CutFace frame_of(const CuttingPlane& plane);

/// The position of a point along u and v from the face's origin, metres; and the inverse.
glm::dvec2 to_face(const CutFace& face, const glm::dvec3& point);
glm::dvec3 from_face(const CutFace& face, const glm::dvec2& point);

}  // namespace pomona
