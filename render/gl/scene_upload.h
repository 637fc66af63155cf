// A scene's solids in the graphics memory.
#pragma once

#include <optional>
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
    GLint first_hair_vertex = 0;
    GLsizei hair_vertices = 0;
  };
  std::vector<Part> parts;
  GlBuffer position, normal, color, material, relief, index;
  GlBuffer hair_position, hair_along, hair_color, hair_normal;
  GlBuffer tag_buffer;
  GlTexture triangle_tags;  ///< per triangle: the low 12 bits of its id (shaders/gbuffer.glsl)
  GlBuffer noise_buffer;
  GlTexture noise_styles;  ///< per solid noise_texels texels (shaders/noise.glsl)
  GlBuffer material_buffer;
  GlTexture materials;  ///< shaders/material.glsl
  GlBuffer pit_buffer;
  GlTexture pits;            ///< per solid, and their grids (shaders/skin_pits.glsl)
  bool translucent = false;  ///< whether light passes through any solid
  GlVertexArray solids, hairs;

  /// What guides texture detail, where any solid has it.
  struct Guides {
    GlBuffer way, share;  ///< per vertex
    GlBuffer style_buffer;
    GlTexture styles;  ///< per solid (shaders/detail.glsl)
    GlVertexArray vertices;
  };
  std::optional<Guides> guides;
};

/// \throws Error (bad_data) for more triangles than a buffer texture of this context holds.
UploadedSolids uploaded(const CurrentGl& gl, const Scene& scene, const Style& style);

/// One solid's texels in noise_styles.
std::vector<glm::vec4> noise_texels(const NoiseStyle& style);

}  // namespace pomona
