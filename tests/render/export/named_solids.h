// Solids and scenes for the tests of exporters: small, asymmetric, and simple.
#pragma once

#include <string>

#include "generator/scene/scene.h"

namespace pomona::named {

/// A box with its own vertices on every face, normals outward, every face of one colour. The face at +Y is a cut
/// face (number 0, part 1 "flesh"); the others are skin (part 0 "skin").
Solid box(const std::string& name, const glm::vec3& low, const glm::vec3& high, const Color& skin, const Color& flesh);

/// A sphere of 8 n^2 triangles around the origin, of one colour.
Solid ball(const std::string& name, float radius, int n, const Color& color);

/// An open triangle, visible from both sides.
Solid leaf(const std::string& name, const Color& color);

/// Balls at the origin (grey), +X (red), +Y (green), +Z (blue), on the scale of a fruit, seen from the front right
/// and above; the three are instances turned and moved from the origin's solids.
Scene axes_of_balls();

/// A box whose skin is smooth, with bloom and fuzz, and whose flesh is dull where cut and lets light in 4, 2 and 1 mm.
Scene with_materials();

/// A box placed twice (once turned), a leaf, an empty solid, and a see-through ball.
Scene mixed();

/// Balls of 2 cm in a scene, two millimetres deep in each other: two of their own, and two copies of a third.
Scene settled_balls();

}  // namespace pomona::named
