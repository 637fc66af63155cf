#include "generator/surface/sweep/sheet_shells.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/sweep/body_map.h"
#include "generator/surface/sweep/grid_painter.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

namespace {

/// Six times the volume that the fronts enclose; below 0 where they face inwards.
double six_volumes(const SweptGrid& grid) {
  double sum = 0;
  for (const glm::uvec3& t : grid.triangle) {
    const auto& p = grid.position;
    sum += glm::dot(p[t.x], glm::cross(p[t.y], p[t.z]));
  }
  return sum;
}

/// The vertices of the rim, once around.
std::vector<std::uint32_t> rim_of(int around, int along) {
  std::vector<std::uint32_t> rim;
  const auto at = [&](int j, int i) { rim.push_back(static_cast<std::uint32_t>(j * around + i)); };
  for (int i = 0; i < around; ++i) at(0, i);
  for (int j = 1; j < along; ++j) at(j, around - 1);
  for (int i = around - 2; i >= 0; --i) at(along - 1, i);
  for (int j = along - 2; j >= 1; --j) at(j, 0);
  return rim;
}

/// How much of the colour veins cover: the midrib, and lines from it to the margins, fading towards the tip.
double vein_share(const SheetVeins& veins, double along, double across) {
  const double mid = across / 0.06, wave = reproducible::sin(veins.pairs * pi * (along - 0.33 * std::sqrt(across)));
  const double line = 0.55 * reproducible::exp(-wave * wave / 0.05) * std::clamp(4 * across, 0.0, 1.0) *
                      std::clamp((along - 0.1) * 6, 0.0, 1.0);
  const double vein = std::min(1.0, reproducible::exp(-mid * mid) + (veins.pairs > 0 ? line : 0));
  return veins.strength * vein * std::clamp(1.25 - along, 0.0, 1.0);
}

void paint_veins(DiffusionSurfaces& surfaces, const SheetVeins& veins, const SweptGrid& grid, std::size_t first) {
  for (std::size_t v = 0; v < grid.position.size(); ++v) {
    Color& color = surfaces.front_color[first + v];
    color = blended(color, veins.color, vein_share(veins, grid.along[v], std::fabs(2 * grid.around[v] - 1)));
  }
}

}  // namespace

SweptGrid sheet_shell(const std::vector<glm::dvec3>& lower, const std::vector<glm::dvec3>& upper, int around, int along,
                      double age) {
  SweptGrid grid;
  const auto side = static_cast<std::uint32_t>(lower.size());
  for (const std::vector<glm::dvec3>* face : {&lower, &upper}) {
    grid.position.insert(grid.position.end(), face->begin(), face->end());
    for (int j = 0; j < along; ++j) {
      for (int i = 0; i < around; ++i) {
        grid.along.push_back(static_cast<double>(j) / (along - 1));
        grid.around.push_back(static_cast<double>(i) / (around - 1));
      }
    }
  }
  grid.is_pole.assign(grid.position.size(), 0);
  grid.fold.assign(grid.position.size(), 0);
  grid.depth.assign(grid.position.size(), 1);
  grid.turn.assign(grid.position.size(), age);
  for (int j = 0; j + 1 < along; ++j) {
    for (int i = 0; i + 1 < around; ++i) {
      const auto a = static_cast<std::uint32_t>(j * around + i), b = a + 1, c = a + static_cast<std::uint32_t>(around);
      for (const glm::uvec3& t : {glm::uvec3(a, b, c + 1), glm::uvec3(a, c + 1, c)}) {
        grid.triangle.emplace_back(t.x, t.z, t.y);
        grid.triangle.push_back(t + side);
      }
    }
  }
  const std::vector<std::uint32_t> rim = rim_of(around, along);
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const std::uint32_t here = rim[k], next = rim[(k + 1) % rim.size()];
    grid.triangle.emplace_back(here, next, next + side);
    grid.triangle.emplace_back(here, next + side, here + side);
  }
  if (six_volumes(grid) < 0) {
    for (glm::uvec3& t : grid.triangle) std::swap(t.y, t.z);
  }
  return grid;
}

double age_of(const SheetSketch& sketch, int sheet) { return sketch.count > 1 ? sheet / (sketch.count - 1.0) : 0; }

