// Mass, and how it is spread: moments of solids up to the second.
#pragma once

#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// Integrals over a solid of its density times 1, x and x x^T, places taken from an origin that whoever sums them
/// knows. Moments of parts add up to those of the whole.
struct Moments {
  double mass = 0;       ///< kilograms; cubic metres where the density counts as 1
  glm::dvec3 first{0};   ///< times metres
  glm::dmat3 second{0};  ///< times square metres

  void add(const Moments& more, double times = 1);
};

/// Of what the triangles bound, of density 1: tetrahedra to `origin`, summed with their signs; exact for closed meshes
/// [Tonon 2004]. Of an open mesh, what it bounds together with the origin.
Moments moments_of(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangle, const glm::dvec3& origin);

/// What a rigid body's motion depends on.
struct RigidMass {
  double mass = 0;        ///< kilograms
  glm::dvec3 center{0};   ///< of mass
  glm::dmat3 inertia{0};  ///< about the centre of mass, kg m^2; the axes are those of the places
};

/// \param origin that the moments were taken about.
RigidMass rigid_mass(const Moments& moments, const glm::dvec3& origin);

}  // namespace pomona
