// Transparent solids, layer by layer: depth peeling [Everitt 2001].
#pragma once

#include "render/gl/placed_solids.h"
#include "render/gl/scene_camera.h"

namespace pomona {

/// The view and the light of the layers.
struct GlassView {
  SceneCamera camera;
  glm::vec3 eye{0};       ///< scene
  glm::vec3 to_light{0};  ///< unit, scene
  float gloss = 0;
  glm::vec2 light_strengths{1};  ///< strengths of the light, and of the light from all sides
  bool inked = false;
  const GlTexture* instances = nullptr;  ///< buffer of InstanceTexels
  int max_layers = 1;                    ///< layers behind that many are drawn as one, in their mean colour
};

/// The transparent solids before opaque ones, at the samples of `opaque_depth`: colour times coverage, and coverage, as
/// if all layers were laid over each other from back to front. Layers behind 99.6 % of coverage are left out, and of
/// surfaces at the same depth only one counts. A surface covers by its solid's opacity if seen at right angles, and
/// more at a slant, as a film: 1 - (1 - opacity)^(1/cos).
GlTexture glass_layers(const CurrentGl& gl, const PlacedSolids& solids, const GlassView& view,
                       const GlTexture& opaque_depth, const glm::ivec2& samples);

}  // namespace pomona
