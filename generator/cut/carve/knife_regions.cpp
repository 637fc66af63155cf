#include "generator/cut/carve/knife_regions.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace pomona {

void cross(std::vector<CellBoundary>& inside, const std::vector<CellBoundary>& boundary, int times) {
  for (const CellBoundary& b : boundary) {
    const auto place =
        std::lower_bound(inside.begin(), inside.end(), b, [](const CellBoundary& x, const CellBoundary& y) {
          return std::tie(x.cell, x.body) < std::tie(y.cell, y.body);
        });
    if (place == inside.end() || place->cell != b.cell || place->body != b.body) {
      inside.insert(place, {b.cell, b.body, times * b.winding});
    } else if ((place->winding += times * b.winding) == 0) {
      inside.erase(place);
    }
  }
}

namespace {

using Way = std::pair<std::uint32_t, std::uint32_t>;

class KnifeRegions {
 public:
  KnifeRegions(const FaceMesh& face, const KnifeTraces& traces, std::uint32_t stride, std::vector<std::int32_t> open)
      : face_(face), stride_(stride), open_(std::move(open)) {
    for (const KnifeEdge& e : traces.edges) edges_[std::minmax(e.from, e.to)].push_back(&e);
  }

  Regions find(Regions regions, const FirstWindings& first) {
    regions_ = std::move(regions);
    inside_.resize(regions_.patch.size());
    triangles_ = triangles_of_patches(regions_);
    std::vector<std::uint8_t> reached(regions_.patch.size(), 0);
    for (std::uint32_t t = 0; t < regions_.patch_of.size(); ++t) {
      if (reached[regions_.patch_of[t]]) continue;
      KnownWindings known = first(t);
      const std::uint32_t patch = regions_.patch_of[known.triangle];
      inside_[patch] = std::move(known.inside);
      spread(patch, reached);
    }
    for (std::uint32_t p = 0; p < regions_.patch.size(); ++p) close(p);
    return std::move(regions_);
  }

 private:
  void spread(std::uint32_t start, std::vector<std::uint8_t>& reached) {
    std::vector<std::uint32_t> queue{start};
    reached[start] = 1;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::uint32_t from = queue[next];
      for (const std::uint32_t t : triangles_[from]) {
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int32_t other = face_.mesh.neighbor[t][i];
          if (other < 0) continue;
          const std::uint32_t to = regions_.patch_of[static_cast<std::size_t>(other)];
          if (reached[to]) continue;
          reached[to] = 1;
          inside_[to] = inside_[from];
          for (const auto& [edge, times] : along(t, i)) cross(inside_[to], edge->boundary, times);
          queue.push_back(to);
        }
      }
    }
  }

  /// What passes through an edge of a triangle, and how often one comes from before it to behind on leaving the
  /// triangle, which lies left of its edges.
  std::vector<std::pair<const KnifeEdge*, int>> along(std::size_t triangle, std::size_t edge) const {
    const glm::uvec3& t = face_.mesh.triangle[triangle];
    const std::uint32_t from = face_.point[t[static_cast<int>(edge)]],
                        to = face_.point[t[static_cast<int>((edge + 1) % 3)]];
    std::vector<std::pair<const KnifeEdge*, int>> all;
    const auto found = edges_.find(std::minmax(from, to));
    if (found == edges_.end()) return all;
    for (const KnifeEdge* e : found->second) all.emplace_back(e, e->from == from ? 1 : -1);
    return all;
  }

  bool is_open(std::int32_t body) const { return std::binary_search(open_.begin(), open_.end(), body); }

  /// Cell by cell; in nearly all patches there is one.
  void close(std::uint32_t number) {
    Regions::Patch& patch = regions_.patch[number];
    std::map<std::uint32_t, std::vector<BodyWinding>> in_cell;
    for (const CellBoundary& b : inside_[number]) {
      if (!is_open(b.body)) in_cell[b.cell].push_back({b.body, b.winding});
    }
    std::vector<BodyWinding> open;
    std::copy_if(patch.inside.begin(), patch.inside.end(), std::back_inserter(open),
                 [&](const BodyWinding& w) { return is_open(w.body); });
    if (!open.empty()) {
      std::vector<BodyWinding>& all = in_cell[in_cell.empty() ? cell_beside(number) : in_cell.begin()->first];
      all.insert(all.end(), open.begin(), open.end());
      std::sort(all.begin(), all.end(), [](const BodyWinding& a, const BodyWinding& b) { return a.body < b.body; });
    }
    patch.inside.clear();
    for (auto& [cell, inside] : in_cell) {
      const std::array<std::uint32_t, 2> sides{cell + stride_, cell};
      if (patch.section) {
        patch.also.push_back({sides, std::move(inside)});
        continue;
      }
      patch.section = true;
      patch.cell = sides;
      patch.inside = std::move(inside);
    }
  }

  /// The cell behind the longest boundary of an open body.
  std::uint32_t cell_beside(std::uint32_t patch) const {
    std::map<std::uint32_t, double> length;
    for (const std::uint32_t t : triangles_[patch]) {
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::uvec3& c = face_.mesh.triangle[t];
        for (const auto& [edge, times] : along(t, i)) {
          for (const CellBoundary& b : edge->boundary) {
            if (times * b.winding < 0)
              length[b.cell] += face_.distance(c[static_cast<int>(i)], c[static_cast<int>((i + 1) % 3)]);
          }
        }
      }
    }
    const auto longest = std::max_element(length.begin(), length.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    return longest == length.end() ? 0 : longest->first;
  }

  const FaceMesh& face_;
  std::uint32_t stride_;
  std::vector<std::int32_t> open_;
  std::map<Way, std::vector<const KnifeEdge*>> edges_;
  Regions regions_;
  std::vector<std::vector<CellBoundary>> inside_;      // per patch
  std::vector<std::vector<std::uint32_t>> triangles_;  // per patch
};

}  // namespace

Regions knife_regions(const FaceMesh& face, const KnifeTraces& traces, std::uint32_t stride,
                      const DiffusionSurfaces& surfaces, const Bodies& bodies, const FirstWindings& first) {
  OpenBodies open = open_bodies(face, surfaces, bodies);
  return KnifeRegions(face, traces, stride, std::move(open.body)).find(std::move(open.regions), first);
}

}  // namespace pomona
