#include "generator/cut/section/regions.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"

namespace pomona {

namespace {

/// Finds patches, and which bodies they lie in.
class PatchFinder {
 public:
  PatchFinder(const FaceMesh& face, const DiffusionSurfaces& surfaces, const Bodies& bodies)
      : face_(face), surfaces_(surfaces), bodies_(bodies) {}

  OpenBodies find() {
    find_patches();
    find_open_bodies();
    find_windings();
    for (const std::int32_t body : open_) fill(body);
    return {std::move(open_), std::move(regions_)};
  }

 private:
  static constexpr std::uint32_t unset = 0xffffffffu;

  std::size_t triangle_count() const { return face_.mesh.triangle.size(); }

  void find_patches() {
    regions_.patch_of.assign(triangle_count(), unset);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t seed = 0; seed < triangle_count(); ++seed) {
      if (regions_.patch_of[seed] != unset) continue;
      const auto number = static_cast<std::uint32_t>(regions_.patch.size());
      regions_.patch.emplace_back();
      triangles_.emplace_back();
      regions_.patch_of[seed] = number;
      stack.push_back(seed);
      while (!stack.empty()) {
        const std::uint32_t t = stack.back();
        stack.pop_back();
        triangles_[number].push_back(t);
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int32_t other = face_.mesh.neighbor[t][i];
          if (other < 0 || face_.mesh.constrained[t][i]) continue;
          const auto o = static_cast<std::uint32_t>(other);
          if (regions_.patch_of[o] != unset) continue;
          regions_.patch_of[o] = number;
          stack.push_back(o);
        }
      }
    }
  }

  /// A boundary closes if at every vertex as many of its segments end as begin.
  void find_open_bodies() {
    struct End {
      std::int32_t body;
      std::uint32_t vertex;
      int balance;
    };
    std::vector<End> ends;
    for (const EdgeUse& use : face_.edges) {
      const std::int32_t body = bodies_.of_triangle[face_.segment[use.segment].source];
      if (body == Bodies::none) continue;
      const int to_high = begins_low(use) ? 1 : -1;
      ends.push_back({body, use.low, -to_high});
      ends.push_back({body, use.high, to_high});
    }
    std::sort(ends.begin(), ends.end(),
              [](const End& a, const End& b) { return std::tie(a.body, a.vertex) < std::tie(b.body, b.vertex); });
    for (std::size_t i = 0; i < ends.size();) {
      const End first = ends[i];
      int sum = 0;
      for (; i < ends.size() && ends[i].body == first.body && ends[i].vertex == first.vertex; ++i)
        sum += ends[i].balance;
      if (sum != 0 && (open_.empty() || open_.back() != first.body)) open_.push_back(first.body);
    }
  }

  /// True if the segment, turned so that its body lies on its left, runs from the edge's low to its high vertex.
  bool begins_low(const EdgeUse& use) const {
    const bool front_visible = surfaces_.is_hidden(face_.segment[use.segment].source, SideOf::back);
    return use.forward == front_visible;
  }

  bool is_open(std::int32_t body) const { return std::binary_search(open_.begin(), open_.end(), body); }

  /// Joins the patches that an open body's boundary leaves together, and takes those it mostly shows its inside.
  void fill(std::int32_t body) {
    const auto patches = static_cast<std::uint32_t>(regions_.patch.size());
    DisjointSets sets(patches);
    std::vector<double> visible(patches, 0);  // length of visible less that of hidden sides
    std::vector<std::uint8_t> outside(patches, 0);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t here = regions_.patch_of[t];
        const int inside_here = side_of_body(body, t, i);
        visible[here] += inside_here * face_.distance(ends_of(t, i).first, ends_of(t, i).second);
        if (face_.mesh.neighbor[t][i] < 0) outside[here] = 1;
        if (face_.mesh.neighbor[t][i] < 0 || inside_here != 0) continue;
        sets.join(here, regions_.patch_of[static_cast<std::size_t>(face_.mesh.neighbor[t][i])]);
      }
    }
    for (std::uint32_t p = 0; p < patches; ++p) {
      const std::uint32_t root = sets.root(p);
      if (root == p) continue;
      visible[root] += visible[p];
      outside[root] = outside[root] | outside[p];
    }
    for (std::uint32_t p = 0; p < patches; ++p) {
      const std::uint32_t root = sets.root(p);
      if (!outside[root] && visible[root] > 0) change(regions_.patch[p].inside, body, 1);
    }
  }

  /// Of how many of the body's segments along the edge the triangle lies inside, less those it lies outside of.
  int side_of_body(std::int32_t body, std::size_t triangle, std::size_t edge) const {
    if (!face_.mesh.constrained[triangle][edge]) return 0;
    const auto [p, q] = ends_of(triangle, edge);
    int sum = 0;
    for (const EdgeUse& use : face_.uses(p, q)) {
      if (bodies_.of_triangle[face_.segment[use.segment].source] == body) sum += begins_low(use) == (p < q) ? 1 : -1;
    }
    return sum;
  }

  std::pair<std::uint32_t, std::uint32_t> ends_of(std::size_t triangle, std::size_t edge) const {
    const glm::uvec3& corner = face_.mesh.triangle[triangle];
    return {corner[static_cast<int>(edge)], corner[static_cast<int>((edge + 1) % 3)]};
  }

  /// From patch to patch, starting outside: whoever crosses a boundary enters or leaves its body.
  void find_windings() {
    std::vector<std::uint8_t> reached(regions_.patch.size(), 0);
    std::vector<std::uint32_t> queue;
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      for (const std::int32_t other : face_.mesh.neighbor[t]) {
        const std::uint32_t p = regions_.patch_of[t];
        if (other >= 0 || reached[p]) continue;
        reached[p] = 1;
        queue.push_back(p);
      }
    }
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::uint32_t from = queue[next];
      for (const std::uint32_t t : triangles_[from]) {
        for (std::size_t i = 0; i < 3; ++i) {
          if (!face_.mesh.constrained[t][i] || face_.mesh.neighbor[t][i] < 0) continue;
          const std::uint32_t to = regions_.patch_of[static_cast<std::size_t>(face_.mesh.neighbor[t][i])];
          if (reached[to]) continue;
          reached[to] = 1;
          regions_.patch[to].inside = across(regions_.patch[from].inside, t, i);
          queue.push_back(to);
        }
      }
    }
  }

  std::vector<BodyWinding> across(std::vector<BodyWinding> inside, std::size_t triangle, std::size_t edge) const {
    const auto [p, q] = ends_of(triangle, edge);
    for (const EdgeUse& use : face_.uses(p, q)) {
      const std::int32_t body = bodies_.of_triangle[face_.segment[use.segment].source];
      if (body == Bodies::none || is_open(body)) continue;

      // The triangle lies left of the way from p to q: inside, if that is the way the segment runs.
      change(inside, body, begins_low(use) == (p < q) ? -1 : 1);
    }
    return inside;
  }

  static void change(std::vector<BodyWinding>& inside, std::int32_t body, int by) {
    const auto place = std::lower_bound(inside.begin(), inside.end(), body,
                                        [](const BodyWinding& w, std::int32_t b) { return w.body < b; });
    if (place == inside.end() || place->body != body) {
      inside.insert(place, {body, by});
    } else if ((place->winding += by) == 0) {
      inside.erase(place);
    }
  }

  const FaceMesh& face_;
  const DiffusionSurfaces& surfaces_;
  const Bodies& bodies_;
  Regions regions_;
  std::vector<std::vector<std::uint32_t>> triangles_;  // per patch
  std::vector<std::int32_t> open_;                     // bodies, ascending
};

