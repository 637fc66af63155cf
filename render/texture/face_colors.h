// Colours at any point of cut faces, interpolated from colours diffused at some points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/diffusion/diffuser.h"
#include "generator/piece/solid.h"

namespace pomona {

/// When triangles are subdivided. Colour differences are those of encoded sRGB, 0 to 255.
struct FaceColorOptions {
  double tolerance = 4;  ///< an edge is subdivided if the colour of its middle differs by more from the predicted one
  double shortest = 1;   ///< edges shorter than this, in texels, are not subdivided
  double even = 6;       ///< edges inside a triangle whose colours differ by less are not subdivided, up to `longest`
  double longest = 12;   ///< texels: limit for `even`
  int max_rounds = 3;    ///< rounds of diffusion; each costs about as much as some thousand points
};

/// A solid, and the size of its texels.
struct FaceColorTask {
  const Solid* solid = nullptr;  ///< must outlive the call
  double texel = 0;              ///< metres
};

/// The colours of one solid's cut faces: quadratic inside the triangles of the subdivision, and never outside the range
/// of their six colours.
class FaceColors {
 public:
  /// The linear colour at a point (barycentric coordinates) of a triangle of a cut face.
  Color at(std::uint32_t triangle, const glm::dvec3& weight) const;

  /// A triangle: its corners, and the middles of its edges k to k + 1, as indices of colours.
  struct Cell {
    std::array<std::uint32_t, 3> corner{}, middle{};
    std::int32_t first_child = -1;  ///< first of four children: at the corners 0, 1, 2, and between them
  };
  std::vector<std::int32_t> root;  ///< per triangle of the solid: its cell, or -1 on skin
  std::vector<Cell> cells;
  std::vector<Color> color;
};

/// The diffused colours of solids of one fruit.
struct DiffusedFaces {
  std::vector<FaceColors> of_solid;
  std::size_t points = 0;  ///< asked of the field
};

/// Adaptive subdivision. It starts with the triangles and the colours at their corners, and samples `field` at the
/// middles of edges. A triangle is divided into four as long as the colour of one of its middles differs from the
/// predicted one: the mean of the ends, and in later rounds the parabola. On edges along surfaces, and on rims, colours
/// are interpolated between the ends, except where surfaces end or branch. Solids that share points of the section
/// share the samples. The colours do not depend on the number of threads.
DiffusedFaces diffused_faces(std::span<const FaceColorTask> tasks, const ColorField& field,
                             const FaceColorOptions& options = {});

}  // namespace pomona
