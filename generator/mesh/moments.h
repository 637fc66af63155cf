// Moments of solids up to the second: mass, centre of mass, inertia.
#pragma once

#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// Integrals over a solid of its density times 1, x and x x^T. Positions x are relative to an origin that the caller
/// keeps. The moments of parts add up to those of the whole.
struct Moments {
  double mass = 0;       ///< kilograms; cubic metres where the density counts as 1
  glm::dvec3 first{0};   ///< times metres
  glm::dmat3 second{0};  ///< times square metres

  void add(const Moments& more, double times = 1);
};

/// The moments of the solid that the triangles bound, with density 1: a sum over signed tetrahedra to `origin`, exact
/// for closed meshes [Tonon 2004]. For an open mesh, those of the solid between the mesh and the origin.
Moments moments_of(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangle, const glm::dvec3& origin);

/// The mass properties of a rigid body.
struct RigidMass {
  double mass = 0;        ///< kilograms
  glm::dvec3 center{0};   ///< centre of mass, metres
  glm::dmat3 inertia{0};  ///< about the centre of mass, along the axes of the positions, kg m^2
};

/// \param origin that the moments were taken about.
RigidMass rigid_mass(const Moments& moments, const glm::dvec3& origin);

}  // namespace pomona
