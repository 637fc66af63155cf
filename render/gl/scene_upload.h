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
  GlTable triangle_tags;     ///< per triangle: the low 12 bits of its id (shaders/gbuffer.glsl)
  GlTable noise_styles;      ///< per solid noise_texels texels (shaders/noise.glsl)
  GlTable materials;         ///< shaders/material.glsl
  GlTable pits;              ///< per solid, and their grids (shaders/skin_pits.glsl)
  bool translucent = false;  ///< whether light passes through any solid
  GlVertexArray solids, hairs;

  /// Guides of texture detail, if any solid has them.
  struct Guides {
    GlBuffer share;    ///< per vertex
    GlTable styles;    ///< per solid, and the tiles of examples (shaders/detail.glsl)
    GlTable lattices;  ///< per solid, and the lattices themselves (shaders/guide_lattice.glsl)
    bool any_example = false;
  };
  std::optional<Guides> guides;
};

/// \throws Error (bad_data) for more triangles, or solids, than a buffer texture of this context holds.
UploadedSolids uploaded(const CurrentGl& gl, const Scene& scene, const Style& style);

/// One solid's texels in noise_styles.
std::vector<glm::vec4> noise_texels(const NoiseStyle& style);

}  // namespace pomona
