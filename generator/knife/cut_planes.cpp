#include "generator/knife/cut_planes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "generator/base/error.h"

namespace pomona {

namespace {

constexpr double most_cells = 1e4;

/// Float coordinates resolve about 1e-7 of the size, doubles 1e-16: these lie between, nearer to the doubles.
constexpr double tolerance_share = 1e-10, rounding_share = 1e-13;

bool coincide(const CuttingPlane& a, const CuttingPlane& b, double tolerance) {
  const double sense = glm::dot(a.normal, b.normal) < 0 ? -1 : 1;
  return glm::length(glm::cross(a.normal, b.normal)) < 1e-12 && std::fabs(a.offset - sense * b.offset) <= tolerance;
}

/// Adds a plane to a sheet of its own, or to that of the stroke it is a facet of.
void add_to_sheet(CutPlanes& all, CutPlanes::Plane& entry) {
  const PlacedKnife& knife = all.knives[static_cast<std::size_t>(entry.knife)];
  entry.sheet = static_cast<int>(all.sheets.size());
  if (knife.strokes.empty()) {
    all.sheets.push_back({all.count(), 1, std::nullopt});
    return;
  }
  std::size_t first = 0;
  for (const std::vector<glm::dvec2>& points : knife.strokes) {
    const std::size_t facets = points.size() - 1;
    if (entry.in_knife == first) {
      all.sheets.push_back({all.count(), static_cast<int>(facets), Stroke(points)});
      return;
    }
    if (entry.in_knife < first + facets) break;
    first += facets;
  }
  --entry.sheet;
}

}  // namespace

const Stroke::Facet* CutPlanes::facet(int plane) const {
  const Sheet& sheet = sheet_of(plane);
  return sheet.stroke ? &sheet.stroke->facet(plane - sheet.first) : nullptr;
}

bool CutPlanes::is_in_facet(int plane, const glm::dvec3& place) const {
  const Stroke::Facet* f = facet(plane);
  if (f == nullptr) return true;
  const double along = f->along_of(glm::dvec2(place));
  return along >= f->from - tolerance && along <= f->to + tolerance;
}

CutPlanes placed(std::span<const Knife> knives, const Box<double>& bounds) {
  CutPlanes all;
  all.tolerance = tolerance_share * glm::length(bounds.size());
  all.rounding = rounding_share * std::fmax(glm::length(bounds.low), glm::length(bounds.high));
  double cells = 1;
  for (const Knife& knife : knives) {
    all.knives.push_back(placed(knife, bounds));
    cells *= all.knives.back().cell_count();
    if (cells > most_cells) {
      throw Error(ExitStatus::usage, "the knives together make more than ten thousand cells",
                  "take larger pieces, or fewer knives");
    }
  }

  for (std::size_t k = 0; k < all.knives.size(); ++k) {
    for (std::size_t i = 0; i < all.knives[k].planes.size(); ++i) {
      const CuttingPlane& plane = all.knives[k].planes[i];
      CutPlanes::Plane entry{plane, static_cast<int>(k), i, all.count(), false, false, 0};
      const bool is_facet = !all.knives[k].strokes.empty();
      entry.through_axis = plane.normal.y == 0 && plane.offset == 0 && !is_facet;
      add_to_sheet(all, entry);

      // Find an earlier knife's plane that is the same.
      const auto same = std::find_if(all.planes.begin(), all.planes.end(), [&](const CutPlanes::Plane& earlier) {
        return earlier.knife != entry.knife && coincide(earlier.plane, plane, all.tolerance);
      });
      if (same != all.planes.end() && (is_facet || all.sheet_of(same->same_as).stroke)) {
        throw Error(ExitStatus::usage, "knife \"" + all.knives[k].knife.text + "\" runs along knife \"" +
                                           all.knives[static_cast<std::size_t>(same->knife)].knife.text +
                                           "\" for a stretch: move one of them");
      }
      if (same != all.planes.end()) {
        entry.same_as = same->same_as;
        entry.turned = glm::dot(all[entry.same_as].plane.normal, plane.normal) < 0;
      }
      all.planes.push_back(entry);
    }
  }
  return all;
}

double signed_distance(const CuttingPlane& plane, const glm::dvec3& point) {
  return glm::dot(plane.normal, point) - plane.offset;
}

glm::dvec3 settled(glm::dvec3 point, const std::vector<int>& on, const CutPlanes& planes) {
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

  // Two planes of the pencil: all of it.
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
