// The light of a style, and the ground, for POV-Ray.
#pragma once

#include <string>

#include "generator/scene/scene.h"
#include "render/style/style.h"

namespace pomona::pov {

/// The light of a scene as a style has it, in units of `unit` metres.
class Lighting {
 public:
  Lighting(const View& view, const Style& style, double unit);

  /// Light sources: the style's key light, whose width gives the softness of shadows; a part of it without shadows, if
  /// the style weakens these; and a weak fill light from the other side without shadows.
  std::string sources() const;

  /// The ambient light, for global_settings.
  std::string ambient() const;

  /// Texture of the ground: the paper's colour where it is lit, with the style's wash in full shadow.
  std::string ground() const;

 private:
  glm::dvec3 target_, to_key_, to_fill_;
  double distance_;
  glm::dvec3 key_, fill_;  // colours
  double width_;           // of the key, 0 = a point
  double shadow_;          // how much of the key throws one
  glm::dvec3 wash_;        // of the shadow
  double from_all_sides_;
};

}  // namespace pomona::pov
