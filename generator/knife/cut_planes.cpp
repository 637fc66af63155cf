#include "generator/knife/cut_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"

namespace pomona {

namespace {

constexpr double max_cells = 1e4;

/// Shares of the fruit's size. A fruit's coordinates are floats, which resolve about 1e-7 of it; places are computed in
/// doubles, which resolve 1e-16. The tolerance for equal places lies between, nearer to the doubles.
constexpr double tolerance_share = 1e-10, rounding_share = 1e-13;

bool coincide(const CuttingPlane& a, const CuttingPlane& b, double tolerance) {
  const double sense = glm::dot(a.normal, b.normal) < 0 ? -1 : 1;
  return glm::length(glm::cross(a.normal, b.normal)) < 1e-12 && std::fabs(a.offset - sense * b.offset) <= tolerance;
}

/// The blade that begins with this plane, or none: only the first facet of a stroke begins one. `number`: index of the
/// plane among those of all knives.
std::optional<CutPlanes::Blade> blade_begun(const KnifePlanes& knife, std::size_t in_knife, int number) {
  if (knife.strokes.empty()) return CutPlanes::Blade{number, 1, std::nullopt};
  std::size_t first = 0;
  for (const std::vector<glm::dvec2>& points : knife.strokes) {
    const std::size_t facets = points.size() - 1;
    if (in_knife == first) return CutPlanes::Blade{number, static_cast<int>(facets), Stroke(points)};
    first += facets;
  }
  return std::nullopt;
}

}  // namespace

const Stroke::Facet* CutPlanes::facet(int plane) const {
  const Blade& blade = blade_of(plane);
  return blade.stroke ? &blade.stroke->facet(plane - blade.first) : nullptr;
}

bool CutPlanes::is_in_facet(int plane, const glm::dvec3& place) const {
  const Stroke::Facet* f = facet(plane);
  if (f == nullptr) return true;
  const double along = f->along_of(glm::dvec2(place));
  return along >= f->from - tolerance && along <= f->to + tolerance;
}

namespace {

/// \throws Error (usage) if the knives together make too many cells.
std::vector<KnifePlanes> laid(std::span<const Knife> knives, const Box<double>& bounds) {
  std::vector<KnifePlanes> all;
  double cells = 1;
  for (const Knife& knife : knives) {
    all.push_back(planes_of(knife, bounds));
    cells *= all.back().cell_count();
    if (cells > max_cells) {
      throw Error(ExitStatus::usage, "the knives together make more than ten thousand cells",
                  "take larger pieces, or fewer knives");
    }
  }
  return all;
}

/// The first plane of an earlier knife that coincides with this one, which comes next, or null.
/// \throws Error (usage) where one of the two is a facet of a stroke.
const CutPlanes::Plane* earlier_same(const CutPlanes& all, const CutPlanes::Plane& plane) {
  const auto same = std::find_if(all.planes.begin(), all.planes.end(), [&](const CutPlanes::Plane& earlier) {
    return earlier.knife != plane.knife && coincide(earlier.plane, plane.plane, all.tolerance);
  });
  if (same == all.planes.end()) return nullptr;
  const KnifePlanes& knife = all.knives[static_cast<std::size_t>(plane.knife)];
  if (knife.strokes.empty() && !all.blade_of(same->same_as).stroke) return &*same;
  throw Error(ExitStatus::usage, "knife \"" + knife.text + "\" runs along knife \"" +
                                     all.knives[static_cast<std::size_t>(same->knife)].text +
                                     "\" for a stretch: move one of them");
}

}  // namespace

CutPlanes cut_planes(std::span<const Knife> knives, const Box<double>& bounds) {
  CutPlanes all;
  all.tolerance = tolerance_share * glm::length(bounds.size());
  const double farthest = std::fmax(glm::length(bounds.low), glm::length(bounds.high));
  all.rounding = rounding_share * farthest;
  all.knives = laid(knives, bounds);
  for (std::size_t k = 0; k < all.knives.size(); ++k) {
    const KnifePlanes& knife = all.knives[k];
    for (std::size_t i = 0; i < knife.planes.size(); ++i) {
      CutPlanes::Plane entry{knife.planes[i], static_cast<int>(k), i, all.count(), false, false, 0};
      entry.through_axis = entry.plane.normal.y == 0 && entry.plane.offset == 0 && knife.strokes.empty();

      // Facets of a stroke share the blade that its first one began.
      if (std::optional<CutPlanes::Blade> blade = blade_begun(knife, i, all.count())) {
        all.blades.push_back(std::move(*blade));
      }
      entry.blade = static_cast<int>(all.blades.size()) - 1;

      if (const CutPlanes::Plane* same = earlier_same(all, entry)) {
        entry.same_as = same->same_as;
        entry.turned = glm::dot(all[same->same_as].plane.normal, entry.plane.normal) < 0;
      }
      all.planes.push_back(entry);
    }
  }
  return all;
}

double signed_distance(const CuttingPlane& plane, const glm::dvec3& point) {
  return glm::dot(plane.normal, point) - plane.offset;
}

glm::dvec3 snapped_to_planes(glm::dvec3 point, const std::vector<int>& on, const CutPlanes& planes) {
  int through_axis = 0;
  for (const int k : on) {
    const CuttingPlane& plane = planes[k].plane;
    if (planes[k].through_axis) ++through_axis;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fabs(plane.normal[axis]) == 1) point[axis] = plane.normal[axis] * plane.offset;
    }
  }
  if (through_axis >= 2) point.x = point.z = 0;
  return point;
}

