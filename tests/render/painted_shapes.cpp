#include "tests/render/painted_shapes.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona::testing {

namespace {

constexpr int around = 96;
constexpr double radius = 0.04;

const Color red = *parse_color("#d0141c");
const Color pale = *parse_color("#f4b183");
const Color skin = *parse_color("#8e0f12");

glm::dvec2 on_circle(int i, double r) {
  const double angle = 2 * pi * i / around;
  return {r * reproducible::cos(angle), r * reproducible::sin(angle)};
}

/// One ring of vertices of the section; returns its first index.
std::uint32_t add_ring(CrossSection& section, double r, double z, const Color& color) {
  const auto begin = static_cast<std::uint32_t>(section.position.size());
  for (int i = 0; i < around; ++i) {
    const glm::dvec2 p = on_circle(i, r * (1 + 0.04 * reproducible::cos(10 * pi * i / around)));
    section.position.emplace_back(p.x, p.y, z);
    section.color.push_back(color);
    section.interior.push_back(0);
    section.part.push_back(0);
  }
  return begin;
}

void add_band(CrossSection& section, std::uint32_t inner, std::uint32_t outer, int face) {
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t j = (i + 1) % around;
    section.triangle.emplace_back(inner + i, outer + i, outer + j);
    section.triangle.emplace_back(inner + i, outer + j, inner + j);
    section.cut.insert(section.cut.end(), 2, face);
  }
}

void add_disc(CrossSection& section, int face) {
  const double z = 0.01 * face;
  CutFace plane;
  plane.knife = face;
  plane.origin = {0, 0, z};
  section.faces.push_back(plane);

  // From core to flesh in three soft rings; flesh and skin meet in two rings at the same place.
  const std::uint32_t core = add_ring(section, 0.25 * radius, z, pale);
  const std::uint32_t middle = add_ring(section, 0.55 * radius, z, glm::mix(pale, red, 0.7f));
  const std::uint32_t flesh = add_ring(section, 0.9 * radius, z, red);
  const std::uint32_t under = add_ring(section, 0.9 * radius, z, glm::mix(skin, pale, 0.7f));
  const std::uint32_t rim = add_ring(section, radius, z, skin);
  add_band(section, core, middle, face);
  add_band(section, middle, flesh, face);
  add_band(section, under, rim, face);

  // The core's fan, and the cut segments.
  const auto center = static_cast<std::uint32_t>(section.position.size());
  section.position.emplace_back(0, 0, z);
  section.color.push_back(red);
  section.interior.push_back(1);
  section.part.push_back(0);
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t j = (i + 1) % around;
    section.triangle.emplace_back(center, core + i, core + j);
    section.cut.push_back(face);
    section.segments.push_back({{flesh + i, flesh + j}, 0, false});
    section.segments.push_back({{rim + i, rim + j}, 1, true});
  }
}

/// The part of a ball at polar angles from `from` to pi (0 = +Z).
Solid ball_part(double from) {
  constexpr int rings = 48;
  Solid solid;
  solid.own_look().part_names = {"skin", "flesh"};
  for (int k = 0; k <= rings; ++k) {
    const double polar = from + (pi - from) * k / rings;
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around;
      const glm::dvec3 n(reproducible::sin(polar) * reproducible::cos(angle),
                         reproducible::sin(polar) * reproducible::sin(angle), reproducible::cos(polar));
      solid.mesh.position.emplace_back(n * radius + glm::dvec3(0, radius, 0));
      solid.mesh.normal.emplace_back(n);
      solid.mesh.color.push_back(red);
      solid.mesh.part.push_back(0);
    }
  }
  for (std::uint32_t k = 0; k < rings; ++k) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t j = (i + 1) % around, a = k * around, b = a + around;
      solid.mesh.triangle.emplace_back(a + i, b + i, b + j);
      solid.mesh.triangle.emplace_back(a + i, b + j, a + j);
      solid.mesh.cut_face.insert(solid.mesh.cut_face.end(), 2, -1);
      solid.mesh.surface.insert(solid.mesh.surface.end(), 2, 0);
    }
  }
  return solid;
}

