// The mesh of a closed knife: welded, shaded, parted at creases, and refined without a change of shape.
#include "generator/knife/knife_mesh.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/knife/solid_of_revolution.h"
#include "tests/knife/closed_surface_checks.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

ClosedSurface ball(double radius) { return revolved(half_circle(radius, 1e-4 * radius), {.tolerance = 1e-4 * radius}); }

/// Each face is a square of two triangles with points of its own: nothing is shared before welding.
ClosedSurface loose_box(const glm::dvec3& low, const glm::dvec3& high) {
  const DiffusionSurfaces box = shapes::box(low, high);
  ClosedSurface surface;
  for (const glm::uvec3& t : box.triangle) {
    const auto first = static_cast<std::uint32_t>(surface.point.size());
    for (int i = 0; i < 3; ++i) surface.point.emplace_back(box.position[t[i]]);
    surface.triangle.emplace_back(first, first + 1, first + 2);
  }
  return surface;
}

ClosedSurface as_surface(const KnifeMesh& mesh) {
  ClosedSurface surface{mesh.point, {}};
  for (const KnifeMesh::Triangle& t : mesh.triangle)
    surface.triangle.emplace_back(t.corner[0], t.corner[1], t.corner[2]);
  return surface;
}

glm::dvec3 normal_of(const KnifeMesh& mesh, std::size_t t) {
  const auto [a, b, c] = mesh.corners(t);
  return glm::normalize(glm::cross(b - a, c - a));
}

TEST(KnifeMesh, WeldsWhatLiesAtOnePlace) {
  const KnifeMesh mesh = knife_mesh(loose_box({0, 0, 0}, {1, 2, 3}), "box");
  EXPECT_EQ(mesh.point.size(), 8u);
  EXPECT_TRUE(is_closed(as_surface(mesh)));
  EXPECT_NEAR(volume_of(as_surface(mesh)), 6, 1e-12);
}

TEST(KnifeMesh, NormalsOfABallAreUnitAndPointOutside) {
  const KnifeMesh mesh = knife_mesh(ball(0.03), "ball");
  EXPECT_EQ(mesh.faces, 1u);
  for (const KnifeMesh::Triangle& t : mesh.triangle) {
    for (int i = 0; i < 3; ++i) {
      const auto corner = static_cast<std::size_t>(i);
      EXPECT_NEAR(glm::length(t.normal[corner]), 1, 1e-12);
      EXPECT_GT(glm::dot(t.normal[corner], glm::normalize(mesh.point[t.corner[corner]])), 0.999);
    }
  }
}

/// Without creases all corners at a point have one normal.
TEST(KnifeMesh, NormalsAreSharedWhereThereIsNoCrease) {
  const KnifeMesh mesh = knife_mesh(ball(0.03), "ball");
  std::vector<glm::dvec3> known(mesh.point.size(), glm::dvec3(0));
  for (const KnifeMesh::Triangle& t : mesh.triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      glm::dvec3& normal = known[t.corner[i]];
      if (normal == glm::dvec3(0)) normal = t.normal[i];
      EXPECT_EQ(normal, t.normal[i]);
    }
  }
}

TEST(KnifeMesh, ABoxHasSixFacesWithNormalsOfTheirOwn) {
  const KnifeMesh mesh = knife_mesh(loose_box({-1, 0, 0}, {1, 2, 3}), "box");
  EXPECT_EQ(mesh.faces, 6u);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    EXPECT_LT(mesh.triangle[t].face, mesh.faces);
    for (const glm::dvec3& normal : mesh.triangle[t].normal) {
      EXPECT_NEAR(glm::distance(normal, normal_of(mesh, t)), 0, 1e-12);
    }
  }
}

