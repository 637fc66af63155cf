// Texture detail that follows a fruit's surfaces (paper, section 6): patterns in coordinates from its guides.
// shaders/detail.glsl has the same formulas; a test compares them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/cut/section/detail_guide.h"
#include "generator/template/detail_sketch.h"

namespace pomona {

/// A place in a pattern whose features are of size 1.
struct PatternPlace {
  glm::dvec3 point{0};
  double squeeze = 1;  ///< features are this many times finer here than `size`, as rays are near the core
};

/// With p the position, v = to_skin the way to the foot on the skin, l the layer's depth, w = size, h = length:
///   none     p / w
///   to_skin  (p + v) / w - v / h: the foot stays the same along the way to the skin, so that h alone counts there
///   along    (reach - l) / w out along p's azimuth, and s / h upwards: l and the azimuth stay the same along layers
///   around   l / w and s / w, and the azimuth on a circle of reach / h
/// s is about the length of the skin from the middle of the fruit up to the foot.
PatternPlace pattern_place(const DetailSketch& detail, const glm::dvec3& position, const DetailGuide& guide);

/// The effect of a pattern at a place, before amounts.
struct PatternValue {
  double share = 0;  ///< share of the detail's amount, 0..1
  double tone = 0;   ///< change of OKLab lightness, times the amount: -1..1
  Color shown{0};    ///< the example's colour; else black
};

/// A place of a fruit whose pattern is wanted.
struct PatternSpot {
  glm::dvec3 position{0};  ///< in the fruit's own frame, metres
  DetailGuide guide = {};
  double footprint = 0;  ///< size of a pixel or texel there, metres; 0 for a point
};

/// A detail, prepared for many places.
class Pattern {
 public:
  /// \param like a detail whose shape is reused if the pattern is the same, which saves a millisecond.
  explicit Pattern(const DetailSketch& detail, std::uint32_t seed, const Pattern* like = nullptr);

  /// Between 1/4 and 1/2 of (footprint times squeeze over size) the pattern fades into its mean; examples, whose marks
  /// are finer than their size, go over into coarser tiles.
  PatternValue operator()(const glm::dvec3& position, const DetailGuide& guide, double footprint) const;

  /// The same at many places, several times as fast.
  std::vector<PatternValue> operator()(std::span<const PatternSpot> spots) const;

  /// Numbers that the GPU needs, too (shaders/detail.glsl).
  struct Shape {
    double threshold = 0;  ///< value of the noise above which there is a line
    double ramp = 1;       ///< half the width of the transition
    double pitch = 1;      ///< cells per size, for dots
    PatternValue mean;
    std::uint32_t seed = 0;
    glm::dvec3 aside{0};  ///< of examples: where in the tile the fruit's origin lies
  };
  const Shape& shape() const { return shape_; }
  const DetailSketch& detail() const { return detail_; }

 private:
  std::vector<PatternValue> at(std::vector<glm::dvec3> points, std::span<const double> fine) const;
  std::vector<PatternValue> of_lines(std::span<const glm::dvec3> points, std::span<const double> fine) const;
  PatternValue of_cells(const glm::dvec3& point) const;
  PatternValue of_example(const glm::dvec3& point, double cycles) const;

  DetailSketch detail_;
  Shape shape_;
};

}  // namespace pomona
