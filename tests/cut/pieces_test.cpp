// Volumes and moments of pieces, compared with mirror images and sums over points.
#include "generator/cut/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "generator/cut/cut.h"
#include "generator/knife/parse_knife.h"
#include "tests/cut/cut_checks.h"
#include "tests/cut/solid_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using shapes::solid_knife;
using Triangle = std::array<glm::dvec3, 3>;

/// Skin and cut faces, facing outwards.
std::vector<Triangle> triangles_of(const CutPiece& piece, const CrossSection& section) {
  std::vector<Triangle> all;
  for (const glm::uvec3& t : piece.triangle)
    all.push_back({glm::dvec3(piece.position[t.x]), glm::dvec3(piece.position[t.y]), glm::dvec3(piece.position[t.z])});
  for (const CutPiece::CapTriangle& cap : piece.caps) {
    const glm::uvec3& t = section.triangle[cap.triangle];
    Triangle corner{glm::dvec3(section.position[t.x]), glm::dvec3(section.position[t.y]),
                    glm::dvec3(section.position[t.z])};
    if (cap.reversed) std::swap(corner[1], corner[2]);
    all.push_back(corner);
  }
  return all;
}

/// The integrals of 1, of the position, and of the position times itself.
struct Moments {
  double volume = 0;
  glm::dvec3 first{0};
  glm::dmat3 second{0};
};

/// The moments, summed over the tetrahedra between triangles and the origin.
Moments moments_of(const std::vector<Triangle>& triangles) {
  Moments m;
  for (const auto& [a, b, c] : triangles) {
    const double volume = glm::dot(a, glm::cross(b, c)) / 6;
    const glm::dvec3 sum = a + b + c;
    m.volume += volume;
    m.first += volume / 4 * sum;
    m.second +=
        volume / 20 *
        (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) + glm::outerProduct(sum, sum));
  }
  return m;
}

/// The same integrals, as sums over the middles of many small cubes.
template <typename Holds>
Moments moments_by_places(const glm::dvec3& low, const glm::dvec3& high, const Holds& holds) {
  constexpr int steps = 80;
  const glm::dvec3 step = (high - low) / static_cast<double>(steps);
  const double cube = step.x * step.y * step.z;
  Moments m;
  for (int x = 0; x < steps; ++x) {
    for (int y = 0; y < steps; ++y) {
      for (int z = 0; z < steps; ++z) {
        const glm::dvec3 p = low + step * (glm::dvec3(x, y, z) + 0.5);
        if (!holds(p)) continue;
        m.volume += cube;
        m.first += cube * p;
        m.second += cube * glm::outerProduct(p, p);
      }
    }
  }
  return m;
}

/// Expects equal moments up to shares of the volume, of it times a length, and of it times a length squared, of a fruit
/// of some 6 cm.
void expect_alike(const Moments& found, const Moments& wanted, double share) {
  constexpr double length = 0.03;
  EXPECT_NEAR(found.volume / wanted.volume, 1, share);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.first[i], wanted.first[i], share * length * wanted.volume);
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(found.second[i][j], wanted.second[i][j], share * length * length * wanted.volume);
  }
}

bool is_behind_all(const ClosedSurface& convex, const glm::dvec3& p) {
  for (const glm::uvec3& t : convex.triangle) {
    const glm::dvec3 &a = convex.point[t.x], &b = convex.point[t.y], &c = convex.point[t.z];
    if (glm::dot(glm::cross(b - a, c - a), p - a) > 0) return false;
  }
  return true;
}

const glm::dvec3 low(-0.03, -0.02, -0.025), high(0.03, 0.04, 0.02);

DiffusionSurfaces box_fruit() { return shapes::box(low, high, 3, shapes::skin_paint()); }

/// Closed knives at the box: through its faces and edges, within it, on its middle planes, in generic positions.
std::vector<ClosedSurface> knives_at_box() {
  return {shapes::ball({0.02, 0.01, 0.004}, 0.02, 4), shapes::ball({0, 0.01, 0}, 0.015, 3),
          shapes::block({-0.01, -0.05, -0.01}, {0.03, 0.01, 0.02}),
          shapes::tilted(shapes::block({-0.02, -0.03, -0.02}, {0.015, 0.03, 0.04})),
          shapes::rod({0, -0.1, 0}, 0.012, 0.2, 12)};
}

TEST(Pieces, EncloseWhatIsInsideAKnifeAndWhatIsOutside) {
  for (const ClosedSurface& knife : knives_at_box()) {
    const Cut result = cut(box_fruit(), std::vector{solid_knife(knife)});
    ASSERT_EQ(result.pieces.size(), 2u);
    const Moments wanted = moments_by_places(low, high, [&](const glm::dvec3& p) { return is_behind_all(knife, p); });
    const Moments other = moments_by_places(low, high, [&](const glm::dvec3& p) { return !is_behind_all(knife, p); });
    expect_alike(moments_of(triangles_of(result.pieces[1], result.section)), wanted, 0.02);
    expect_alike(moments_of(triangles_of(result.pieces[0], result.section)), other, 0.02);
  }
}

