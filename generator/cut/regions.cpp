#include "generator/cut/regions.h"

#include <algorithm>
#include <cmath>

namespace pomona {

namespace {

class RegionFinder {
 public:
  RegionFinder(const FaceMesh& face, const SplitMesh& mesh, const CutPlanes& planes, const DiffusionSurfaces& surfaces,
               const Bodies& bodies)
      : face_(face), mesh_(mesh), planes_(planes), surfaces_(surfaces), bodies_(bodies) {}

  Regions find() {
    find_patches();
    find_windings();
    for (std::size_t p = 0; p < regions_.patch.size(); ++p) {
      Regions::Patch& patch = regions_.patch[p];
      if (patch.inside.empty()) continue;
      find_cells(p);
      patch.section = patch.cell[0] != patch.cell[1];
    }
    return std::move(regions_);
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
    const glm::uvec3& corner = face_.mesh.triangle[triangle];
    const std::uint32_t p = corner[static_cast<int>(edge)], q = corner[static_cast<int>((edge + 1) % 3)];
    for (const EdgeUse& use : face_.uses(p, q)) {
      const std::uint32_t source = face_.segment[use.segment].source;
      const std::int32_t body = bodies_.of_triangle[source];
      if (body == Bodies::none) continue;

      // The triangle lies left of p q, and so does the front if the segment runs the same way.
      const bool front_here = use.forward == (p < q);
      const bool front_visible = surfaces_.is_hidden(source, SideOf::back);
      change(inside, body, front_here == front_visible ? -1 : 1);
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

  /// The sides a patch lies on of all planes, its own plane's left open.
  void find_cells(std::size_t patch) {
    regions_.patch[patch].cell = {0, 0};
    int plane = 0;
    for (const PlacedKnife& knife : planes_.knives) {
      std::array<KnifeSides, 2> sides{};
      for (std::size_t i = 0; i < knife.planes.size(); ++i, ++plane) {
        const CutPlanes::Plane& entry = planes_[plane];
        const bool own = entry.same_as == face_.plane;
        const bool positive = own ? entry.turned : lies_on_positive_side(patch, entry.plane);
        sides[0] = knife.seen(sides[0], i, positive);
        sides[1] = knife.seen(sides[1], i, own ? !positive : positive);
      }
      for (std::size_t s = 0; s < 2; ++s) {
        std::uint32_t& cell = regions_.patch[patch].cell[s];
        cell = cell * static_cast<std::uint32_t>(knife.cell_count()) + static_cast<std::uint32_t>(knife.cell(sides[s]));
      }
    }
  }

  /// No plane passes through a patch, so the vertex farthest from it tells the side.
  bool lies_on_positive_side(std::size_t patch, const CuttingPlane& plane) const {
    double farthest = 0;
    for (const std::uint32_t t : triangles_[patch]) {
      for (int i = 0; i < 3; ++i) {
        const double d = signed_distance(plane, mesh_.point[face_.point[face_.mesh.triangle[t][i]]]);
        if (std::fabs(d) > std::fabs(farthest)) farthest = d;
      }
    }
    return farthest >= 0;
  }

  const FaceMesh& face_;
  const SplitMesh& mesh_;
  const CutPlanes& planes_;
  const DiffusionSurfaces& surfaces_;
  const Bodies& bodies_;
  Regions regions_;
  std::vector<std::vector<std::uint32_t>> triangles_;  // per patch
};

}  // namespace

Regions find_regions(const FaceMesh& face, const SplitMesh& mesh, const CutPlanes& planes,
                     const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  return RegionFinder(face, mesh, planes, surfaces, bodies).find();
}

}  // namespace pomona
