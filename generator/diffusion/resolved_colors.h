// From positive mean values to colours: the last steps, which all methods of computing them share.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "generator/diffusion/diffuser.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/diffusion/pmvc_value.h"
#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// The smallest and the largest of the surfaces' colours, channel by channel.
struct ColorHull {
  Color low{0}, high{0};
};
ColorHull hull_of(const DiffusionSurfaces& surfaces, const SurfaceTree& tree);

/// \throws Error (bad_data) if a coordinate is not finite.
void require_finite(std::span<const glm::vec3> points);

/// Per point: the side of the surface on which it lies, within 1e-5 of the surfaces' size. Such points get the colour
/// of this side and need no value.
using SidesOfPoints = std::vector<std::optional<SurfaceSide>>;
SidesOfPoints sides_on_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                std::span<const glm::vec3> points, Threads threads);

/// The same, where only points with an entry other than 0 in `near_surface` can lie on a surface.
SidesOfPoints sides_on_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                std::span<const glm::vec3> points, std::span<const std::uint8_t> near_surface,
                                Threads threads);

/// The same, and the nearest side of points that see nothing. One value per point.
SidesOfPoints sides_where_known(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                std::span<const glm::vec3> points, SidesOfPoints sides,
                                std::span<const PmvcValue> values, Threads threads);

/// The colour of each point: that of its side where it is known, else its value, clamped to the hull. There is one side
/// and one value per point.
DiffusedColors resolved_colors(const DiffusionSurfaces& surfaces, const ColorHull& hull, const SidesOfPoints& known,
                               std::span<const PmvcValue> values, Threads threads);

/// The same with the sides on surfaces, where points that see nothing get the nearest side. There is one value per
/// point.
DiffusedColors resolved_colors(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const ColorHull& hull,
                               std::span<const glm::vec3> points, const SidesOfPoints& sides,
                               std::span<const PmvcValue> values, Threads threads);

/// The same, and computes the sides.
DiffusedColors resolved_colors(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const ColorHull& hull,
                               std::span<const glm::vec3> points, std::span<const PmvcValue> values, Threads threads);

}  // namespace pomona
