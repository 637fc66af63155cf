#include "generator/piece/organ_volumes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/signed_volume.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

/// An edge of an organ's triangles, from the lower point to the higher one: so many more run this way than back.
struct OrganEdge {
  std::int32_t instance = 0;
  std::uint32_t low = 0, high = 0;
  int times = 0;

  bool is_at(const OrganEdge& other) const {
    return instance == other.instance && low == other.low && high == other.high;
  }
};

/// The volumes of all organs in a mesh, by instance, but for the fruit itself.
class VolumesOfOrgans {
 public:
  explicit VolumesOfOrgans(const SolidMesh& mesh) : mesh_(mesh), first_(weld(mesh.position)) {}

  std::map<std::int32_t, OwnVolume> run() {
    for (std::size_t t = 0; t < mesh_.triangle.size(); ++t) {
      if (mesh_.instance[t] != 0) add(t);
    }
    keep_open_edges();
    for (std::size_t begin = 0, end = 0; begin < edges_.size(); begin = end) {
      while (end < edges_.size() && edges_[end].instance == edges_[begin].instance) ++end;
      close(std::span(edges_).subspan(begin, end - begin));
    }
    return std::move(own_);
  }

 private:
  glm::dvec3 at(std::uint32_t point) const {
    return glm::dvec3(mesh_.position[point]) - glm::dvec3(mesh_.position.front());
  }

  void add(std::size_t t) {
    const std::int32_t instance = mesh_.instance[t];
    const glm::uvec3& v = mesh_.triangle[t];
    const std::array<std::uint32_t, 3> p{first_[v.x], first_[v.y], first_[v.z]};
    add_to(own_[instance], at(p[0]), at(p[1]), at(p[2]), 1);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = p[k], to = p[(k + 1) % 3];
      if (from < to) edges_.push_back({instance, from, to, 1});
      if (from > to) edges_.push_back({instance, to, from, -1});
    }
  }

  /// Adds a triangle so many times; its area.
  static double add_to(OwnVolume& organ, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int times) {
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    organ.volume += times * six_volumes(a, b, c) / 6;
    organ.area += area;
    return area;
  }

  void keep_open_edges() {
    std::sort(edges_.begin(), edges_.end(), [](const OrganEdge& a, const OrganEdge& b) {
      return std::tie(a.instance, a.low, a.high) < std::tie(b.instance, b.low, b.high);
    });
    std::vector<OrganEdge> open;
    for (const OrganEdge& edge : edges_) {
      if (open.empty() || !open.back().is_at(edge)) {
        if (!open.empty() && open.back().times == 0) open.pop_back();
        open.push_back(edge);
      } else {
        open.back().times += edge.times;
      }
    }
    if (!open.empty() && open.back().times == 0) open.pop_back();
    edges_ = std::move(open);
  }

  /// Closes the holes of one organ, each by a fan around the middle of its rim.
  void close(std::span<const OrganEdge> edges) {
    std::map<std::uint32_t, std::uint32_t> number;
    for (const OrganEdge& edge : edges)
      for (const std::uint32_t p : {edge.low, edge.high})
        number.try_emplace(p, static_cast<std::uint32_t>(number.size()));
    DisjointSets rims(number.size());
    for (const OrganEdge& edge : edges) rims.join(number[edge.low], number[edge.high]);

    struct Rim {
      glm::dvec3 sum{0};
      double length = 0;
    };
    std::vector<Rim> rim(number.size());
    for (const OrganEdge& edge : edges) {
      Rim& own = rim[rims.root(number[edge.low])];
      const double length = glm::distance(at(edge.low), at(edge.high));
      own.sum += 0.5 * length * (at(edge.low) + at(edge.high));
      own.length += length;
    }
    for (const OrganEdge& edge : edges) {
      const Rim& own = rim[rims.root(number[edge.low])];
      if (!(own.length > 0)) continue;
      OwnVolume& organ = own_[edge.instance];
      organ.open += add_to(organ, at(edge.high), at(edge.low), own.sum / own.length, edge.times);
    }
  }

  const SolidMesh& mesh_;
  std::vector<std::uint32_t> first_;
  std::vector<OrganEdge> edges_;
  std::map<std::int32_t, OwnVolume> own_;
};

}  // namespace

std::map<std::int32_t, OwnVolume> organ_volumes(const SolidMesh& mesh) { return VolumesOfOrgans(mesh).run(); }

}  // namespace pomona
