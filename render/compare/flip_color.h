// The colour spaces of FLIP [Andersson et al. 2020, section 4.1].
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// Linear sRGB, 0..1 a channel, as Y, Cx, Cz: CIELAB without its cube root, so that filters may sum it.
glm::dvec3 opponent_from_linear(const glm::dvec3& rgb);
glm::dvec3 linear_from_opponent(const glm::dvec3& opponent);

/// Linear sRGB as CIELAB, with a and b scaled by lightness: colourfulness fades in the dark [Hunt 1952].
glm::dvec3 hunt_lab_from_linear(const glm::dvec3& rgb);

/// Distance of two such colours that stays true where it is large: |L| + |(a, b)| [Abasi et al. 2020].
double hyab(const glm::dvec3& first, const glm::dvec3& second);

/// How bright a linear colour is, 0..1: what edges and points are looked for in.
double luminance_of_linear(const glm::dvec3& rgb);

}  // namespace pomona
