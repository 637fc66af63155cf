// A fitted view contains everything, and no nearer view does.
#include "generator/scene/scene.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/scene/in_a_row.h"

namespace pomona {
namespace {

/// Random points in one instance that is turned and moved.
Scene cloud() {
  Solid solid;
  for (int i = 0; i < 200; ++i) {
    const auto t = static_cast<float>(i);
    solid.mesh.position.emplace_back(0.1f * std::sin(t), 0.06f + 0.05f * std::sin(1.7f * t),
                                     0.3f * std::cos(0.37f * t));
  }
  Scene scene;
  scene.solids = {solid};
  scene.instances = {
      {0, Pose{.rotation = glm::normalize(glm::dquat(1, 0.2, 0, 0)), .translation = {1, 0.1, -2}}, "cloud"}};
  scene.ground = true;
  return scene;
}

/// The filled part of the picture, -1 to 1 to the right and upwards.
struct Filled {
  glm::dvec2 low{1e9}, high{-1e9};
};

Filled filled_by(const Scene& scene, const View& view, double aspect, const std::optional<glm::dvec3>& light = {}) {
  const glm::dvec3 back = glm::normalize(view.eye - view.target);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back)), up = glm::cross(back, right);
  const double slope = std::tan(0.5 * view.vertical_field);
  Filled filled;
  const auto add = [&](const glm::dvec3& p) {
    const glm::dvec3 away = p - view.eye;
    const double depth = -glm::dot(away, back);
    EXPECT_GT(depth, 0);
    const glm::dvec2 at(glm::dot(away, right) / (depth * slope * aspect), glm::dot(away, up) / (depth * slope));
    filled.low = glm::min(filled.low, at);
    filled.high = glm::max(filled.high, at);
  };
  for (const Instance& instance : scene.instances) {
    for (const glm::vec3& own : scene.solids[0].mesh.position) {
      const glm::dvec3 p = instance.pose.rotation * glm::dvec3(own) + instance.pose.translation;
      add(p);
      if (light && p.y > 0) add(p - *light * (p.y / light->y));
    }
  }
  return filled;
}

TEST(FittedView, TouchesBothSidesOfOneDirectionAndIsCentredInTheOther) {
  const Scene scene = cloud();
  for (const glm::dvec3& direction : {glm::dvec3(0, 1, 0.75), glm::dvec3(1, 0.2, 0.3), glm::dvec3(-0.4, 0.6, -1)}) {
    for (const double aspect : {0.5, 1.0, 16.0 / 9}) {
      const View view = fitted_view(scene, direction, aspect);
      const Filled filled = filled_by(scene, view, aspect);
      const glm::dvec2 size = filled.high - filled.low;
      EXPECT_NEAR(std::max(size.x, size.y), 2 / 1.06, 1e-6);
      EXPECT_LE(std::max(filled.high.x, filled.high.y), 1 / 1.06 + 1e-6);
      EXPECT_GE(std::min(filled.low.x, filled.low.y), -1 / 1.06 - 1e-6);
      EXPECT_LT(glm::length(glm::normalize(view.eye - view.target) - glm::normalize(direction)), 1e-9);
    }
  }
}

TEST(FittedView, HasRoomForShadows) {
  const Scene scene = cloud();
  const glm::dvec3 direction(0, 1, 0.75), light = glm::normalize(glm::dvec3(-1, 0.25, 0.2));
  const View without = fitted_view(scene, direction, 1.5), with = fitted_view(scene, direction, 1.5, light);
  EXPECT_GT(filled_by(scene, without, 1.5, light).high.x, 1) << "the shadow falls out of the picture";
  const Filled filled = filled_by(scene, with, 1.5, light);
  EXPECT_LE(std::max(filled.high.x, filled.high.y), 1 / 1.06 + 1e-6);
  Scene in_air = scene;
  in_air.ground = false;
  EXPECT_EQ(fitted_view(in_air, direction, 1.5, light).eye, without.eye);
}

TEST(FittedView, OfNothingIsSomeView) {
  const View view = fitted_view(Scene{}, {0, 1, 1});
  EXPECT_NE(view.eye, view.target);
}

/// A box of this size about the origin.
Solid box(const std::string& name, const glm::vec3& size) {
  Solid solid;
  solid.name = name;
  for (const float x : {-0.5f, 0.5f}) {
    for (const float y : {-0.5f, 0.5f}) {
      for (const float z : {-0.5f, 0.5f}) solid.mesh.position.emplace_back(size * glm::vec3(x, y, z));
    }
  }
  return solid;
}

TEST(InARow, StandsSideBySideOnTheGroundAtOneScale) {
  const std::vector<glm::vec3> sizes{{0.1f, 0.2f, 0.1f}, {0.05f, 0.05f, 0.3f}, {0.2f, 0.1f, 0.1f}};
  std::vector<Solid> solids;
  for (const glm::vec3& size : sizes) solids.push_back(box("box-" + std::to_string(solids.size()), size));
  const Scene row = in_a_row(solids);
  ASSERT_EQ(row.instances.size(), sizes.size());
  EXPECT_TRUE(row.ground);
  double before = -1;
  for (const Instance& instance : row.instances) {
    const Solid& solid = row.solids[static_cast<std::size_t>(instance.solid)];
    glm::dvec3 low(1e9), high(-1e9);
    for (const glm::vec3& p : solid.mesh.position) {
      const glm::dvec3 placed = instance.pose.rotation * glm::dvec3(p) + instance.pose.translation;
      low = glm::min(low, placed);
      high = glm::max(high, placed);
    }
    EXPECT_NEAR(low.y, 0, 1e-9) << solid.name;
    EXPECT_NEAR(low.z + high.z, 0, 1e-9) << solid.name;
    EXPECT_GT(low.x, before) << solid.name;
    before = high.x;
  }
}

}  // namespace
}  // namespace pomona
