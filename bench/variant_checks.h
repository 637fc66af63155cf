// Checks of a variant: does anything cross, is it closed, is it connected as drawn?
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bench/loop_statistics.h"
#include "generator/surface/crossings.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"
#include "generator/variation/variation.h"

namespace pomona::bench {

/// Seeds 1 to `count`, index 0.
struct VariantSettings {
  int count = 1000;
  VariationOptions how;
};

/// The findings of one variant.
struct VariantFacts {
  std::vector<std::string> crossing_curves;  ///< surfaces with a curve that meets itself and does not as drawn
  std::map<std::string, int> crossings;      ///< "skin x core": pairs of triangles, where the drawing has none
  int open_shells = 0;                       ///< more than the drawing has
  /// With the drawing's counts: the same triangles. With other counts: as many for each loop as the drawn folds have,
  /// in turn.
  bool connected_as_drawn = true;
  double size = 0, slenderness = 0;  ///< logarithms: of the bounds' diagonal in metres, of height over greater width
  std::vector<FoldReport> folds;
  std::vector<LoopShape> loops;
  std::vector<glm::vec3> some_positions;                 ///< at most 1024 vertices, of the variant with drawn counts
  double vary_milliseconds = 0, sweep_milliseconds = 0;  ///< processor time
};

/// A drawing and its own findings, to compare variants with.
class VariantChecks {
 public:
  VariantChecks(const Template& fruit, const VariantSettings& settings);

  VariantFacts facts(int seed) const;

  /// Every vertex of a variant with as many folds and surfaces as drawn.
  std::vector<glm::vec3> positions(int seed) const;

  std::size_t triangle_count() const { return drawn_.triangle_count(); }
  int open_shells() const { return open_shells_; }
  double size() const { return size_; }  ///< metres: the diagonal of the drawing's bounds

 private:
  DiffusionSurfaces with_drawn_counts(int seed) const;
  bool has_loops_as_drawn(const Template& variant, const DiffusionSurfaces& swept) const;
  std::vector<std::string> crossing_curves(const Template& variant) const;
  std::map<std::string, int> new_crossings(const DiffusionSurfaces& variant) const;

  const Template& fruit_;
  Variation variation_;
  VariantSettings settings_;
  DiffusionSurfaces drawn_;  ///< with as many folds as the variants
  std::set<CrossingKind> drawn_crossings_;
  int open_shells_ = 0;
  double size_ = 0;
};

}  // namespace pomona::bench
