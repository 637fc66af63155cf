// Relief: the height of details along the normal, as the slope that shading and normal maps want. Together with
// face_relief.h it is all that is known of the depth of a surface beyond its mesh; no vertex moves.
#pragma once

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "render/style/look.h"

namespace pomona {

/// What lies on a surface, beyond its mesh.
struct Relief {
  double height = 0;    ///< metres, along the normal
  glm::dvec3 slope{0};  ///< of the height, at right angles to the normal
  double open = 1;      ///< share of the light from all sides that comes to it, 0.4..1: less deep in pits
};

/// Of the details at a place. The slope is taken over half a footprint; shaders/detail.glsl does the same.
/// \param unmodulated the colour there before noise and details. \param normal unit
Relief relief_at(const Look& look, const Color& unmodulated, const LookPlace& place, const glm::dvec3& normal);

/// The guide at a place beside: the way to the skin and the layer are shorter by as much as it lies nearer to the skin.
DetailGuide guide_beside(const DetailGuide& guide, const glm::dvec3& step);

/// The normal of a surface of this slope.
glm::dvec3 tilted(const glm::dvec3& normal, const glm::dvec3& slope);

}  // namespace pomona