/// Between which cells of planes and strokes a sheet's patches lie.
class CellFinder {
 public:
  CellFinder(const FaceMesh& face, const CutPlanes& planes, Regions& regions)
      : face_(face), planes_(planes), regions_(regions), triangles_(triangles_of_patches(regions)) {}

  void find() {
    for (std::size_t p = 0; p < regions_.patch.size(); ++p) {
      Regions::Patch& patch = regions_.patch[p];
      if (patch.inside.empty()) continue;
      find_cells(p);
      patch.section = patch.cell[0] != patch.cell[1];
    }
  }

 private:
  /// The sides a patch lies on of all planes, its own plane's left open.
  void find_cells(std::size_t patch) {
    regions_.patch[patch].cell = {0, 0};
    int plane = 0;
    for (const PlacedKnife& knife : planes_.knives) {
      std::array<KnifeSides, 2> sides{};
      for (std::size_t i = 0; i < knife.planes.size(); ++i, ++plane) {
        const CutPlanes::Plane& entry = planes_[plane];
        if (planes_.sheet_of(plane).first != plane) continue;  // a stroke is seen with its first facet
        const bool own = entry.same_as == face_.plane;
        const bool positive = own ? entry.turned : lies_on_positive_side(patch, plane);
        sides[0] = knife.seen(sides[0], i, positive);
        sides[1] = knife.seen(sides[1], i, own ? !positive : positive);
      }
      for (std::size_t s = 0; s < 2; ++s) {
        std::uint32_t& cell = regions_.patch[patch].cell[s];
        cell = cell * static_cast<std::uint32_t>(knife.cell_count()) + static_cast<std::uint32_t>(knife.cell(sides[s]));
      }
    }
  }

  /// No plane or stroke passes through a patch, so the vertex farthest from it tells the side.
  bool lies_on_positive_side(std::size_t patch, int plane) const {
    const CutPlanes::Sheet& sheet = planes_.sheet_of(plane);
    double farthest = 0;
    for (const std::uint32_t t : triangles_[patch]) {
      for (int i = 0; i < 3; ++i) {
        const glm::dvec3 place = face_.sheet.from_face(face_.mesh.point[face_.mesh.triangle[t][i]]);
        const double d = sheet.stroke ? sheet.stroke->nearest(glm::dvec2(place)).distance
                                      : signed_distance(planes_[plane].plane, place);
        if (std::fabs(d) > std::fabs(farthest)) farthest = d;
      }
    }
    return farthest >= 0;
  }

  const FaceMesh& face_;
  const CutPlanes& planes_;
  Regions& regions_;
  std::vector<std::vector<std::uint32_t>> triangles_;  // per patch
};

}  // namespace

OpenBodies open_bodies(const FaceMesh& face, const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  return PatchFinder(face, surfaces, bodies).find();
}

std::vector<std::vector<std::uint32_t>> triangles_of_patches(const Regions& regions) {
  std::vector<std::vector<std::uint32_t>> triangles(regions.patch.size());
  for (std::uint32_t t = 0; t < regions.patch_of.size(); ++t) triangles[regions.patch_of[t]].push_back(t);
  return triangles;
}

Regions find_regions(const FaceMesh& face, const CutPlanes& planes, const DiffusionSurfaces& surfaces,
                     const Bodies& bodies) {
  Regions regions = PatchFinder(face, surfaces, bodies).find().regions;
  CellFinder(face, planes, regions).find();
  return regions;
}

}  // namespace pomona
