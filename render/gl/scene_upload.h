// A scene's solids in the graphics memory.
#pragma once

#include <vector>

#include "generator/scene/scene.h"
#include "render/gl/objects.h"
#include "render/style/style.h"

namespace pomona {

/// All solids in one set of buffers, each drawn from its part of them.
struct UploadedSolids {
  struct Part {
    GLsizei indices = 0;
    std::size_t first_index = 0;
    GLint first_vertex = 0;
    GLint first_triangle = 0;  ///< in triangle_tags
  };
  std::vector<Part> parts;
  GlBuffer position, normal, color, index;
  GlBuffer tag_buffer;
  GlTexture triangle_tags;  ///< per triangle: the low 12 bits of its id (shaders/gbuffer.glsl)
  GlBuffer noise_buffer;
  GlTexture noise_styles;  ///< per solid noise_texels texels (shaders/noise.glsl)
  GlVertexArray solids;
};

/// \throws Error (bad_data) for more triangles than a buffer texture of this context holds.
UploadedSolids uploaded(const CurrentGl& gl, const Scene& scene, const Style& style);

/// One solid's texels in noise_styles.
std::vector<glm::vec4> noise_texels(const NoiseStyle& style);

}  // namespace pomona