/// The side is round, the ends are flat.
TEST(KnifeMesh, ACylinderHasThreeFaces) {
  const KnifeMesh mesh = knife_mesh(revolved({{{0.01, 0}, {0.01, 0.05}}, false}), "cylinder");
  EXPECT_EQ(mesh.faces, 3u);
  for (const KnifeMesh::Triangle& t : mesh.triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3& n = t.normal[i];
      const bool is_end = std::fabs(n.y) > 0.5;
      EXPECT_NEAR(std::fabs(n.y), is_end ? 1 : 0, 1e-9);
      const glm::dvec3 p = mesh.point[t.corner[i]];
      if (!is_end) {
        EXPECT_NEAR(glm::dot(n, glm::normalize(glm::dvec3(p.x, 0, p.z))), 1, 1e-3);
      }
    }
  }
}

TEST(KnifeMesh, TrianglesWithoutAreaAreLeftOut) {
  ClosedSurface surface = loose_box({0, 0, 0}, {1, 1, 1});
  surface.triangle.emplace_back(0, 0, 1);
  EXPECT_EQ(knife_mesh(surface, "box").triangle.size(), 12u);
}

TEST(KnifeMesh, WhatIsNotClosedIsRefusedByName) {
  const auto message = [](const ClosedSurface& surface) -> std::string {
    try {
      knife_mesh(surface, "lid");
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_data);
      return error.what();
    }
    return "accepted";
  };
  ClosedSurface open = loose_box({0, 0, 0}, {1, 1, 1});
  open.triangle.pop_back();
  EXPECT_NE(message(open).find("\"lid\" is no closed surface"), std::string::npos);
  ClosedSurface turned = loose_box({0, 0, 0}, {1, 1, 1});
  std::swap(turned.triangle[3].x, turned.triangle[3].y);
  EXPECT_NE(message(turned).find("\"lid\" is no closed surface"), std::string::npos);
  ClosedSurface lacking = loose_box({0, 0, 0}, {1, 1, 1});
  lacking.triangle[5].z = 36;
  EXPECT_NE(message(lacking).find("\"lid\" lacks points"), std::string::npos);
}

double min_angle(const KnifeMesh& mesh) {
  double widest = -1;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const auto c = mesh.corners(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 a = glm::normalize(c[(i + 1) % 3] - c[i]), b = glm::normalize(c[(i + 2) % 3] - c[i]);
      widest = std::max(widest, glm::dot(a, b));
    }
  }
  return std::acos(widest);
}

/// Finer near one corner. No edge is too long, the surface is where it was, closed, of the same faces, and no angle is
/// less than half of the least there was [Rivara 1984].
TEST(RefinedKnife, HasEdgesAsShortAsAskedOnTheSameSurface) {
  const KnifeMesh coarse = knife_mesh(loose_box({0, 0, 0}, {1, 2, 3}), "box");
  const auto size = [](const glm::dvec3& p) { return 0.1 + 0.2 * glm::length(p); };
  const KnifeMesh fine = refined(coarse, size);
  EXPECT_GT(fine.triangle.size(), 10 * coarse.triangle.size());
  EXPECT_TRUE(is_closed(as_surface(fine)));
  EXPECT_NEAR(volume_of(as_surface(fine)), 6, 1e-12);
  EXPECT_NEAR(area_of(as_surface(fine)), 22, 1e-12);
  EXPECT_EQ(fine.faces, 6u);
  EXPECT_GE(min_angle(fine), 0.5 * min_angle(coarse));
  for (std::size_t t = 0; t < fine.triangle.size(); ++t) {
    const auto c = fine.corners(t);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LE(glm::distance(c[i], c[(i + 1) % 3]), 1.4 * size(0.5 * (c[i] + c[(i + 1) % 3])) + 1e-12);
      EXPECT_NEAR(glm::distance(fine.triangle[t].normal[i], normal_of(fine, t)), 0, 1e-12);
    }
  }
}

TEST(RefinedKnife, IsWhatItWasWhereItIsFineEnough) {
  const KnifeMesh coarse = knife_mesh(ball(0.03), "ball");
  const KnifeMesh same = refined(coarse, [](const glm::dvec3&) { return 1.0; });
  EXPECT_EQ(same.point, coarse.point);
  EXPECT_EQ(same.triangle.size(), coarse.triangle.size());
}

}  // namespace
}  // namespace pomona
