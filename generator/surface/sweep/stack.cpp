// Stacks: layers over each other, which share the room between two curves of the side view.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/clipped_normal.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/sweep/section_loop.h"
#include "generator/surface/sweep/sheet_shells.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

namespace {

/// The height of a curve that runs outwards from the axis, at a distance from it; level beyond its end.
double height_at(const Curve& curve, double radius) {
  const auto next = std::upper_bound(curve.points.begin(), curve.points.end(), radius,
                                     [](double wanted, const glm::dvec2& point) { return wanted < point.x; });
  if (next == curve.points.begin()) return curve.points.front().y;
  if (next == curve.points.end()) return curve.points.back().y;
  const glm::dvec2 &a = *(next - 1), &b = *next;
  return a.y + (radius - a.x) / (b.x - a.x) * (b.y - a.y);
}

/// What is drawn by lot for one layer.
struct LayerChance {
  double turn = 0;      ///< radians
  double size = 1;      ///< factor of the outline
  glm::dvec2 shift{0};  ///< of its middle from the axis, metres
};

/// What all layers of a stack share. The two faces of every layer are functions of the ground alone, one over the
/// other; so where a layer ends does not matter.
struct Stack {
  int around = 0, rings = 0;  ///< vertices around, and from the axis to the rim
  double reach = 0;           ///< metres: how far the outline's farthest point lies from the axis
  RandomStream random;
  double phase = 0;  ///< of its waves
  SectionLoop outline;
  std::vector<double> below;  ///< by layer: thicknesses below it, in thicknesses
};

SectionLoop outline_of(const Template& fruit, const SheetSketch& sketch, int around) {
  Curve loop = sketch.loop;
  if (loop.points.empty()) {
    constexpr int points = 360;
    for (int i = 0; i < points; ++i) loop.points.push_back(direction_of(2 * pi * i / points));
    loop.closed = true;
  }
  double farthest = 0;
  for (const glm::dvec2& p : loop.points) farthest = std::max(farthest, glm::length(p));
  try {
    return sampled_loop(loop, around, farthest);
  } catch (const BadLoop& bad) {
    refuse_entry(fruit, "sheets", sketch.name, bad.what(), bad.hint);
  }
}

Stack stack_of(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options) {
  const int around = refined(sketch.around, options.detail, 8);
  const RandomStream random(options.key, "sheet/" + sketch.name);
  Stack stack{around,
              refined(sketch.along, options.detail, 3),
              std::min(sketch.inner.points.back().x, sketch.outer.points.back().x),
              random,
              2 * pi * random.uniform(0),
              outline_of(fruit, sketch, around),
              {0}};
  for (int k = 0; k < sketch.count; ++k) stack.below.push_back(stack.below.back() + sketch.by_age(age_of(sketch, k)));
  return stack;
}

LayerChance chance_of(const Stack& stack, const SheetSketch& sketch, int layer) {
  const auto normal = [&](std::uint64_t draw) {
    return clipped_normal(stack.random, 4 * static_cast<std::uint64_t>(layer) + draw);
  };
  return {sketch.divergence * layer + sketch.turn_jitter * normal(0), 1 + sketch.outline_jitter * normal(1),
          sketch.stray * glm::dvec2(normal(2), normal(3))};
}

double thickness_at(const Stack& stack, const SheetSketch& sketch, double radius) {
  return sketch.thickness(std::min(1.0, radius / stack.reach));
}

/// What room all layers leave at a distance from the axis, metres.
double room_at(const Stack& stack, const SheetSketch& sketch, double radius) {
  return height_at(sketch.outer, radius) - height_at(sketch.inner, radius) -
         thickness_at(stack, sketch, radius) * stack.below.back();
}

/// The height of a layer's underside.
double base_of(const Stack& stack, const SheetSketch& sketch, int layer, double radius) {
  const double gap = sketch.count > 1 ? room_at(stack, sketch, radius) / (sketch.count - 1) : 0;
  return height_at(sketch.inner, radius) +
         thickness_at(stack, sketch, radius) * stack.below[static_cast<std::size_t>(layer)] + layer * gap;
}

bool is_aligned(const SheetSketch& sketch) {
  return sketch.stray == 0 && sketch.outline_jitter == 0 && sketch.turn_jitter == 0 && sketch.divergence == 0;
}

constexpr int radii = 100;  // distances from the axis at which the room is asked for

/// How far flat facets may leave the curved layers, metres. Those of aligned ones lie over each other.
double sag_of(const Stack& stack, const SheetSketch& sketch) {
  if (is_aligned(sketch)) return 0;
  const double edge = 1.6 * stack.reach / (stack.rings - 1), turn = pi / stack.around,
               wave = sketch.ruffle.waves * turn;
  double bent = 0, steep = 0;
  for (int i = 0; i <= radii; ++i) {
    const double r = stack.reach * i / radii, before = std::max(0.0, r - edge / 2);
    for (const int layer : {0, sketch.count - 1}) {
      const double low = base_of(stack, sketch, layer, before), high = base_of(stack, sketch, layer, r + edge / 2);
      bent =
          std::max(bent, std::fabs(0.5 * (low + high) - base_of(stack, sketch, layer, 0.5 * (before + r + edge / 2))));
      steep = std::max(steep, std::fabs(high - low) / edge);
    }
  }
  return bent + steep * stack.reach * turn * turn / 2 +
         sketch.ruffle.height * (wave * wave / 2 + edge * edge / (4 * stack.reach * stack.reach));
}

void check_room(const Template& fruit, const SheetSketch& sketch, const Stack& stack) {
  const double needed = (sketch.count - 1) * (sketch.gap + sag_of(stack, sketch));
  for (int i = 0; i <= radii; ++i) {
    if (room_at(stack, sketch, stack.reach * i / radii) < needed)
      refuse_entry(fruit, "sheets", sketch.name, "so many layers have no room",
                   "make them fewer or thinner, or the two curves further apart");
  }
}

/// How much the ground lifts all layers there: most at the rim.
double wave_at(const Stack& stack, const SheetSketch& sketch, const glm::dvec2& ground) {
  if (sketch.ruffle.height == 0) return 0;
  const double share = glm::length(ground) / stack.reach;
  if (share < 1e-9) return 0;
  return sketch.ruffle.height * share * share *
         (0.5 + 0.5 * reproducible::sin(sketch.ruffle.waves * angle_of(ground) + stack.phase));
}

/// A vertex of a layer: where on the outline, how far out, and on which face.
struct LayerPlace {
  int spoke = 0;
  double share = 0;  ///< of the way from its middle to the rim
  bool top = false, pole = false;
};

void append_vertex(SweptGrid& grid, const Stack& stack, const SheetSketch& sketch, int layer, const LayerChance& chance,
                   const LayerPlace& place) {
  const auto i = static_cast<std::size_t>(place.spoke);
  const glm::dvec2 turn = direction_of(chance.turn), d = stack.outline.direction[i];
  const glm::dvec2 towards{d.x * turn.x - d.y * turn.y, d.x * turn.y + d.y * turn.x};
  const double rim = stack.reach * chance.size * stack.outline.radius[i];
  const glm::dvec2 ground = chance.shift + (place.pole ? 0 : place.share * rim) * towards;
  const double radius = glm::length(ground);
  const double thick = thickness_at(stack, sketch, radius) * sketch.by_age(age_of(sketch, layer));
  const double middle = base_of(stack, sketch, layer, radius) + 0.5 * thick;
  // The rim is round.
  const double inwards = std::clamp(2 * (1 - place.share) * rim / thick, 0.0, 1.0);
  const double half = 0.5 * thick * std::max(0.2, std::sqrt(inwards * (2 - inwards)));
  const double height = middle + (place.top ? half : -half) + wave_at(stack, sketch, ground);
  grid.position.emplace_back(ground.x, height, -ground.y);
  grid.along.push_back(place.share);
  grid.around.push_back(place.pole ? 0 : stack.outline.share[i]);
  grid.is_pole.push_back(place.pole ? 1 : 0);
  grid.fold.push_back(0);
  grid.depth.push_back(1);
  grid.turn.emplace_back(age_of(sketch, layer));
}

/// From the middle of the underside over the rim to the middle of the top.
SweptGrid stacked_layer(const Stack& stack, const SheetSketch& sketch, int layer) {
  SweptGrid grid;
  const LayerChance chance = chance_of(stack, sketch, layer);
  const int rings = 2 * stack.rings;
  for (int ring = 0; ring < rings; ++ring) {
    const bool top = ring >= stack.rings;
    const double step = static_cast<double>(top ? rings - 1 - ring : ring) / (stack.rings - 1);
    const double share = step * (1.6 - 0.6 * step);  // rings lie closer near the rim
    const int vertices = ring == 0 || ring == rings - 1 ? 1 : stack.around;
    for (int i = 0; i < vertices; ++i)
      append_vertex(grid, stack, sketch, layer, chance, {i, share, top, vertices == 1});
  }
  grid.triangle = grid_triangles({stack.around, rings, true, true, false});
  return grid;
}

}  // namespace

SheetShell stack_shell(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options) {
  const Stack stack = stack_of(fruit, sketch, options);
  check_room(fruit, sketch, stack);
  return [stack, &sketch](int layer) { return stacked_layer(stack, sketch, layer); };
}

}  // namespace pomona
