// The paper's own way to positive mean values: all triangles drawn into a cube map around every point [paper, section
// 3.2]. A baseline for measurements, not for use.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"
#include "render/gl/context.h"

namespace pomona::bench {

struct CubeMapOptions {
  int texels = 32;                    ///< along an edge of a face: 6 * texels^2 directions
  std::optional<GlRoute> route = {};  ///< nothing: as GlContext chooses
};

struct CubeMapColors {
  std::vector<Color> color;  ///< linear, one for each point
  double setup = 0;          ///< milliseconds: uploading, and what drivers do at the first draw
  double per_point = 0;      ///< milliseconds: drawing, reading back, adding up; times all points = the whole
  std::string renderer;      ///< name of the renderer, from OpenGL
};

/// Draws and sums a cube map for each of `points` (metres); a few are enough to know what many would take. A point
/// nearer to a surface than 1e-5 of the surfaces' size takes the nearest side's colour, as does one that sees nothing.
/// \throws Error (helper_missing) without OpenGL, (bad_data) for surfaces without area or numbers that are not finite.
CubeMapColors cube_map_pmvc(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points,
                            const CubeMapOptions& options = {});

}  // namespace pomona::bench
