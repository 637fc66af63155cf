#include "generator/variation/swept_check.h"

#include <algorithm>
#include <utility>

#include "generator/base/reproducible.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/unpainted.h"

namespace pomona {

namespace {

/// Of the triangle's middle, about the axis; from +X towards -Z.
double azimuth_of(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  glm::dvec3 sum(0);
  for (int i = 0; i < 3; ++i) sum += glm::dvec3(surfaces.position[surfaces.triangle[triangle][i]]);
  return reproducible::atan2(-sum.z, sum.x);
}

/// Swept along a straight axis: bends carry everything along, and azimuths mean folds only without them.
DiffusionSurfaces straight(Template fruit) {
  fruit.bend = {};
  return sweep(unpainted(std::move(fruit)));
}

}  // namespace

SweptCheck::SweptCheck(const Template& drawn) {
  const DiffusionSurfaces surfaces = straight(drawn);
  straight_ = as_drawn_ = kinds_of(surfaces, crossing_triangles(surfaces));
  if (drawn.bend.is_straight()) return;
  const DiffusionSurfaces bent = sweep(unpainted(drawn));
  as_drawn_ = kinds_of(bent, crossing_triangles(bent));
}

std::vector<double> SweptCheck::new_crossings(const Template& variant) const {
  const DiffusionSurfaces surfaces = straight(variant);
  std::vector<double> azimuths;
  for (const CrossingTriangles& crossing : crossing_triangles(surfaces)) {
    if (straight_.contains(kind_of(surfaces, crossing))) continue;
    azimuths.push_back(azimuth_of(surfaces, crossing.first));
    azimuths.push_back(azimuth_of(surfaces, crossing.second));
  }
  return azimuths;
}

bool SweptCheck::crosses_anew(const Template& variant) const {
  const DiffusionSurfaces surfaces = sweep(unpainted(variant));
  const std::set<CrossingKind> kinds = kinds_of(surfaces, crossing_triangles(surfaces));
  return !std::includes(as_drawn_.begin(), as_drawn_.end(), kinds.begin(), kinds.end());
}

}  // namespace pomona
