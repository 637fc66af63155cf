// Texture by example: what a tile shows at a place, and how it changes a colour. shaders/detail.glsl has the same
// formulas.
#pragma once

#include <glm/vec3.hpp>

#include "generator/template/example_tile.h"

namespace pomona {

/// Turns places of a pattern so that no plane that is often cut is one of the tile, in whose faces it would repeat: by
/// the quaternion (sqrt 2, sqrt 3 - 1, sqrt 5 - 2, sqrt 7 - 2), normalised.
glm::dvec3 turned_for_tile(const glm::dvec3& place);

/// The tile's colour at a place, periodic in whole numbers, trilinear; linear light.
/// \param texels how many of the tile's texels a pixel covers: coarser levels are blended in above one.
Color tile_color(const ExampleTile& tile, const glm::dvec3& place, double texels);

/// Where a colour stands between the tile's least and its largest luminance, as a share of the way.
double luminance_share(const ExampleTile& tile, const Color& color);

/// The colour and `weight` times what the tile's colour differs from its mean, in linear light. Each channel's weight
/// is lowered to what leaves room for the tile's extremes, whatever it shows here: so nothing is clipped, and the mean
/// over many places stays the colour.
Color with_example(const Color& color, const ExampleTile& tile, const Color& shown, double weight);

}  // namespace pomona
