// Strokes: lines of varying width, as a pen or a brush leaves them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/picture/stroke_point.h"

namespace pomona {

/// A line to be drawn: places in pixels, y down. For a closed one the first point is not repeated.
struct PenLine {
  std::vector<glm::dvec2> points;
  std::vector<double> opacity;  ///< one per point, 0..1
  bool closed = false;
  double weighted_side = 0;  ///< +1 or -1: the object lies to the left or right, and the line is thicker away
                             ///< from the light; 0 = thickness knows no side
  std::uint32_t key = 0;     ///< picks the hand's tremble

  // Of lines on things that turn before the eye; each empty, or one per point.
  std::vector<double> heft{};          ///< times the width
  std::vector<glm::dvec3> place{};     ///< on the thing, in wavelengths: the tremble is tied to it and moves with it
  std::vector<glm::dvec2> outwards{};  ///< which way the object ends; takes the place of weighted_side
};

struct PenOptions {
  double width = 3;                 ///< pixels, at its usual widest
  double wander = 0.35;             ///< share of the width the hand varies
  double wavelength = 70;           ///< pixels, of that variation
  double taper = 40;                ///< pixels over which an end runs out, at most a third of the line
  double sway = 0.4;                ///< pixels the centre line leaves the true one by, at most
  double least = 0;                 ///< pixels: between its ends no line gets thinner
  glm::dvec2 from_light{0.6, 0.8};  ///< where the light goes: lines are heavier there
};

/// The line as a hand draws it: resampled, smoothed, tapered, its width trembling; closed lines overlap a little
/// where the pen comes round. Strokes as in
/// [Northrup & Markosian 2000].
std::vector<StrokePoint> drawn(const PenLine& line, const PenOptions& options);

/// Ink on a picture, or on some of its rows: 16 fixed samples a pixel, so that what is drawn twice is as dark as what
/// is drawn once. A pixel has the same ink whatever the rows around it.
class InkLayer {
 public:
  InkLayer(int width, int height) : InkLayer(width, PictureRows{0, height}) {}
  InkLayer(int width, PictureRows rows);

  void draw(const std::vector<StrokePoint>& stroke);

  /// Share of the pixel that the ink hides, 0..1.
  double at(int x, int y) const;

 private:
  std::size_t index_of(int x, int y) const { return static_cast<std::size_t>(y - rows_.from) * width_ + x; }
  void draw_piece(const StrokePoint& a, const StrokePoint& b);

  int width_;
  PictureRows rows_;
  std::vector<std::uint16_t> samples_;
  std::vector<float> opacity_;
};

}  // namespace pomona