void add_cap_ring(Solid& solid, double r, const Color& color) {
  for (int i = 0; i < around; ++i) {
    const glm::dvec2 p = on_circle(i, r);
    solid.mesh.position.emplace_back(p.x, p.y + radius, 0);
    solid.mesh.normal.emplace_back(0, 0, 1);
    solid.mesh.color.push_back(color);
    solid.mesh.part.push_back(1);
  }
}

Instance placed(int solid, const glm::dvec3& at, const glm::dquat& rotation, const std::string& name) {
  return {solid, {rotation, at - rotation * glm::dvec3(0, radius, 0)}, name};
}

}  // namespace

CrossSection disc_section(int faces) {
  CrossSection section;
  section.part_names = {"flesh"};
  section.surface_names = {"wall", "skin"};
  for (int face = 0; face < faces; ++face) add_disc(section, face);
  return section;
}

NoiseStyle some_noise(const Color& color) {
  NoiseStyle noise;
  noise.base_frequency = 150;
  noise.keys.push_back({color, {0.03, 0.03, 0.02}, {1, 0, 0}});
  return noise;
}

Solid ball() {
  Solid solid = ball_part(0);
  solid.name = "ball";
  return solid;
}

Solid half_ball() {
  Solid solid = ball_part(pi / 2);
  solid.name = "half";

  // The cap: rings from the centre to the skin, with one step of colour per band.
  constexpr int bands = 12;
  const auto base = static_cast<std::uint32_t>(solid.mesh.position.size());
  for (int k = 0; k <= bands; ++k) {
    const float t = static_cast<float>(k) / bands;
    add_cap_ring(solid, radius * (0.001 + 0.999 * t), glm::mix(pale, red, t * t));
  }
  // Its rim is the skin's, to the bit.
  for (std::uint32_t i = 0; i < around; ++i) solid.mesh.position[base + bands * around + i] = solid.mesh.position[i];
  for (std::uint32_t k = 0; k < bands; ++k) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t j = (i + 1) % around, a = base + k * around, b = a + around;
      solid.mesh.triangle.emplace_back(a + i, b + i, b + j);
      solid.mesh.triangle.emplace_back(a + i, b + j, a + j);
      solid.mesh.cut_face.insert(solid.mesh.cut_face.end(), 2, 0);
      solid.mesh.surface.insert(solid.mesh.surface.end(), 2, -1);
    }
  }
  return solid;
}

Scene ball_scene() {
  Scene scene;
  scene.solids = {ball()};
  scene.instances = {{0, {}, "ball"}};
  scene.view = {.eye = {0, radius, 0.25}, .target = {0, radius, 0}, .vertical_field = 0.5};
  return scene;
}

Scene still_life() {
  Scene scene;
  scene.solids = {ball(), half_ball()};
  scene.solids[0].own_look().noise = scene.solids[1].own_look().noise = some_noise(red);
  const double s = std::sqrt(0.5);
  const glm::dquat upwards(s, -s, 0, 0), leaning(0.9, -0.42, 0.12, 0.0);
  scene.instances.push_back(placed(0, {-0.05, 0.04, -0.02}, {1, 0, 0, 0}, "left"));
  scene.instances.push_back(placed(1, {0.045, 0.04, 0.0}, upwards, "open"));
  scene.instances.push_back(placed(1, {0.0, 0.04, 0.06}, glm::normalize(leaning), "leaning"));
  scene.instances.push_back(placed(0, {0.005, 0.095, -0.03}, {0, 1, 0, 0}, "top"));
  scene.view = {.eye = {0.1, 0.25, 0.4}, .target = {0, 0.045, 0}, .vertical_field = 0.45};
  scene.ground = true;
  return scene;
}

}  // namespace pomona::testing
