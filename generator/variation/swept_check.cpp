#include "generator/variation/swept_check.h"

#include "generator/base/reproducible.h"
#include "generator/surface/sweep.h"

namespace pomona {

namespace {

/// Of the triangle's middle, about the axis; from +X towards -Z.
double azimuth_of(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  glm::dvec3 sum(0);
  for (int i = 0; i < 3; ++i) sum += glm::dvec3(surfaces.position[surfaces.triangle[triangle][i]]);
  return reproducible::atan2(-sum.z, sum.x);
}

}  // namespace

SweptCheck::SweptCheck(const Template& drawn) {
  const DiffusionSurfaces surfaces = sweep(drawn);
  drawn_ = kinds_of(surfaces, crossing_triangles(surfaces));
}

std::vector<double> SweptCheck::new_crossings(const Template& variant) const {
  const DiffusionSurfaces surfaces = sweep(variant);
  std::vector<double> azimuths;
  for (const CrossingTriangles& crossing : crossing_triangles(surfaces)) {
    if (drawn_.contains(kind_of(surfaces, crossing))) continue;
    azimuths.push_back(azimuth_of(surfaces, crossing.first));
    azimuths.push_back(azimuth_of(surfaces, crossing.second));
  }
  return azimuths;
}

}  // namespace pomona
