// Pen strokes as geometry for POV-Ray.
#pragma once

#include <span>
#include <string>

#include "render/strokes/scene_strokes.h"

namespace pomona {

/// A scene's strokes, and the size of the picture that they are for.
struct SceneInk {
  int width = 800, height = 600;
  std::vector<SceneStroke> strokes;
};

namespace pov {

/// "#declare Ink = union { ... }" in units of 10^unit_exponent metres: ribbons that face the scene's camera, each a
/// little nearer to it than the surface below. They are self-luminous and cast no shadow.
std::string ink_text(const Scene& scene, const SceneInk& ink, int unit_exponent);

}  // namespace pov
}  // namespace pomona
