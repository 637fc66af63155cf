#include "render/texture/curved_regions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <queue>
#include <tuple>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr double grow_limit = 0.454;   // cosine of 63 degrees: largest angle of a region's triangles to its normal
constexpr double join_limit = 0.309;   // cosine of 72 degrees: the same for two regions that become one
constexpr double narrow_limit = 0.94;  // cosine of 20 degrees: below it, means of normals give the direction of a
                                       // region
constexpr int growths = 4;
constexpr std::int32_t none = -1;

struct Seed {
  std::uint32_t triangle = 0;
  glm::dvec3 normal{0};
};

/// The best triangle to take next; ties go to the lower seed, then the lower triangle.
struct Offer {
  double error = 0;
  std::int32_t seed = 0;
  std::uint32_t triangle = 0;
  bool operator>(const Offer& o) const {
    return std::tie(error, seed, triangle) > std::tie(o.error, o.seed, o.triangle);
  }
};

class RegionGrowth {
 public:
  RegionGrowth(const Solid& solid, const TriangleNeighbors& neighbors, std::span<const std::uint8_t> is_curved)
      : mesh_(solid.mesh),
        neighbors_(neighbors),
        is_curved_(is_curved),
        normal_(solid.mesh.triangle.size()),
        area_(solid.mesh.triangle.size()) {
    for (std::uint32_t t = 0; t < solid.mesh.triangle.size(); ++t) {
      const glm::dvec3 twice = solid.mesh.area_vector(t);
      const double length = std::sqrt(glm::dot(twice, twice));
      area_[t] = 0.5 * length;
      normal_[t] = length > 0 ? twice / length : glm::dvec3(0);
    }
  }

  std::vector<CurvedRegion> grow() {
    std::vector<CurvedRegion> all;
    region_.assign(mesh_.triangle.size(), none);
    for (const std::vector<std::uint32_t>& component : components()) {
      for (CurvedRegion& region : grow_component(component)) all.push_back(std::move(region));
    }
    return all;
  }

 private:
  /// Triangles that are connected by edges, among those that `wanted` marks.
  template <typename Wanted>
  std::vector<std::vector<std::uint32_t>> connected(const std::vector<std::uint32_t>& among, const Wanted& wanted) {
    std::vector<std::vector<std::uint32_t>> groups;
    if (seen_.empty()) seen_.assign(mesh_.triangle.size(), 0);
    for (const std::uint32_t start : among) {
      if (seen_[start] || !wanted(start)) continue;
      std::vector<std::uint32_t> group{start};
      seen_[start] = 1;
      for (std::size_t i = 0; i < group.size(); ++i) {
        for (const std::int32_t next : neighbors_.neighbor[group[i]]) {
          if (next < 0 || seen_[next] || !wanted(static_cast<std::uint32_t>(next))) continue;
          seen_[next] = 1;
          group.push_back(static_cast<std::uint32_t>(next));
        }
      }
      std::sort(group.begin(), group.end());
      groups.push_back(std::move(group));
    }
    for (const std::uint32_t t : among) seen_[t] = 0;
    return groups;
  }

  std::vector<std::vector<std::uint32_t>> components() {
    std::vector<std::uint32_t> curved;
    for (std::uint32_t t = 0; t < mesh_.triangle.size(); ++t) {
      if (is_curved_[t]) curved.push_back(t);
    }
    return connected(curved, [](std::uint32_t) { return true; });
  }

  /// Area-weighted mean normal; its length tells how well the normals agree (1: all the same; 0: they cancel).
  glm::dvec3 mean_normal(const std::vector<std::uint32_t>& triangles) const {
    glm::dvec3 sum(0);
    double area = 0;
    for (const std::uint32_t t : triangles) sum += normal_[t] * area_[t], area += area_[t];
    return area > 0 ? sum / area : glm::dvec3(0);
  }

  /// The seed is in the middle of the triangles that face the mean direction; without one, at the first triangle with
  /// an area.
  Seed seed_in(const std::vector<std::uint32_t>& triangles) const {
    glm::dvec3 toward = mean_normal(triangles);
    const double length = std::sqrt(glm::dot(toward, toward));
    if (length < 0.2) {
      const auto solid_one = std::find_if(triangles.begin(), triangles.end(), [&](auto t) { return area_[t] > 0; });
      const std::uint32_t t = solid_one == triangles.end() ? triangles.front() : *solid_one;
      return {t, area_[t] > 0 ? normal_[t] : glm::dvec3(0, 1, 0)};
    }
    toward /= length;
    std::uint32_t best = triangles.front();
    for (const std::uint32_t t : triangles) {
      if (glm::dot(normal_[t], toward) > glm::dot(normal_[best], toward)) best = t;
    }
    return {best, glm::dot(normal_[best], toward) > narrow_limit ? toward : normal_[best]};
  }

  void offer(std::uint32_t triangle, std::int32_t seed) {
    const double cosine = area_[triangle] > 0 ? glm::dot(normal_[triangle], seeds_[seed].normal) : 1.0;
    if (cosine >= grow_limit) queue_.push({1.0 - cosine, seed, triangle});
  }

