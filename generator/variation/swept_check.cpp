#include "generator/variation/swept_check.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "generator/base/reproducible.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/unpainted.h"

namespace pomona {

namespace {

/// The azimuth of the triangle's middle about the axis, from +X towards -Z.
double azimuth_of(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  glm::dvec3 sum(0);
  for (int i = 0; i < 3; ++i) sum += glm::dvec3(surfaces.position[surfaces.triangle[triangle][i]]);
  return reproducible::atan2(-sum.z, sum.x);
}

/// The swept surfaces, unpainted, without their sheets: those cross nothing but what they grow from, by construction.
DiffusionSurfaces bare(Template fruit) {
  for (SheetSketch& sheet : fruit.sheets) sheet.count = 0;
  return sweep(unpainted(std::move(fruit)));
}

/// The surfaces swept along a straight axis: only without a bend does an azimuth name a fold.
DiffusionSurfaces straight(Template fruit) {
  fruit.bend = {};
  return bare(std::move(fruit));
}

}  // namespace

/// What crosses in the drawing, straight or bent. It is searched on demand, from any thread.
class SweptCheck::KnownCrossings {
 public:
  explicit KnownCrossings(DiffusionSurfaces surfaces) : surfaces_(std::move(surfaces)) {}

  /// The kinds among `kinds` that do not cross here.
  std::set<CrossingKind> lacking(const std::set<CrossingKind>& kinds) const {
    const std::lock_guard lock(mutex_);
    std::set<CrossingKind> unknown, lacking;
    for (const CrossingKind& kind : kinds)
      if (!crosses_.contains(kind)) unknown.insert(kind);
    for (const CrossingKind& kind : crossing_kinds_of(surfaces_, unknown)) crosses_[kind] = true;
    for (const CrossingKind& kind : kinds)
      if (!crosses_.try_emplace(kind, false).first->second) lacking.insert(kind);
    return lacking;
  }

 private:
  DiffusionSurfaces surfaces_;
  mutable std::mutex mutex_;
  mutable std::map<CrossingKind, bool> crosses_;  ///< for the kinds that were asked for
};

/// The drawing without and with its bend.
class SweptCheck::Drawing {
 public:
  explicit Drawing(const Template& drawn) : drawn_(drawn), straight_(pomona::straight(drawn)) {}

  const KnownCrossings& straight() const { return straight_; }

  const KnownCrossings& as_drawn() const {
    if (drawn_.bend.is_straight()) return straight_;
    std::call_once(bent_once_, [&] { bent_.emplace(bare(drawn_)); });
    return *bent_;
  }

 private:
  Template drawn_;
  KnownCrossings straight_;
  mutable std::once_flag bent_once_;
  mutable std::optional<KnownCrossings> bent_;
};

SweptCheck::SweptCheck(const Template& drawn) : drawing_(std::make_shared<Drawing>(drawn)) {}

std::vector<double> SweptCheck::new_crossings(const Template& variant) const {
  const DiffusionSurfaces surfaces = straight(variant);
  const std::vector<CrossingTriangles> crossings = crossing_triangles(surfaces);
  const std::set<CrossingKind> anew = drawing_->straight().lacking(kinds_of(surfaces, crossings));
  std::vector<double> azimuths;
  for (const CrossingTriangles& crossing : crossings) {
    if (!anew.contains(kind_of(surfaces, crossing))) continue;
    azimuths.push_back(azimuth_of(surfaces, crossing.first));
    azimuths.push_back(azimuth_of(surfaces, crossing.second));
  }
  return azimuths;
}

bool SweptCheck::crosses_anew(const Template& variant) const {
  const std::set<CrossingKind> kinds = crossing_kinds(bare(variant));
  return !kinds.empty() && !drawing_->as_drawn().lacking(kinds).empty();
}

}  // namespace pomona
