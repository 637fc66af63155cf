#include "generator/surface/part_regions.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/signed_volume.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

class RegionFinder {
 public:
  explicit RegionFinder(const DiffusionSurfaces& surfaces)
      : surfaces_(surfaces), triangles_(welded_triangles(weld(surfaces.position), surfaces.triangle)) {}

  PartRegions find() {
    regions_.position = surfaces_.position;
    regions_.part_names = surfaces_.part_names;
    for (const std::vector<std::uint32_t>& hull : hulls()) add(hull);
    std::stable_sort(regions_.region.begin(), regions_.region.end(),
                     [](const auto& a, const auto& b) { return a.volume < b.volume; });
    return std::move(regions_);
  }

 private:
  /// Groups that may bound a region together: all triangles to the air; else each surface by itself.
  std::vector<std::int32_t> kinds() const {
    std::vector<std::int32_t> kind;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      kind.push_back(surfaces_.is_boundary(t) ? -1 : surfaces_.surface[t]);
    return kind;
  }

  /// Connected sets of triangles, ordered by their first triangles.
  std::vector<std::vector<std::uint32_t>> hulls() const {
    const std::vector<std::int32_t> kind = kinds();
    DisjointSets sets(triangles_.size());
    for_each_edge(sorted_half_edges(triangles_, {.kind = kind}), [&](std::span<const HalfEdge> edge) {
      for (const HalfEdge& h : edge) sets.join(edge.front().triangle, h.triangle);
    });
    std::map<std::uint32_t, std::size_t> number;
    std::vector<std::vector<std::uint32_t>> all;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (is_collapsed(triangles_[t])) continue;
      const auto [place, is_new] = number.try_emplace(sets.root(t), all.size());
      if (is_new) all.emplace_back();
      all[place->second].push_back(t);
    }
    return all;
  }

  void add(const std::vector<std::uint32_t>& hull) {
    // Oriented to air, or to the surface's front.
    std::vector<glm::uvec3> own;
    for (const std::uint32_t t : hull) {
      own.push_back(triangles_[t]);
      if (is_air_behind(t)) std::swap(own.back().y, own.back().z);
    }
    if (!is_closed(own)) return;
    const double volume = volume_of(own);
    const bool is_boundary = surfaces_.is_boundary(hull.front());
    if (volume == 0 || (is_boundary && volume < 0)) return;
    if (volume < 0) {
      for (glm::uvec3& t : own) std::swap(t.y, t.z);
    }
    regions_.region.push_back({part_inside(hull, volume > 0), std::abs(volume), regions_.triangle.size(), own.size()});
    regions_.triangle.insert(regions_.triangle.end(), own.begin(), own.end());
  }

  bool is_air_behind(std::uint32_t t) const { return surfaces_.is_boundary(t) && surfaces_.is_hidden(t, SideOf::back); }

  double volume_of(const std::vector<glm::uvec3>& hull) const {
    const auto at = [&](std::uint32_t v) { return glm::dvec3(surfaces_.position[v]); };
    const glm::dvec3 origin = at(hull.front().x);
    return signed_volume(hull, [&](const glm::uvec3& t) -> std::array<glm::dvec3, 3> {
      return {at(t.x) - origin, at(t.y) - origin, at(t.z) - origin};
    });
  }

  std::int32_t part_inside(const std::vector<std::uint32_t>& hull, bool front_is_outside) const {
    std::map<std::int32_t, double> area;
    for (const std::uint32_t t : hull) {
      const bool shows_back = is_air_behind(t) != front_is_outside;
      const glm::uvec3& c = triangles_[t];
      const glm::dvec3 a(surfaces_.position[c.x]);
      area[(shows_back ? surfaces_.back_part : surfaces_.front_part)[t]] +=
          glm::length(glm::cross(glm::dvec3(surfaces_.position[c.y]) - a, glm::dvec3(surfaces_.position[c.z]) - a));
    }
    return std::max_element(area.begin(), area.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  const DiffusionSurfaces& surfaces_;
  std::vector<glm::uvec3> triangles_;
  PartRegions regions_;
};

}  // namespace

PartRegions part_regions(const DiffusionSurfaces& surfaces) { return RegionFinder(surfaces).find(); }

}  // namespace pomona
