// The guide of texture detail at a point of a fruit: the direction and depth of its layers (paper, section 6).
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace pomona {

/// One per vertex. Between vertices it is interpolated linearly, like colours; the way and the layer of a cut face are
/// rather asked of its GuideLattice (guide_lattice.h), which knows nothing of triangles.
struct DetailGuide {
  glm::vec3 to_skin{0};  ///< from here, across the layers, to the skin, metres; 0 on skins
  float layer = 0;       ///< depth of the layer through this point, metres: constant along layers, 0 on skins
  glm::vec4 share{0};    ///< strength of each detail of this kind of face, 0..1, in the template's order
};

inline DetailGuide scaled(const DetailGuide& guide, float factor) {
  return {guide.to_skin * factor, guide.layer * factor, guide.share * factor};
}

/// The guide at the point with barycentric coordinates 1 - b - c, b and c in a triangle.
inline DetailGuide interpolated(const DetailGuide& first, const DetailGuide& second, const DetailGuide& third, float b,
                                float c) {
  const float a = 1 - b - c;
  return {first.to_skin * a + second.to_skin * b + third.to_skin * c,
          first.layer * a + second.layer * b + third.layer * c, first.share * a + second.share * b + third.share * c};
}

}  // namespace pomona