TEST(Pieces, KnowTheirVolume) {
  for (const ClosedSurface& knife : knives_at_box()) {
    const Cut result = cut(box_fruit(), std::vector{parse_knife("half"), solid_knife(knife)});
    for (const CutPiece& piece : result.pieces)
      EXPECT_NEAR(piece.volume / moments_of(triangles_of(piece, result.section)).volume, 1, 1e-6);
  }
}

/// Planes through the middle, and closed knives whose edges and corners lie in these planes and in the box's faces: a
/// wrong answer to a tie can turn a piece inside out, while all pieces are closed and make the whole.
TEST(Pieces, AllHaveAVolumeAboveZero) {
  std::vector<Knife> knives{parse_knife("ball:24mm"), parse_knife("ball:7mm")};
  for (const ClosedSurface& surface :
       {shapes::ball({0, 0, 0}, 0.02, 2), shapes::ball({0.03, 0, 0}, 0.02, 2), shapes::ball({0, 0.03, 0}, 0.015, 1),
        shapes::ball({0.03, 0.03, 0.03}, 0.02, 2), shapes::block({0, 0, 0}, {0.03, 0.03, 0.03}),
        shapes::block({-0.015, -0.03, 0}, {0.03, 0.015, 0.015}), shapes::rod({0, -0.03, 0}, 0.015, 0.06, 8)})
    knives.push_back(solid_knife(surface));
  for (const int pieces : {1, 2}) {
    const DiffusionSurfaces box = shapes::box(glm::dvec3(-0.03), glm::dvec3(0.03), pieces, shapes::skin_paint());
    for (const char* plane : {"half", "across"}) {
      for (const Knife& knife : knives) {
        std::vector<Knife> both{parse_knife(plane), knife};
        for (int order = 0; order < 2; ++order, std::swap(both[0], both[1])) {
          const Cut result = cut(box, both);
          shapes::expect_whole(result, 0.06 * 0.06 * 0.06);
          for (const CutPiece& piece : result.pieces) EXPECT_GT(piece.volume, 0) << plane << ", " << knife.text;
        }
      }
    }
  }
}

TEST(Pieces, AreCrumbsBelowAShareOfTheWhole) {
  const double whole = 0.06 * 0.06 * 0.045;
  for (const auto& [share, is_crumb] : {std::pair{0.5e-6, true}, {0.9e-6, true}, {1.2e-6, false}, {5e-6, false}}) {
    // A corner of the box.
    const double side = std::cbrt(share * whole);
    const Cut result = cut(box_fruit(), std::vector{solid_knife(shapes::block(high - side, high + 0.01))});
    ASSERT_EQ(result.pieces.size(), 2u);
    EXPECT_FALSE(result.pieces[0].crumb);
    EXPECT_NEAR(result.pieces[1].volume / whole / share, 1, 0.01);
    EXPECT_EQ(result.pieces[1].crumb, is_crumb) << share;
  }
}

DiffusionSurfaces mirrored(DiffusionSurfaces surfaces, int axis) {
  for (glm::vec3& p : surfaces.position) p[axis] = -p[axis];
  for (glm::uvec3& t : surfaces.triangle) std::swap(t.y, t.z);
  return surfaces;
}

ClosedSurface mirrored(ClosedSurface surface, int axis) {
  for (glm::dvec3& p : surface.point) p[axis] = -p[axis];
  for (glm::uvec3& t : surface.triangle) std::swap(t.y, t.z);
  return surface;
}

std::vector<double> volumes_of(const Cut& cut) {
  std::vector<double> volumes;
  for (const CutPiece& piece : cut.pieces) volumes.push_back(piece.volume);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

/// In a mirror image ties are decided differently; volumes stay the same.
TEST(Pieces, OfAMirrorImageAreAsLarge) {
  const std::vector<ClosedSurface> all = knives_at_box();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ClosedSurface &one = all[i], &two = all[(i + 1) % all.size()];
    const std::vector<double> volumes = volumes_of(cut(box_fruit(), std::vector{solid_knife(one), solid_knife(two)}));
    const int axis = static_cast<int>(i % 3);
    const std::vector<double> mirror = volumes_of(cut(
        mirrored(box_fruit(), axis), std::vector{solid_knife(mirrored(one, axis)), solid_knife(mirrored(two, axis))}));
    ASSERT_EQ(mirror.size(), volumes.size()) << i << ", axis " << axis;
    for (std::size_t k = 0; k < volumes.size(); ++k) EXPECT_NEAR(mirror[k], volumes[k], 1e-11);
  }
}

}  // namespace
}  // namespace pomona
