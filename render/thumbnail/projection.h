// Projects a scene's points onto a square picture.
#pragma once

#include "generator/scene/scene.h"
#include "render/picture/view_frame.h"

namespace pomona {

/// A place on the picture. `nearness` is one over the distance along the line of sight; it is linear on the picture
/// across a triangle.
struct ProjectedPoint {
  double x = 0, y = 0;  ///< samples, from the upper left
  double nearness = 0;  ///< per metre
};

class Projection {
 public:
  /// \param side of the picture, samples.
  Projection(const View& view, int side);

  ProjectedPoint operator()(const glm::dvec3& point) const;
  const ViewFrame& frame() const { return frame_; }

 private:
  ViewFrame frame_;
  glm::dvec3 eye_;
  double middle_;  ///< samples
  double scale_;   ///< samples per unit of slope
};

}  // namespace pomona
