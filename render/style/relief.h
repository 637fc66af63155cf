// Relief: the height of details along the normal, as the slope for shading and normal maps. With face_relief.h it is
// all depth beyond the mesh; no vertex moves.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "render/style/look.h"

namespace pomona {

/// Height and slope of a surface beyond its mesh.
struct Relief {
  double height = 0;    ///< height along the normal, metres
  glm::dvec3 slope{0};  ///< slope of the height, at right angles to the normal
  double open = 1;      ///< share of the light from all sides that arrives, 0.4..1: less in deep pits
};

/// The relief of details at a place. The slope is taken over half a footprint, as in shaders/detail.glsl.
/// \param unmodulated the colour there before noise and details.
/// \param normal unit
Relief relief_at(const Look& look, const Color& unmodulated, const LookPlace& place, const glm::dvec3& normal);

/// The relief over a texel, whose side is the place's footprint: the mean slope and height, from its four corners. One
/// place would make single texels of lines as narrow as a texel. Steep walls are flattened, as a film of juice rounds
/// them: a texel holds one normal.
Relief relief_over_texel(const Look& look, const Color& unmodulated, const LookPlace& place, const glm::dvec3& normal);

/// The same for many texels, several times as fast. All spans are equally long.
std::vector<Relief> reliefs_over_texels(const Look& look, std::span<const Color> unmodulated,
                                        std::span<const LookPlace> places, std::span<const glm::dvec3> normals);

/// The guide at a neighbouring place: the way to the skin and the layer change by as much as it lies nearer to the
/// skin.
DetailGuide guide_beside(const DetailGuide& guide, const glm::dvec3& step);

/// The normal of a surface with this slope.
glm::dvec3 tilted(const glm::dvec3& normal, const glm::dvec3& slope);

}  // namespace pomona
