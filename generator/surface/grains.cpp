#include "generator/surface/grains.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/dart_throwing.h"
#include "generator/surface/grid_painter.h"
#include "generator/surface/section_loop.h"
#include "generator/surface/swept_grid.h"

namespace pomona {

namespace {

constexpr double most_grains = 20'000;

[[noreturn]] void refuse(const Template& fruit, const GrainSketch& sketch, const std::string& why,
                         const std::string& hint) {
  SourcePlace place;
  place.file = fruit.file.empty() ? fruit.name : fruit.file;
  throw Error(ExitStatus::bad_data, {{place, "grains \"" + sketch.name + "\": " + why, hint}});
}

/// The longest way across the vertical drawing.
double fruit_size(const Template& fruit) {
  double size = 0;
  for (const SurfaceSketch& sketch : fruit.surfaces) {
    if (sketch.vertical.points.empty()) continue;
    glm::dvec2 low = sketch.vertical.points.front(), high = low;
    for (const glm::dvec2& p : sketch.vertical.points) {
      low = glm::dvec2(std::min(low.x, p.x), std::min(low.y, p.y));
      high = glm::dvec2(std::max(high.x, p.x), std::max(high.y, p.y));
    }
    size = std::max(size, glm::distance(low, high));
  }
  return size;
}

/// One grain of length 2 along +Y and radius 1, its tip up: what all grains of a sketch are made of.
SweptGrid unit_grain(const GrainSketch& sketch) {
  const int around = std::max(3, sketch.around), rings = std::max(3, sketch.along);
  SweptGrid grain;
  const auto append = [&](const glm::dvec3& position, int ring, int spoke) {
    grain.position.push_back(position);
    grain.along.push_back(static_cast<double>(ring) / (rings - 1));
    grain.around.push_back(static_cast<double>(spoke) / around);
    grain.is_pole.push_back(ring == 0 || ring == rings - 1 ? 1 : 0);
  };
  append({0, -1, 0}, 0, 0);
  for (int j = 1; j + 1 < rings; ++j) {
    // A drop narrows towards its tip with the sine of half the angle from there; 0.7698 is its widest.
    const double from_tip = pi * (1 - static_cast<double>(j) / (rings - 1));
    const double drop = reproducible::sin(from_tip / 2) / 0.7698;
    const double radius = reproducible::sin(from_tip) * (1 + sketch.pointedness * (drop - 1));
    for (int i = 0; i < around; ++i) {
      const glm::dvec2 spoke = direction_of(2 * pi * i / around);
      append({radius * spoke.x, reproducible::cos(from_tip), -radius * spoke.y}, j, i);
    }
  }
  append({0, 1, 0}, rings - 1, 0);
  grain.triangle = grid_triangles({around, rings, true, true, false});
  return grain;
}

glm::dvec3 turned(const glm::dvec3& from, const glm::dvec3& towards, double angle) {
  return from * reproducible::cos(angle) + towards * reproducible::sin(angle);
}

/// The unit grain at a dart's place, with the jitter its number draws.
SweptGrid placed(SweptGrid grain, const GrainSketch& sketch, const Dart& dart, const RandomStream& random) {
  const auto draw = [&](std::uint64_t k) { return 2 * random.uniform(draws_per_candidate * dart.number + k) - 1; };
  const glm::dvec3 sideways = glm::cross(dart.normal, dart.tangent);
  const glm::dvec3 flat = turned(dart.tangent, sideways, sketch.angle_jitter * draw(3));
  const glm::dvec3 tip = turned(flat, dart.normal, sketch.tilt);
  const glm::dvec3 up = turned(dart.normal, -flat, sketch.tilt);
  const double scale = 0.5 * std::max(0.1, 1 + sketch.size_jitter * draw(4));

  // The grain's X becomes the normal and its Y the tip, so its Z must be across both.
  const glm::dvec3 x = up * (scale * sketch.thickness), y = tip * (scale * sketch.length);
  const glm::dvec3 z = glm::cross(up, tip) * (scale * sketch.width);
  for (glm::dvec3& p : grain.position) p = dart.center + x * p.x + y * p.y + z * p.z;
  return grain;
}

}  // namespace

DiffusionSurfaces scatter_grains(const Template& fruit, VariantKey key, const SweepOptions& options) {
  DiffusionSurfaces grains;
  grains.part_names = fruit.parts;
  const double size = fruit_size(fruit);
  double expected = 0;
  for (const GrainSketch& sketch : fruit.grains) {
    // Refuse what would take too long before throwing the first dart.
    if (!(sketch.poisson_radius >= 1e-3 * size)) {
      refuse(fruit, sketch, "the Poisson radius is below 1/1000 of the fruit", "make it the distance between grains");
    }
    const SurfaceSketch& surface = fruit.surfaces.at(static_cast<std::size_t>(sketch.surface));
    const std::vector<SweptGrid> grids = swept_grids(fruit, surface, options);
    // A full surface has some 0.7 grains per squared radius.
    expected += 0.7 * band_area(grids, sketch) / (sketch.poisson_radius * sketch.poisson_radius);
    if (expected > most_grains) refuse(fruit, sketch, "more than 20 000 grains", "make the Poisson radius larger");

    const RandomStream random(key, "grains/" + sketch.name);
    const SweptGrid grain = unit_grain(sketch);
    const Ramp<double> blur = Ramp<double>::constant(sketch.blur);
    GridPainter painter(grains, sketch.name, sketch.front, sketch.back, blur);
    for (const Dart& dart : thrown_darts(grids, sketch, random)) painter.append(placed(grain, sketch, dart, random));
  }
  return grains;
}

}  // namespace pomona
