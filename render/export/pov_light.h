// A style's light, and the ground it falls on, as POV-Ray's.
#pragma once

#include <string>

#include "generator/scene/scene.h"
#include "render/style/style.h"

namespace pomona::pov {

/// The light of a scene as a style has it, in units of `unit` metres.
class Lighting {
 public:
  Lighting(const View& view, const Style& style, double unit);

  /// Light sources: the style's own, as wide as its shadows are soft; without a shadow as far as the style takes from
  /// them; and a weak one from the other side that throws none.
  std::string sources() const;

  /// For global_settings: what comes from all sides.
  std::string ambient() const;

  /// Texture of the ground: the paper's colour where it is lit, and the style's wash on it in full shadow.
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
