#include "generator/cut/carve/knife_regions.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "generator/cut/section/face_patches.h"
#include "generator/mesh/edge_map.h"

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

/// Walks from patch to patch over the knife's surface.
class KnifeRegions {
 public:
  KnifeRegions(const Face& face, const KnifeTraces& traces, std::uint32_t stride, FacePatches patches)
      : face_(face), stride_(stride), patches_(std::move(patches)), inside_(patches_.count()) {
    for (const KnifeEdge& e : traces.edges) edges_[{e.from, e.to}].push_back(&e);
  }

  Regions find(const FirstWindings& first) {
    std::vector<std::uint8_t> reached(patches_.count(), 0);
    for (std::uint32_t t = 0; t < patches_.patch_of.size(); ++t) {
      if (reached[patches_.patch_of[t]]) continue;
      KnownWindings known = first(t);
      const std::uint32_t patch = patches_.patch_of[known.triangle];
      inside_[patch] = std::move(known.inside);
      spread(patch, reached);
    }
    Regions regions = patches_.regions();
    for (std::uint32_t p = 0; p < patches_.count(); ++p) regions.patch[p].closes = closed_by(p);
    return regions;
  }

 private:
  void spread(std::uint32_t start, std::vector<std::uint8_t>& reached) {
    std::vector<std::uint32_t> queue{start};
    reached[start] = 1;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::uint32_t from = queue[next];
      for (const std::uint32_t t : patches_.triangle[from]) {
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int32_t other = face_.neighbor[t][i];
          if (other < 0) continue;
          const std::uint32_t to = patches_.patch_of[static_cast<std::size_t>(other)];
          if (reached[to]) continue;
          reached[to] = 1;
          inside_[to] = inside_[from];
          for (const auto& [edge, times] : along(t, i)) cross(inside_[to], edge->boundary, times);
          queue.push_back(to);
        }
      }
    }
  }

  /// The boundaries that pass through an edge of a triangle, and how often a step out of the triangle, which lies left
  /// of its edges, leads from before each to behind it.
  std::vector<std::pair<const KnifeEdge*, int>> along(std::size_t triangle, std::size_t edge) const {
    const std::uint32_t from = face_.point[face_.corner(triangle, edge)],
                        to = face_.point[face_.corner(triangle, edge + 1)];
    std::vector<std::pair<const KnifeEdge*, int>> all;
    const std::vector<const KnifeEdge*>* found = edges_.find({from, to});
    if (!found) return all;
    for (const KnifeEdge* e : *found) all.emplace_back(e, e->from == from ? 1 : -1);
    return all;
  }

  /// What a patch closes, cell by cell; in nearly all patches there is one cell.
  std::vector<Regions::Closing> closed_by(std::uint32_t patch) const {
    std::map<std::uint32_t, std::vector<BodyWinding>> in_cell;
    for (const CellBoundary& b : inside_[patch]) {
      if (!patches_.is_open(b.body)) in_cell[b.cell].push_back({b.body, b.winding});
    }

    // Open bodies have no winding numbers: the patch itself says which of them fill it.
    std::vector<BodyWinding> open;
    std::copy_if(patches_.inside[patch].begin(), patches_.inside[patch].end(), std::back_inserter(open),
                 [&](const BodyWinding& w) { return patches_.is_open(w.body); });
    if (!open.empty()) {
      std::vector<BodyWinding>& all = in_cell[in_cell.empty() ? cell_beside(patch) : in_cell.begin()->first];
      all.insert(all.end(), open.begin(), open.end());
      std::sort(all.begin(), all.end(), [](const BodyWinding& a, const BodyWinding& b) { return a.body < b.body; });
    }
    std::vector<Regions::Closing> closes;
    for (auto& [cell, inside] : in_cell) closes.push_back({{cell + stride_, cell}, std::move(inside)});
    return closes;
  }

  /// The cell behind the longest boundary of an open body.
  std::uint32_t cell_beside(std::uint32_t patch) const {
    std::map<std::uint32_t, double> length;
    for (const std::uint32_t t : patches_.triangle[patch]) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (const auto& [edge, times] : along(t, i)) {
          for (const CellBoundary& b : edge->boundary) {
            if (times * b.winding < 0) length[b.cell] += distance(face_, face_.corner(t, i), face_.corner(t, i + 1));
          }
        }
      }
    }
    const auto longest = std::max_element(length.begin(), length.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    return longest == length.end() ? 0 : longest->first;
  }

  const Face& face_;
  std::uint32_t stride_;
  FacePatches patches_;
  EdgeMap<std::vector<const KnifeEdge*>> edges_;
  std::vector<std::vector<CellBoundary>> inside_;  // per patch
};

}  // namespace

Regions knife_regions(const Face& face, const KnifeTraces& traces, std::uint32_t stride,
                      const DiffusionSurfaces& surfaces, const Bodies& bodies, const FirstWindings& first) {
  return KnifeRegions(face, traces, stride, patches_of(face, surfaces, bodies)).find(first);
}

}  // namespace pomona
