// Named shapes for tests: diffusion surfaces whose area, volume and field are known.
#pragma once

#include <string>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona::shapes {

/// How a shape's surface looks, the same everywhere.
struct Paint {
  Color front{0.8f, 0.1f, 0.1f};
  Color back{0.9f, 0.8f, 0.5f};
  std::string name = "surface";
  std::string front_part = "skin";
  std::string back_part = "flesh";
  bool front_hidden = false;
  bool back_hidden = false;
  float blur = 0;  ///< metres
};

/// The paint of a skin: its front faces air.
Paint skin_paint();

/// A triangle mesh without attributes becomes one surface.
DiffusionSurfaces painted(std::vector<glm::vec3> position, std::vector<glm::uvec3> triangle, const Paint& paint);

/// A sphere around the origin, front outside: an octahedron with each edge in `n` pieces, its vertices moved to the
/// sphere; 8 n^2 triangles, symmetric to the bit in all three axes.
DiffusionSurfaces sphere(double radius, int n, const Paint& paint = {});

/// An axis-aligned box, front outside, each face as 2 n^2 triangles.
DiffusionSurfaces box(const glm::dvec3& low, const glm::dvec3& high, int n = 1, const Paint& paint = {});

/// A square of side `size` in the plane y = height, around the axis, as 2 n^2 triangles; front is up. Open.
DiffusionSurfaces open_sheet(double size, double height, int n = 1, const Paint& paint = {});

/// Two open sheets one above the other, at y = -gap/2 and y = +gap/2, fronts up.
DiffusionSurfaces two_plates(double size, double gap, const Paint& lower, const Paint& upper, int n = 1);

/// A skin of radius `outer` (front hidden) around an inner surface of radius `inner`, colours by `paint`s.
DiffusionSurfaces nested_spheres(double outer, double inner, int n, Paint skin = skin_paint(), Paint core = {});

/// A ball with a ball-shaped hollow: a skin (front hidden) and a cavity wall (its hollow side hidden).
DiffusionSurfaces hollow_ball(double outer, double inner, int n);

/// A torus around the y axis, front outside: `major` to the middle of the tube of radius `minor`.
DiffusionSurfaces torus(double major, double minor, int around, int along, const Paint& paint = skin_paint());

/// The surfaces, moved.
DiffusionSurfaces moved(DiffusionSurfaces surfaces, const glm::dvec3& by);

/// The surfaces, turned about the origin to a generic position (no axis stays an axis).
DiffusionSurfaces tilted(DiffusionSurfaces surfaces);

/// The surfaces inside out: every triangle is reversed and its sides exchanged, so each side in space keeps its
/// colours.
DiffusionSurfaces turned_inside_out(DiffusionSurfaces surfaces);

/// The volume between the surfaces and the origin, by the divergence theorem; exact for closed meshes.
double signed_volume(const DiffusionSurfaces& surfaces);

double area(const DiffusionSurfaces& surfaces);

}  // namespace pomona::shapes
