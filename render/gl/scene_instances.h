// The data of each instance for the shaders (shaders/gbuffer.glsl).
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "generator/scene/scene.h"
#include "render/gl/scene_camera.h"
#include "render/style/style.h"

namespace pomona {

struct InstanceTexels {
  glm::vec4 ink_and_width{0};  ///< width in samples
  glm::vec4 pen{0};            ///< wavelength of the hand in metres; width of inner lines in samples; solid; opacity
  glm::vec4 to_fruit[3]{};     ///< rows of the matrix from the scene to the fruit's own frame
};

/// Stroke widths depend on the size of each instance in the picture, as on sections: small pieces get finer lines.
/// \param samples the picture's size in samples.
std::vector<InstanceTexels> instance_texels(const Scene& scene, const SceneCamera& camera, const Style& style,
                                            const glm::dvec2& samples);

}  // namespace pomona
