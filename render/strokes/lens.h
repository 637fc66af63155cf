// The projection of a scene's view, in double precision, with the same bits on every machine.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/scene/scene.h"
#include "render/picture/view_frame.h"

namespace pomona {

class Lens {
 public:
  /// \param width,height of the picture, pixels.
  Lens(const View& view, int width, int height);

  /// The projection of a point of the scene: pixels (y down), and its distance along the line of sight, metres.
  glm::dvec3 seen(const glm::dvec3& point) const;

  /// The inverse.
  glm::dvec3 in_scene(const glm::dvec2& pixel, double distance) const;

  /// The projection of a direction at `point`: of length 1, y down; (0, 0) if it points at the eye.
  glm::dvec2 seen_direction(const glm::dvec3& point, const glm::dvec3& direction) const;

  /// Size of a pixel at that distance, metres.
  double pixel_size(double distance) const { return distance / pixels_; }

  const glm::dvec3& eye() const { return eye_; }
  const ViewFrame& frame() const { return frame_; }
  double nearest() const { return nearest_; }  ///< distance of the near plane, metres
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  ViewFrame frame_;
  glm::dvec3 eye_;
  double pixels_;  // per metre at one metre's distance
  double nearest_;
  int width_, height_;
};

}  // namespace pomona
