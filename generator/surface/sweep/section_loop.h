// A horizontal curve as the spokes of a sweep around the axis.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/curve.h"

namespace pomona {

/// One spoke per vertex around: its direction seen from above (unit; x = +X, y = -Z), the loop's radius there
/// over the reference radius, where it lies around the loop, or around its fold, 0..1, and the fold it begins.
struct SectionLoop {
  std::vector<glm::dvec2> direction;
  std::vector<double> radius;
  std::vector<double> share;
  std::vector<int> fold;  ///< from 0; 0 where there are none
};

/// The reason why a loop cannot be swept. The caller adds which loop it is.
struct BadLoop : std::runtime_error {
  BadLoop(const std::string& what, std::string remedy) : std::runtime_error(what), hint(std::move(remedy)) {}
  std::string hint;
};

/// The loop in `count` spokes, evenly spaced by arc length from where it meets angle 0.
/// \throws BadLoop unless it surrounds the axis.
SectionLoop sampled_loop(const Curve& loop, int count, double reference_radius);

/// The loop in `count_per_fold` spokes a fold, the first on its fold line.
/// \throws BadLoop unless it surrounds the axis and crosses every fold line once.
SectionLoop sampled_folds(const Curve& loop, std::span<const double> fold_angles, int count_per_fold,
                          double reference_radius);

/// Loops at places along a vertical curve, all in as many spokes; between two of them they blend.
struct SectionStops {
  std::vector<double> at;         ///< ascending; as many as loops, or none for a single loop
  std::vector<SectionLoop> loop;  ///< at least one
};

/// The loop at a share of the vertical curve: angle and radius of each spoke pass gently from one stop to the next, so
/// that it surrounds the axis as the stops do.
SectionLoop loop_at(const SectionStops& stops, double share);

/// (cos, sin), exact at quarter turns.
glm::dvec2 direction_of(double angle);

/// The angle of a plan position, -pi..pi.
double angle_of(const glm::dvec2& point);

}  // namespace pomona