namespace {

/// The azimuths of a plate's two faces at a place of its half-plane.
struct BladeFaces {
  double low = 0, high = 0;
};

/// \param u along the two curves, v from the free edge to the attached one
/// \param begins where the plate begins along the curves
BladeFaces blade_faces(const Template& fruit, const SheetSketch& sketch, int blade, double u, double v, double begins,
                       double radius, double phase) {
  const double turn = 2 * pi / sketch.count;
  const double margin = std::clamp(std::min({(u - begins) / 0.04, (1 - u) / 0.04, v / 0.1}), 0.35, 1.0);
  const double half = 0.5 * sketch.thickness(u) * margin / radius, sway = sketch.sway / radius;
  if (half + std::min(sway, 0.0) > 0.5 * turn - 0.5 * sketch.gap / radius)
    refuse_entry(fruit, "sheets", sketch.name, "they are too thick for their number", "make them thinner, or fewer");
  // All wave alike, a quarter of their distance at most; so they keep it.
  const double wave = std::min(sway, 0.25 * turn) * (1 - v) * reproducible::sin(6 * u + phase) * 0.5;
  const double room = 0.5 * turn - half - 0.5 * sketch.gap / radius;
  const double middle = turn * blade + std::clamp(wave, -room, room);
  return {middle - half, middle + half};
}

SweptGrid blade_at(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options, int blade) {
  const int across = refined(sketch.around, options.detail, 3), along = refined(sketch.along, options.detail, 3);
  const double reach = sketch.lengths[static_cast<std::size_t>(blade) % sketch.lengths.size()];
  const RandomStream random(options.key, "sheet/" + sketch.name);
  const double phase = 2 * pi * random.uniform(static_cast<std::uint64_t>(blade / 4));
  std::vector<glm::dvec3> sides[2];
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < across; ++i) {
      const double u = 1 - reach * (1 - static_cast<double>(j) / (along - 1));
      const double v = static_cast<double>(i) / (across - 1);
      const glm::dvec2 free = point_at(sketch.inner, u), at = free + v * (point_at(sketch.outer, u) - free);
      const double radius = std::max(at.x, 1e-5);
      const BladeFaces faces = blade_faces(fruit, sketch, blade, u, v, 1 - reach, radius, phase);
      for (int side = 0; side < 2; ++side) {
        const double azimuth = side == 0 ? faces.low : faces.high;
        sides[side].emplace_back(radius * reproducible::cos(azimuth), at.y, -radius * reproducible::sin(azimuth));
      }
    }
  }
  return sheet_shell(sides[0], sides[1], across, along, age_of(sketch, blade));
}

SheetShell shell_of(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options) {
  switch (sketch.kind) {
    case SheetSketch::Kind::blades:
      return blade_shell(fruit, sketch, options);
    case SheetSketch::Kind::roll:
      return roll_shell(fruit, sketch, options);
    case SheetSketch::Kind::stack:
      return stack_shell(fruit, sketch, options);
    case SheetSketch::Kind::head:
    case SheetSketch::Kind::rosette:
      break;
  }
  return leaf_shell(fruit, sketch, options);
}

}  // namespace

SheetShell blade_shell(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options) {
  return [&fruit, &sketch, options](int blade) { return blade_at(fruit, sketch, options, blade); };
}

void append_sheets(DiffusionSurfaces& surfaces, const Template& fruit, const SweepOptions& options) {
  const BodyMap map(fruit);
  for (const SheetSketch& sketch : fruit.sheets) {
    if (sketch.count == 0) continue;
    const SheetShell shell_at = shell_of(fruit, sketch, options);
    GridPainter painter(surfaces, sketch.name, sketch.front, sketch.back, Ramp<double>::constant(sketch.blur));
    for (int k = 0; k < sketch.count; ++k) {
      SweptGrid shell = shell_at(k);
      for (glm::dvec3& p : shell.position) p = map(p);
      const std::size_t first = surfaces.vertex_count();
      painter.append(shell);
      if (sketch.veins.strength > 0) paint_veins(surfaces, sketch.veins, shell, first);
    }
  }
}

}  // namespace pomona
