#include "generator/cut/plane/plane_regions.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "generator/cut/section/face_patches.h"

namespace pomona {

namespace {

/// Asks the planes of all knives, one after another.
class CellFinder {
 public:
  CellFinder(const Face& face, const CutPlanes& planes, FacePatches patches)
      : face_(face), planes_(planes), patches_(std::move(patches)) {}

  Regions find() {
    Regions regions = patches_.regions();
    for (std::size_t p = 0; p < patches_.count(); ++p) {
      if (patches_.inside[p].empty()) continue;
      const std::array<std::uint32_t, 2> cells = cells_beside(p);
      if (cells[0] != cells[1]) regions.patch[p].closes.push_back({cells, std::move(patches_.inside[p])});
    }
    return regions;
  }

 private:
  /// The cells on both sides of a patch, by its side of every other plane.
  std::array<std::uint32_t, 2> cells_beside(std::size_t patch) const {
    std::array<std::uint32_t, 2> cells{0, 0};
    int plane = 0;
    for (const KnifePlanes& knife : planes_.knives) {
      std::array<KnifeSides, 2> sides{};
      for (std::size_t i = 0; i < knife.planes.size(); ++i, ++plane) {
        const CutPlanes::Plane& entry = planes_[plane];
        if (planes_.blade_of(plane).first != plane) continue;  // a stroke is seen with its first facet
        const bool own = entry.same_as == face_.plane;
        const bool positive = own ? entry.turned : lies_on_positive_side(patch, plane);
        sides[0] = knife.seen(sides[0], i, positive);
        sides[1] = knife.seen(sides[1], i, own ? !positive : positive);
      }
      for (std::size_t s = 0; s < 2; ++s) {
        cells[s] = cells[s] * static_cast<std::uint32_t>(knife.cell_count()) +
                   static_cast<std::uint32_t>(knife.cell(sides[s]));
      }
    }
    return cells;
  }

  /// No plane or stroke passes through a patch, so the vertex farthest from it tells the side.
  bool lies_on_positive_side(std::size_t patch, int plane) const {
    const CutPlanes::Blade& blade = planes_.blade_of(plane);
    double farthest = 0;
    for (const std::uint32_t t : patches_.triangle[patch]) {
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& place = face_.place[face_.corner(t, i)];
        const double d = blade.stroke ? blade.stroke->nearest(glm::dvec2(place)).distance
                                      : signed_distance(planes_[plane].plane, place);
        if (std::fabs(d) > std::fabs(farthest)) farthest = d;
      }
    }
    return farthest >= 0;
  }

  const Face& face_;
  const CutPlanes& planes_;
  FacePatches patches_;
};

}  // namespace

Regions plane_regions(const Face& face, const CutPlanes& planes, const DiffusionSurfaces& surfaces,
                      const Bodies& bodies) {
  return CellFinder(face, planes, patches_of(face, surfaces, bodies)).find();
}

}  // namespace pomona
