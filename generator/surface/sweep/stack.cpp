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

/// The two faces of every layer are functions of the ground alone, one over the other; so where a layer ends does not
/// matter.
class Stack {
 public:
  Stack(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options)
      : fruit_(fruit),
        sketch_(sketch),
        around_(refined(sketch.around, options.detail, 8)),
        rings_(refined(sketch.along, options.detail, 3)),
        reach_(std::min(sketch.inner.points.back().x, sketch.outer.points.back().x)),
        random_(options.key, "sheet/" + sketch.name),
        phase_(2 * pi * random_.uniform(0)),
        outline_(outline()) {
    below_.push_back(0);
    for (int k = 0; k < sketch.count; ++k) below_.push_back(below_.back() + sketch.by_age(age(k)));
    check();
  }

  /// From the middle of the underside over the rim to the middle of the top.
  SweptGrid shell(int layer) const {
    SweptGrid grid;
    const LayerChance chance = chance_of(layer);
    for (int ring = 0; ring < 2 * rings_; ++ring) {
      const bool top = ring >= rings_;
      const double step = static_cast<double>(top ? 2 * rings_ - 1 - ring : ring) / (rings_ - 1);
      const double share = step * (1.6 - 0.6 * step);  // rings lie closer near the rim
      const int vertices = ring == 0 || ring == 2 * rings_ - 1 ? 1 : around_;
      for (int i = 0; i < vertices; ++i) append(grid, layer, chance, share, i, top, vertices == 1);
    }
    grid.triangle = grid_triangles({around_, 2 * rings_, true, true, false});
    return grid;
  }

 private:
  double age(int layer) const { return sketch_.count > 1 ? layer / (sketch_.count - 1.0) : 0; }

  SectionLoop outline() const {
    Curve loop = sketch_.loop;
    if (loop.points.empty()) {
      constexpr int points = 360;
      for (int i = 0; i < points; ++i) loop.points.push_back(direction_of(2 * pi * i / points));
      loop.closed = true;
    }
    double farthest = 0;
    for (const glm::dvec2& p : loop.points) farthest = std::max(farthest, glm::length(p));
    try {
      return sampled_loop(loop, around_, farthest);
    } catch (const BadLoop& bad) {
      refuse_entry(fruit_, "sheets", sketch_.name, bad.what(), bad.hint);
    }
  }

  LayerChance chance_of(int layer) const {
    const auto normal = [&](std::uint64_t draw) {
      return clipped_normal(random_, 4 * static_cast<std::uint64_t>(layer) + draw);
    };
    return {sketch_.divergence * layer + sketch_.turn_jitter * normal(0), 1 + sketch_.outline_jitter * normal(1),
            sketch_.stray * glm::dvec2(normal(2), normal(3))};
  }

  double thickness(double radius) const { return sketch_.thickness(std::min(1.0, radius / reach_)); }

  /// What room all layers leave at a distance from the axis, metres.
  double room(double radius) const {
    return height_at(sketch_.outer, radius) - height_at(sketch_.inner, radius) - thickness(radius) * below_.back();
  }

  /// The height of a layer's underside.
  double base(int layer, double radius) const {
    const double gap = sketch_.count > 1 ? room(radius) / (sketch_.count - 1) : 0;
    return height_at(sketch_.inner, radius) + thickness(radius) * below_[static_cast<std::size_t>(layer)] + layer * gap;
  }

  bool aligned() const {
    return sketch_.stray == 0 && sketch_.outline_jitter == 0 && sketch_.turn_jitter == 0 && sketch_.divergence == 0;
  }

  /// How far flat facets may leave the curved layers, metres. Those of aligned ones lie over each other.
  double sag() const {
    if (aligned()) return 0;
    const double edge = 1.6 * reach_ / (rings_ - 1), turn = pi / around_, wave = sketch_.ruffle.waves * turn;
    double bent = 0, steep = 0;
    for (int i = 0; i <= radii; ++i) {
      const double r = reach_ * i / radii, before = std::max(0.0, r - edge / 2);
      for (const int layer : {0, sketch_.count - 1}) {
        const double low = base(layer, before), high = base(layer, r + edge / 2);
        bent = std::max(bent, std::fabs(0.5 * (low + high) - base(layer, 0.5 * (before + r + edge / 2))));
        steep = std::max(steep, std::fabs(high - low) / edge);
      }
    }
    return bent + steep * reach_ * turn * turn / 2 +
           sketch_.ruffle.height * (wave * wave / 2 + edge * edge / (4 * reach_ * reach_));
  }

  void check() const {
    const double needed = (sketch_.count - 1) * (sketch_.gap + sag());
    for (int i = 0; i <= radii; ++i) {
      if (room(reach_ * i / radii) < needed)
        refuse_entry(fruit_, "sheets", sketch_.name, "so many layers have no room",
                     "make them fewer or thinner, or the two curves further apart");
    }
  }

  void append(SweptGrid& grid, int layer, const LayerChance& chance, double share, int spoke, bool top,
              bool pole) const {
    const auto i = static_cast<std::size_t>(spoke);
    const glm::dvec2 turn = direction_of(chance.turn), d = outline_.direction[i];
    const glm::dvec2 towards{d.x * turn.x - d.y * turn.y, d.x * turn.y + d.y * turn.x};
    const double rim = reach_ * chance.size * outline_.radius[i];
    const glm::dvec2 ground = chance.shift + (pole ? 0 : share * rim) * towards;
    const double radius = glm::length(ground);
    const double thick = thickness(radius) * sketch_.by_age(age(layer));
    const double middle = base(layer, radius) + 0.5 * thick;
    // The rim is round.
    const double inwards = std::clamp(2 * (1 - share) * rim / thick, 0.0, 1.0);
    const double half = 0.5 * thick * std::max(0.2, std::sqrt(inwards * (2 - inwards)));
    const double height = middle + (top ? half : -half) + wave(ground);
    grid.position.emplace_back(ground.x, height, -ground.y);
    grid.along.push_back(share);
    grid.around.push_back(pole ? 0 : outline_.share[i]);
    grid.is_pole.push_back(pole ? 1 : 0);
    grid.fold.push_back(0);
    grid.depth.push_back(1);
    grid.turn.emplace_back(age(layer));
  }

  /// How much the ground lifts all layers there: most at the rim.
  double wave(const glm::dvec2& ground) const {
    if (sketch_.ruffle.height == 0) return 0;
    const double share = glm::length(ground) / reach_;
    if (share < 1e-9) return 0;
    return sketch_.ruffle.height * share * share *
           (0.5 + 0.5 * reproducible::sin(sketch_.ruffle.waves * angle_of(ground) + phase_));
  }

  static constexpr int radii = 100;  // distances from the axis at which the room is asked for

  const Template& fruit_;
  const SheetSketch& sketch_;
  int around_ = 0, rings_ = 0;  ///< vertices around, and from the axis to the rim
  double reach_ = 0;            ///< metres: how far the outline's farthest point lies from the axis
  RandomStream random_;
  double phase_ = 0;
  SectionLoop outline_;
  std::vector<double> below_;  ///< by layer: thicknesses below it, in thicknesses
};

}  // namespace

std::vector<SweptGrid> stack_shells(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options) {
  const Stack stack(fruit, sketch, options);
  std::vector<SweptGrid> shells;
  for (int k = 0; k < sketch.count; ++k) shells.push_back(stack.shell(k));
  return shells;
}

}  // namespace pomona
