#include "generator/diffusion/harmonic/cell_triangles.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "tests/diffusion/harmonic/whole_cells.h"
#include "tests/diffusion/harmonic/whole_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

struct Scene {
  DiffusionSurfaces surfaces =
      joined(shapes::tilted(shapes::sphere(0.7, 3)), shapes::moved(shapes::torus(0.3, 0.1, 9, 7), {0.05, 0.02, 0.01}));
  Lattice lattice = lattice_around(surfaces, 0.09, 1, 3, glm::dvec3(0.3, 0.5, 0.9));
  SnappedSurfaces snapped = pomona::snapped(surfaces, lattice);
};

std::size_t index_of(const Lattice& lattice, const glm::ivec3& cell) {
  return static_cast<std::size_t>((cell.z * lattice.count[1] + cell.y) * lattice.count[0] + cell.x);
}

glm::dvec3 corner_of(const DiffusionSurfaces& surfaces, std::size_t t, int k) {
  return glm::dvec3(surfaces.position[surfaces.triangle[t][k]]);
}

TEST(SparseSet, KnowsThePlaceOfEachAmongThoseAdded) {
  const RandomStream random({}, "tests/sparse sets");
  SparseSet set(1000), part(300);
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < 1000; ++i) {
    if (random.uniform(i) > 0.3) continue;
    members.push_back(i);
    if (i >= 77 && i < 377) {
      part.add(i - 77);
    } else {
      set.add(i);
    }
  }
  set.add_all(part, 77);
  EXPECT_EQ(set.count(), members.size());
  for (std::size_t place = 0; place < members.size(); ++place) {
    EXPECT_TRUE(set.holds(members[place]));
    EXPECT_EQ(set.place(members[place]), place);
  }
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(set.holds(i), std::binary_search(members.begin(), members.end(), i));
}

TEST(CellTriangles, HoldEveryTriangleThatMeetsTheCell) {
  const Scene scene;
  const RandomStream random({}, "tests/places on triangles");
  std::uint64_t n = 0;
  for (const double margin : {0.0, 0.1}) {
    const CellTriangles cells = cell_triangles(scene.snapped, scene.lattice, margin, {2});
    for (std::uint32_t t = 0; t < scene.surfaces.triangle_count(); ++t) {
      for (int i = 0; i < 30; ++i, n += 3) {
        double v = random.uniform(n), w = random.uniform(n + 1);
        if (v + w > 1) v = 1 - v, w = 1 - w;
        glm::dvec3 p = (1 - v - w) * corner_of(scene.surfaces, t, 0) + v * corner_of(scene.surfaces, t, 1) +
                       w * corner_of(scene.surfaces, t, 2);
        p = (p - scene.lattice.origin) / scene.lattice.spacing;
        // A cell whose margin reaches this place must hold the triangle, too.
        p[i % 3] += (random.uniform(n + 2) < 0.5 ? -0.99 : 0.99) * margin;
        const auto in = cells.in(index_of(scene.lattice, glm::ivec3(glm::floor(p))));
        EXPECT_TRUE(std::binary_search(in.begin(), in.end(), t));
      }
    }
  }
}

TEST(CellTriangles, HoldFewOthers) {
  const Scene scene;
  const CellTriangles cells = cell_triangles(scene.snapped, scene.lattice, 0, {2});
  std::size_t held = 0;
  for (const Node& node : shapes::nodes_of(scene.lattice)) {
    const auto in = cells.in(index_of(scene.lattice, {node[0], node[1], node[2]}));
    EXPECT_TRUE(std::is_sorted(in.begin(), in.end()));
    held += in.size();
    const glm::dvec3 middle = shapes::place_of(scene.lattice, node) + 0.5 * scene.lattice.spacing;
    for (const std::uint32_t t : in) {
      // Both the triangle's box and its plane are within the cell's margin.
      const glm::dvec3 a = corner_of(scene.surfaces, t, 0), b = corner_of(scene.surfaces, t, 1),
                       c = corner_of(scene.surfaces, t, 2);
      const glm::dvec3 outside = glm::max(glm::min(a, glm::min(b, c)) - middle, middle - glm::max(a, glm::max(b, c)));
      EXPECT_LT(std::max({outside.x, outside.y, outside.z}), 0.501 * scene.lattice.spacing);
      const double height = glm::dot(glm::normalize(glm::cross(b - a, c - a)), middle - a);
      EXPECT_LT(std::fabs(height), 0.87 * scene.lattice.spacing);
    }
  }
  EXPECT_GT(held, scene.surfaces.triangle_count());
}

TEST(CellTriangles, AreTheSameForAnyNumberOfThreads) {
  const Scene scene;
  const CellTriangles one = cell_triangles(scene.snapped, scene.lattice, 0.01, {1}),
                      many = cell_triangles(scene.snapped, scene.lattice, 0.01, {5});
  for (const Node& node : shapes::nodes_of(scene.lattice)) {
    const std::size_t cell = index_of(scene.lattice, {node[0], node[1], node[2]});
    EXPECT_TRUE(std::ranges::equal(one.in(cell), many.in(cell)));
  }
}

}  // namespace
}  // namespace pomona
