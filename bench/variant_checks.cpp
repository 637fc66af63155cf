#include "bench/variant_checks.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <glm/geometric.hpp>

#include "generator/surface/shells.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/unpainted.h"
#include "generator/variation/vary.h"

namespace pomona::bench {

namespace {

/// The processor time of this thread.
double processor_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

bool has_crossing_curve(const SurfaceSketch& sketch) {
  const auto crosses = [](const Curve& curve) { return !curve.points.empty() && !is_simple(curve); };
  return crosses(sketch.vertical) || std::any_of(sketch.horizontal.begin(), sketch.horizontal.end(), crosses);
}

int open_shells_of(const DiffusionSurfaces& surfaces) {
  const Shells shells = find_shells(surfaces);
  return static_cast<int>(std::count(shells.closed.begin(), shells.closed.end(), 0));
}

std::vector<std::ptrdiff_t> triangles_of(const DiffusionSurfaces& surfaces) {
  std::vector<std::ptrdiff_t> counts(surfaces.surface_names.size(), 0);
  for (const std::int32_t surface : surfaces.surface) ++counts[static_cast<std::size_t>(surface)];
  return counts;
}

std::ptrdiff_t loops_of(const SurfaceSketch& sketch) {
  return std::count_if(sketch.horizontal.begin(), sketch.horizontal.end(),
                       [](const Curve& loop) { return !loop.points.empty(); });
}

/// At most 1024 vertices, evenly spread over the indices.
std::vector<glm::vec3> some_of(const std::vector<glm::vec3>& positions) {
  const std::size_t step = (positions.size() + 1023) / 1024;
  std::vector<glm::vec3> some;
  for (std::size_t i = 0; i < positions.size(); i += step) some.push_back(positions[i]);
  return some;
}

}  // namespace

VariantChecks::VariantChecks(const Template& fruit, const VariantSettings& settings)
    : fruit_(fruit), variation_(fruit), settings_(settings) {
  const DiffusionSurfaces as_drawn = sweep(unpainted(fruit));
  drawn_ = settings.how.folds ? sweep(unpainted(with_folds(fruit, *settings.how.folds))) : as_drawn;
  drawn_crossings_ = kinds_of(as_drawn, crossing_triangles(as_drawn));
  open_shells_ = open_shells_of(as_drawn);
  size_ = glm::length(bounds_of(as_drawn).size());
}

VariantFacts VariantChecks::facts(int seed) const {
  const VariantKey key{static_cast<std::uint64_t>(seed), 0};
  VariantFacts facts;
  const double start = processor_milliseconds();
  const Variant variant = variation_.draw(key, settings_.how);
  const double varied = processor_milliseconds();
  const DiffusionSurfaces swept = sweep(unpainted(variant.fruit));
  facts.vary_milliseconds = varied - start;
  facts.sweep_milliseconds = processor_milliseconds() - varied;

  facts.crossing_curves = crossing_curves(variant.fruit);
  facts.crossings = new_crossings(swept);
  facts.open_shells = std::max(0, open_shells_of(swept) - open_shells_);
  const DiffusionSurfaces same_counts = swept.triangle == drawn_.triangle ? swept : with_drawn_counts(seed);
  facts.connected_as_drawn = same_counts.triangle == drawn_.triangle && same_counts.surface == drawn_.surface &&
                             has_loops_as_drawn(variant.fruit, swept);
  facts.some_positions = some_of(same_counts.position);
  const glm::dvec3 sides = bounds_of(swept).size();
  facts.size = std::log(glm::length(sides));
  facts.slenderness = std::log(sides.y / std::max(sides.x, sides.z));
  facts.folds = variant.folds;
  facts.loops = loop_shapes(variant.fruit);
  return facts;
}

std::vector<glm::vec3> VariantChecks::positions(int seed) const { return with_drawn_counts(seed).position; }

DiffusionSurfaces VariantChecks::with_drawn_counts(int seed) const {
  VariationOptions how = settings_.how;
  how.drawn_counts = true;
  return sweep(unpainted(variation_.draw({static_cast<std::uint64_t>(seed), 0}, how).fruit));
}

bool VariantChecks::has_loops_as_drawn(const Template& variant, const DiffusionSurfaces& swept) const {
  const bool has_folds = std::holds_alternative<FoldSymmetry>(fruit_.symmetry);
  const Template drawn = has_folds ? with_folds(fruit_, fold_count(variant)) : fruit_;
  const std::vector<std::ptrdiff_t> of_drawn = triangles_of(sweep(unpainted(drawn))), found = triangles_of(swept);
  for (std::size_t s = 0; s < drawn.surfaces.size(); ++s) {
    if (found[s] * loops_of(drawn.surfaces[s]) != of_drawn[s] * loops_of(variant.surfaces[s])) return false;
  }
  return true;
}

std::vector<std::string> VariantChecks::crossing_curves(const Template& variant) const {
  std::vector<std::string> names;
  for (std::size_t s = 0; s < variant.surfaces.size(); ++s) {
    if (has_crossing_curve(fruit_.surfaces[s])) continue;
    if (has_crossing_curve(variant.surfaces[s])) names.push_back(variant.surfaces[s].name);
  }
  return names;
}

std::map<std::string, int> VariantChecks::new_crossings(const DiffusionSurfaces& variant) const {
  const auto name = [&](int surface) { return variant.surface_names[static_cast<std::size_t>(surface)]; };
  std::map<std::string, int> found;
  for (const CrossingTriangles& crossing : crossing_triangles(variant)) {
    const CrossingKind kind = kind_of(variant, crossing);
    if (drawn_crossings_.contains(kind)) continue;
    const auto& [first, second, same_piece] = kind;
    ++found[name(first) + " x " + (same_piece ? "itself" : name(second))];
  }
  return found;
}

}  // namespace pomona::bench
