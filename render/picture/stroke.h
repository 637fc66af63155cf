// Strokes: lines of varying width, as a pen or a brush draws them.
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
  double weighted_side = 0;  ///< +1 or -1: the object is on the left or right; the line is thicker away from the light
  std::uint32_t key = 0;     ///< selects the random tremble of the hand

  // For lines on objects in a scene; each is empty, or has one entry per point.
  std::vector<double> heft{};          ///< factor of the width
  std::vector<glm::dvec3> place{};     ///< position on the object, in wavelengths: the tremble moves with the object
  std::vector<glm::dvec2> outwards{};  ///< direction away from the object; used instead of weighted_side
};

struct PenOptions {
  double width = 3;                 ///< usual largest width, pixels
  double wander = 0.35;             ///< variation of the width by the hand, as a share of it
  double wavelength = 70;           ///< wavelength of that variation, pixels
  double taper = 40;                ///< length over which an end becomes thin, pixels; at most a third of the line
  double sway = 0.4;                ///< largest distance of the drawn centre line from the true one, pixels
  double min = 0;                   ///< smallest width between the ends, pixels
  glm::dvec2 from_light{0.6, 0.8};  ///< direction in which the light travels: lines on that side are thicker
};

/// The line as a hand draws it: resampled, smoothed, tapered, with a trembling width. Closed lines overlap a little at
/// their ends. Strokes as in [Northrup & Markosian 2000].
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