  /// Grows from the seeds outwards, over triangles without a region.
  void flood(std::size_t first_seed) {
    for (std::size_t s = first_seed; s < seeds_.size(); ++s) {
      queue_.push({-1, static_cast<std::int32_t>(s), seeds_[s].triangle});
    }
    while (!queue_.empty()) {
      const Offer best = queue_.top();
      queue_.pop();
      if (region_[best.triangle] != none) continue;
      region_[best.triangle] = best.seed;
      for (const std::int32_t next : neighbors_.neighbor[best.triangle]) {
        if (next >= 0 && region_[next] == none) offer(static_cast<std::uint32_t>(next), best.seed);
      }
    }
  }

  void flood_all(const std::vector<std::uint32_t>& component) {
    for (const std::uint32_t t : component) region_[t] = none;
    flood(0);
    const auto unreached = [&](std::uint32_t t) { return region_[t] == none; };
    for (;;) {
      const auto left = connected(component, unreached);
      if (left.empty()) return;
      const std::size_t known = seeds_.size();
      for (const auto& group : left) seeds_.push_back(seed_in(group));
      flood(known);
    }
  }

  std::vector<std::vector<std::uint32_t>> members(const std::vector<std::uint32_t>& component) const {
    std::vector<std::vector<std::uint32_t>> all(seeds_.size());
    for (const std::uint32_t t : component) all[region_[t]].push_back(t);
    return all;
  }

  std::vector<CurvedRegion> grow_component(const std::vector<std::uint32_t>& component) {
    seeds_ = {seed_in(component)};
    flood_all(component);
    for (int i = 1; i < growths && seeds_.size() > 1; ++i) {
      std::vector<Seed> better;
      for (const auto& region : members(component)) {
        if (!region.empty()) better.push_back(seed_in(region));
      }
      seeds_ = std::move(better);
      flood_all(component);
    }
    return joined_regions(component);
  }

  /// The direction of a region, if all its triangles are within the limit of it.
  std::optional<glm::dvec3> common_normal(const std::vector<std::uint32_t>& triangles, double limit) const {
    const glm::dvec3 mean = mean_normal(triangles);
    const double length = std::sqrt(glm::dot(mean, mean));
    const glm::dvec3 normal = length > 0 ? mean / length : glm::dvec3(0, 1, 0);
    const auto faces_it = [&](auto t) { return area_[t] == 0 || glm::dot(normal_[t], normal) >= limit; };
    if (!std::all_of(triangles.begin(), triangles.end(), faces_it)) return {};
    return normal;
  }

  /// The neighbours of a region, the longest common border first.
  std::vector<std::int32_t> beside(const std::vector<std::uint32_t>& triangles, std::int32_t own) const {
    std::map<std::int32_t, double> border;
    for (const std::uint32_t t : triangles) {
      for (int i = 0; i < 3; ++i) {
        const std::int32_t next = neighbors_.neighbor[t][i];
        if (next < 0 || region_[next] == own) continue;
        const glm::uvec3& v = mesh_.triangle[t];
        const glm::dvec3 d = glm::dvec3(mesh_.position[v[i]]) - glm::dvec3(mesh_.position[v[(i + 1) % 3]]);
        border[region_[next]] += std::sqrt(glm::dot(d, d));
      }
    }
    std::vector<std::int32_t> order;
    for (const auto& [region, length] : border) order.push_back(region);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return border[a] > border[b]; });
    return order;
  }

  double area_of(const std::vector<std::uint32_t>& triangles) const {
    double area = 0;
    for (const std::uint32_t t : triangles) area += area_[t];
    return area;
  }

  /// Joins small regions with neighbours as long as the union can be flattened.
  std::vector<CurvedRegion> joined_regions(const std::vector<std::uint32_t>& component) {
    std::vector<std::vector<std::uint32_t>> all = members(component);
    std::vector<std::int32_t> order(all.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(i);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return area_of(all[a]) < area_of(all[b]); });
    for (const std::int32_t own : order) {
      for (const std::int32_t other : beside(all[own], own)) {
        std::vector<std::uint32_t> both;
        std::merge(all[own].begin(), all[own].end(), all[other].begin(), all[other].end(), std::back_inserter(both));
        if (!common_normal(both, join_limit)) continue;
        for (const std::uint32_t t : all[own]) region_[t] = other;
        all[other] = std::move(both);
        all[own].clear();
        break;
      }
    }
    std::vector<CurvedRegion> regions;
    for (std::vector<std::uint32_t>& triangles : all) {
      if (triangles.empty()) continue;
      // If the mean is not good enough, uses the normal around which the region grew.
      const glm::dvec3 grown_around = seeds_[region_[triangles.front()]].normal;
      const glm::dvec3 normal = common_normal(triangles, 0.1).value_or(grown_around);
      regions.push_back({std::move(triangles), normal});
    }
    return regions;
  }

  const SolidMesh& mesh_;
  const TriangleNeighbors& neighbors_;
  std::span<const std::uint8_t> is_curved_;
  std::vector<glm::dvec3> normal_;
  std::vector<double> area_;
  std::vector<std::int32_t> region_;  // per triangle: its seed
  std::vector<std::uint8_t> seen_;
  std::vector<Seed> seeds_;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> queue_;
};

}  // namespace

std::vector<CurvedRegion> curved_regions(const Solid& solid, const TriangleNeighbors& neighbors,
                                         std::span<const std::uint8_t> is_curved) {
  return RegionGrowth(solid, neighbors, is_curved).grow();
}

}  // namespace pomona
