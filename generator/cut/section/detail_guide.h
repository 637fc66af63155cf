// What guides texture detail at one place of a fruit: where its surfaces run (paper, section 6).
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace pomona {

/// One per vertex; between vertices it is interpolated linearly, like colours.
struct DetailGuide {
  glm::vec3 to_skin{0};  ///< metres: from here to where the way across the layers meets the skin; 0 on skins
  float layer = 0;       ///< metres: how deep the layer lies that passes here, constant along layers; 0 on skins
  glm::vec4 share{0};    ///< 0..1: how much each detail of this kind of face counts here, in the template's order
};

inline DetailGuide scaled(const DetailGuide& guide, float factor) {
  return {guide.to_skin * factor, guide.layer * factor, guide.share * factor};
}

/// At the place with weights 1 - b - c, b and c in a triangle.
inline DetailGuide interpolated(const DetailGuide& first, const DetailGuide& second, const DetailGuide& third, float b,
                                float c) {
  const float a = 1 - b - c;
  return {first.to_skin * a + second.to_skin * b + third.to_skin * c,
          first.layer * a + second.layer * b + third.layer * c, first.share * a + second.share * b + third.share * c};
}

}  // namespace pomona
