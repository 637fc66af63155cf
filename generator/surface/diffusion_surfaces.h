// Diffusion surfaces: triangles with a colour on either side and a blur (paper, section 3.1).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/mesh/box.h"

namespace pomona {

enum class SideOf : std::uint8_t { front, back };

/// All the diffusion surfaces of one fruit as one structure of arrays; the exchange value between sweep,
/// cut and diffusion, and exactly what a surface file (.ply) holds. Metres, +Y along the axis.
/// Front of a triangle = the side from which its vertices run counter-clockwise.
struct DiffusionSurfaces {
  // One entry per vertex.
  std::vector<glm::vec3> position;
  std::vector<Color> front_color;          ///< linear
  std::vector<Color> back_color;           ///< linear
  std::vector<float> blur;                 ///< metres; 0 after sheets()
  std::vector<std::uint8_t> front_hidden;  ///< 1 where the side faces air
  std::vector<std::uint8_t> back_hidden;

  // One entry per triangle.
  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> surface;     ///< index into surface_names
  std::vector<std::int32_t> front_part;  ///< index into part_names
  std::vector<std::int32_t> back_part;

  /// Per triangle the instance of a placed template that it belongs to, from 1 on; 0: the fruit itself. Empty where
  /// nothing is placed.
  std::vector<std::int32_t> instance;

  std::vector<std::string> surface_names;
  std::vector<std::string> part_names;

  std::vector<std::string> notes;  ///< ambiguities of their files, and how they were resolved

  std::size_t vertex_count() const { return position.size(); }
  std::size_t triangle_count() const { return triangle.size(); }

  std::int32_t instance_of(std::size_t triangle_index) const { return instance.empty() ? 0 : instance[triangle_index]; }

  /// A triangle's side is hidden when all three of its vertices say so (docs/reference/formats.md).
  bool is_hidden(std::size_t triangle_index, SideOf side) const;

  /// Exactly one hidden side: part of the boundary between the fruit and air.
  bool is_boundary(std::size_t triangle_index) const;
};

/// Both, one after the other; names merged (equal part names become one part, surfaces stay apart). Instances keep
/// their numbers.
DiffusionSurfaces joined(const DiffusionSurfaces& first, const DiffusionSurfaces& second);

/// Appends a vertex like one of `from`; the number of the new one.
std::uint32_t add_vertex(DiffusionSurfaces& surfaces, const DiffusionSurfaces& from, std::uint32_t vertex);

/// Appends a vertex like this one; the number of the new one.
std::uint32_t doubled_vertex(DiffusionSurfaces& surfaces, std::uint32_t vertex);

/// Appends a vertex at a place within a triangle of `from`, with the colours and the blur that the triangle has there;
/// nothing is hidden there. Its number.
std::uint32_t add_vertex_within(DiffusionSurfaces& surfaces, const DiffusionSurfaces& from, const glm::uvec3& triangle,
                                const glm::dvec3& place);

/// The box around all vertices that a triangle uses; a box of no size at zero for no triangles.
Box<double> bounds_of(const DiffusionSurfaces& surfaces);

}  // namespace pomona