PlaneSets::PlaneSets(const CutPlanes& planes) {
  for (int k = 0; k < planes.count(); ++k) {
    if (planes[k].through_axis && planes[k].same_as == k) axis_planes_.push_back(k);
  }
}

std::uint32_t PlaneSets::number_of(std::vector<int> set) {
  const auto [entry, is_new] = numbers_.try_emplace(set, static_cast<std::uint32_t>(sets_.size()));
  if (is_new) sets_.push_back(std::move(set));
  return entry->second;
}

std::uint32_t PlaneSets::with(std::uint32_t set, int plane) {
  if (has(set, plane)) return set;
  std::vector<int> larger = sets_[set];
  larger.insert(std::upper_bound(larger.begin(), larger.end(), plane), plane);

  // Two planes through the axis meet in it, so the point lies on all of them.
  std::vector<int> on_axis;
  std::set_intersection(larger.begin(), larger.end(), axis_planes_.begin(), axis_planes_.end(),
                        std::back_inserter(on_axis));
  if (on_axis.size() >= 2) {
    std::vector<int> all;
    std::set_union(larger.begin(), larger.end(), axis_planes_.begin(), axis_planes_.end(), std::back_inserter(all));
    larger = std::move(all);
  }
  return number_of(std::move(larger));
}

std::uint32_t PlaneSets::with_alone(std::uint32_t set, int plane) {
  if (has(set, plane)) return set;
  std::vector<int> larger = sets_[set];
  larger.insert(std::upper_bound(larger.begin(), larger.end(), plane), plane);
  return number_of(std::move(larger));
}

std::uint32_t PlaneSets::common(std::uint32_t first, std::uint32_t second) {
  if (first == second) return first;
  if (first == 0 || second == 0) return 0;
  std::vector<int> both;
  std::set_intersection(sets_[first].begin(), sets_[first].end(), sets_[second].begin(), sets_[second].end(),
                        std::back_inserter(both));
  return number_of(std::move(both));
}

bool PlaneSets::has(std::uint32_t set, int plane) const {
  return set != 0 && std::binary_search(sets_[set].begin(), sets_[set].end(), plane);
}

bool PlaneSets::on_axis(std::uint32_t set) const {
  if (axis_planes_.size() < 2 || set == 0) return false;
  return has(set, axis_planes_[0]) && has(set, axis_planes_[1]);
}

}  // namespace pomona
