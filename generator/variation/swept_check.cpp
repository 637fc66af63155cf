#include "generator/variation/swept_check.h"

#include <algorithm>
#include <mutex>
#include <set>
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

std::set<CrossingKind> crossing_kinds(const DiffusionSurfaces& surfaces) {
  return kinds_of(surfaces, crossing_triangles(surfaces));
}

}  // namespace

/// What crosses in the drawing, found when it is first asked for, by whichever thread.
class SweptCheck::Drawing {
 public:
  explicit Drawing(const Template& drawn) : drawn_(drawn) {}

  const std::set<CrossingKind>& straight() const {
    std::call_once(straight_once_, [&] { straight_ = crossing_kinds(pomona::straight(drawn_)); });
    return straight_;
  }

  /// Bent as it is.
  const std::set<CrossingKind>& as_drawn() const {
    if (drawn_.bend.is_straight()) return straight();
    std::call_once(bent_once_, [&] { bent_ = crossing_kinds(sweep(unpainted(drawn_))); });
    return bent_;
  }

 private:
  Template drawn_;
  mutable std::once_flag straight_once_, bent_once_;
  mutable std::set<CrossingKind> straight_, bent_;
};

SweptCheck::SweptCheck(const Template& drawn) : drawing_(std::make_shared<Drawing>(drawn)) {
  // Sweeping tells whether that can be done at all.
  straight(drawn);
}

std::vector<double> SweptCheck::new_crossings(const Template& variant) const {
  const DiffusionSurfaces surfaces = straight(variant);
  std::vector<double> azimuths;
  for (const CrossingTriangles& crossing : crossing_triangles(surfaces)) {
    if (drawing_->straight().contains(kind_of(surfaces, crossing))) continue;
    azimuths.push_back(azimuth_of(surfaces, crossing.first));
    azimuths.push_back(azimuth_of(surfaces, crossing.second));
  }
  return azimuths;
}

bool SweptCheck::crosses_anew(const Template& variant) const {
  const std::set<CrossingKind> kinds = crossing_kinds(sweep(unpainted(variant)));
  if (kinds.empty()) return false;
  const std::set<CrossingKind>& known = drawing_->as_drawn();
  return !std::includes(known.begin(), known.end(), kinds.begin(), kinds.end());
}

}  // namespace pomona
