#include "tests/render/export/named_solids.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

namespace pomona::named {
namespace {

void add_vertex(Solid& solid, const glm::vec3& position, const glm::vec3& normal, const Color& color, int part) {
  solid.mesh.position.push_back(position);
  solid.mesh.normal.push_back(normal);
  solid.mesh.color.push_back(color);
  solid.mesh.part.push_back(part);
}

void add_triangle(Solid& solid, const glm::uvec3& triangle, int cut_face) {
  solid.mesh.triangle.push_back(triangle);
  solid.mesh.cut_face.push_back(cut_face);
  solid.mesh.surface.push_back(cut_face >= 0 ? -1 : 0);
}

Solid named(const std::string& name) {
  Solid solid;
  solid.name = name;
  solid.own_look().part_names = {"skin", "flesh"};
  return solid;
}

/// One face of an octahedron in n^2 triangles, projected onto a sphere.
void add_octant(Solid& solid, const std::array<glm::vec3, 3>& corner, float radius, int n, const Color& color) {
  const auto first = static_cast<std::uint32_t>(solid.mesh.position.size());
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n - i; ++j) {
      // Use whole numbers first, so that neighbouring octants agree to the bit where they meet.
      const glm::vec3 whole = corner[0] * static_cast<float>(n - i - j) + corner[1] * static_cast<float>(i) +
                              corner[2] * static_cast<float>(j);
      const glm::vec3 direction = glm::normalize(whole) + 0.0f;
      add_vertex(solid, radius * direction, direction, color, 0);
    }
  }
  const auto index = [&](int i, int j) {
    return first + static_cast<std::uint32_t>(i * (n + 1) - i * (i - 1) / 2 + j);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n - i; ++j) {
      add_triangle(solid, {index(i, j), index(i + 1, j), index(i, j + 1)}, -1);
      if (j < n - i - 1) add_triangle(solid, {index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)}, -1);
    }
  }
}

}  // namespace

Solid box(const std::string& name, const glm::vec3& low, const glm::vec3& high, const Color& skin, const Color& flesh) {
  Solid solid = named(name);
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      // The face's corners run counter-clockwise seen from outside.
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      glm::vec3 normal(0);
      normal[axis] = upper ? 1.0f : -1.0f;
      const bool is_cut = axis == 1 && upper;
      const auto first = static_cast<std::uint32_t>(solid.mesh.position.size());
      for (const auto& [s, t] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        glm::vec3 p;
        p[axis] = upper ? high[axis] : low[axis];
        p[u] = (upper ? s : t) == 0 ? low[u] : high[u];
        p[v] = (upper ? t : s) == 0 ? low[v] : high[v];
        add_vertex(solid, p, normal, is_cut ? flesh : skin, is_cut ? 1 : 0);
      }
      for (const auto& [b, c] : {std::pair{1u, 2u}, {2u, 3u}})
        add_triangle(solid, {first, first + b, first + c}, is_cut ? 0 : -1);
    }
  }
  const glm::dvec3 size(high - low);
  solid.volume = size.x * size.y * size.z;
  return solid;
}

Solid ball(const std::string& name, float radius, int n, const Color& color) {
  Solid solid = named(name);
  for (const float x : {1.0f, -1.0f})
    for (const float y : {1.0f, -1.0f})
      for (const float z : {1.0f, -1.0f}) {
        std::array<glm::vec3, 3> corner{glm::vec3(x, 0, 0), glm::vec3(0, y, 0), glm::vec3(0, 0, z)};
        if (x * y * z < 0) std::swap(corner[1], corner[2]);
        add_octant(solid, corner, radius, n, color);
      }
  solid.volume = 4.18879 * radius * radius * radius;
  return solid;
}

Solid leaf(const std::string& name, const Color& color) {
  Solid solid = named(name);
  for (const glm::vec3& p : {glm::vec3(0), glm::vec3(0.05f, 0, 0), glm::vec3(0, 0, -0.05f)})
    add_vertex(solid, p, {0, 1, 0}, color, 0);
  add_triangle(solid, {0, 1, 2}, -1);
  solid.closed = false;
  return solid;
}

Scene axes_of_balls() {
  Scene scene;
  const float radius = 0.02f;
  scene.solids = {ball("grey", radius, 8, Color(0.3f)), ball("red", radius, 8, {0.7f, 0.02f, 0.02f}),
                  ball("green", radius, 8, {0.02f, 0.6f, 0.02f}), ball("blue", radius, 8, {0.02f, 0.03f, 0.7f})};
  // Each has a quarter turn about +Y: invisible on a ball, but not with a wrong matrix.
  const double half = 0.70710678118654752;
  const glm::dquat turned(half, 0, half, 0);
  scene.instances = {{0, {}, "grey"},
                     {1, {turned, {0.1, 0, 0}}, "red"},
                     {2, {turned, {0, 0.1, 0}}, "green"},
                     {3, {turned, {0, 0, 0.1}}, "blue"}};
  scene.view.eye = {0.3, 0.25, 0.4};
  scene.view.target = {0.02, 0.03, 0.02};
  scene.view.vertical_field = 0.5;
  return scene;
}

Scene with_materials() {
  Scene scene;
  scene.solids = {
      box("box", {-0.02f, 0, -0.02f}, {0.02f, 0.03f, 0.02f}, Color(0.6f, 0.1f, 0.1f), Color(0.8f, 0.5f, 0.3f))};
  MaterialSketch skin, flesh;
  skin.gloss = 0.8;
  skin.roughness = 0.12;
  skin.bloom = {.cover = 0.5};
  skin.fuzz = {.length = 0.001, .density = 0.5};
  flesh.wet = 1.8;
  flesh.translucency = {.depth = 0.004, .color = Color(1, 0.5f, 0.25f)};
  scene.solids[0].own_look().materials = {skin, flesh};
  scene.instances = {{0, {}, "box"}};
  scene.view = {.eye = {0.06, 0.08, 0.1}, .target = {0, 0.015, 0}, .vertical_field = 0.5};
  return scene;
}

Scene mixed() {
  Scene scene;
  Solid see_through = ball("see-through", 0.03f, 4, {0.9f, 0.8f, 0.1f});
  see_through.opacity = 0.25f;
  scene.solids = {box("box", {0, 0, 0}, {0.05f, 0.03f, 0.02f}, {0.8f, 0.05f, 0.05f}, {0.9f, 0.85f, 0.6f}),
                  leaf("leaf", {0.1f, 0.5f, 0.1f}), named("nothing"), see_through};
  const double half = 0.70710678118654752;
  scene.instances = {{0, {}, "box here"},
                     {0, {glm::dquat(half, half, 0, 0), {0.1, 0.02, -0.03}}, "box there"},
                     {1, {}, "leaf"},
                     {2, {}, "nothing"},
                     {3, {{1, 0, 0, 0}, {-0.1, 0, 0}}, "see-through"}};
  scene.ground = true;
  return scene;
}

Scene settled_balls() {
  Scene scene;
  constexpr float radius = 0.01f;
  for (const std::string name : {"one", "other", "copied"}) {
    scene.solids.push_back(ball(name, radius, 4, Color(0.5f)));
    scene.solids.back().origin = {.source = "cherry", .number = 1, .pieces = 1, .fruit = "cherry", .entry = "heap"};
  }
  for (int i = 0; i < 4; ++i) {
    Pose pose;
    pose.translation = {0.018 * (i % 2), 0, 0.1 * (i / 2)};
    scene.instances.push_back({std::min(i, 2), pose, "ball-" + std::to_string(i + 1)});
  }
  return scene;
}

}  // namespace pomona::named
